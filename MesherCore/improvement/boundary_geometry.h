#pragma once

#include "brep/brep_model.h"
#include "improvement/tet_complex.h"

#include <memory>
#include <optional>
#include <vector>

namespace mesher {

/// What the exact surface of a facet's face is at one of its corners.
struct SurfaceCorner
{
    Vec2 parameters;
    Vec3 normal;  ///< unit, along du x dv; zero where the surface has none, as at the apex of a cone
};

/// A node of the boundary at another place of its own entity, evaluated and not yet made.
struct BoundaryMove
{
    NodeId node;
    Vec3 position;
    Vec2 parameters;
    std::vector<SurfaceCorner> corners;  ///< at the node, by the facets there
};

/// The exact curves and faces under the boundary of a mesh, and how well its triangles follow them.
/// Guarantees   nodes are put on points of their own entity, and not off the adjoining faces by more than 1e-7 or the edge's
///              tolerance. No change that is allowed makes the worst of the triangles beside it worse: neither the angle
///              between normals, nor the distance between chords and the exact geometry, nor angles below kLeastFacetAngle.
///              So no face and no curve gets worse on the whole, however many changes are made
/// Units        model units
/// Threads      one at a time: surfaces and curves are its own
class BoundaryGeometry
{
public:
    /// Facets may get angles down to this one, degrees; smaller ones do not get smaller.
    static constexpr double kLeastFacetAngle = 25.0;

    BoundaryGeometry(const BrepModel& model, const TetComplex& complex);

    /// Unit tangent of the curve at a node of an edge; none where it has none.
    [[nodiscard]] std::optional<Vec3> tangent(NodeId n) const;
    /// Unit normal of the surface at a node of a face.
    [[nodiscard]] std::optional<Vec3> normal(NodeId n) const;
    /// The place of a node nearest to a target, approximately for curves. False if there is none, or it is off an adjoining face.
    bool evaluateMove(NodeId n, const Vec3& target, BoundaryMove& move);
    /// Completes the move by its corners.
    [[nodiscard]] bool allows(BoundaryMove& move);
    void commit(const BoundaryMove& move);

    /// Whether two triangles of one face may become others on the same four nodes.
    [[nodiscard]] bool allowsSwap(const std::array<FacetId, 2>& facets, const std::array<FacetNodes, 2>& after);
    void commitSwap(const std::array<FacetId, 2>& facets, const std::array<FacetNodes, 2>& after);

private:
    struct Corners
    {
        std::array<SurfaceCorner, 3> corner;
        double side = 0.0;  ///< 1 if the facet's normal is along the surface's, -1 against; 0 while nothing is known
    };
    /// How well facets follow their face.
    struct Fidelity
    {
        double agreement = 1.0;   ///< least cosine between normals
        double sag = 0.0;         ///< of chords, model units
        double leastAngle = 4.0;  ///< radians
    };

    [[nodiscard]] const Surface& surface(std::uint32_t face) const;
    [[nodiscard]] const Curve& curve(std::uint32_t edge) const;
    [[nodiscard]] bool isPlane(std::uint32_t face) const;
    [[nodiscard]] SurfaceCorner cornerAt(std::uint32_t face, Vec2 uv) const;
    [[nodiscard]] SurfaceCorner find(FacetId f, std::size_t k) const;
    const Corners& cornersOf(FacetId f);
    bool moveOnFace(const MeshNode& node, const Vec3& target, BoundaryMove& move) const;
    bool moveOnCurve(const MeshNode& node, const Vec3& target, BoundaryMove& move) const;
    bool findCorners(BoundaryMove& move);
    void judge(const std::array<Vec3, 3>& points, const Corners& corners, Fidelity& fidelity) const;
    [[nodiscard]] bool isWorse(const Fidelity& after, const Fidelity& before) const;
    [[nodiscard]] std::optional<Vec3> tangentAt(std::uint32_t edge, double t) const;
    [[nodiscard]] std::optional<double> parameterOn(std::uint32_t edge, NodeId n, double near) const;
    [[nodiscard]] bool keepsChords(const BoundaryMove& move) const;
    [[nodiscard]] bool arrange(const std::array<FacetId, 2>& facets, const FacetNodes& after, Corners& corners);

    const BrepModel& model_;
    const TetComplex& complex_;
    mutable std::vector<std::unique_ptr<Surface>> surfaces_;  ///< clones, made when asked
    mutable std::vector<std::unique_ptr<Curve>> curves_;
    IdVector<FacetId, Corners> corners_;
};

}  // namespace mesher
