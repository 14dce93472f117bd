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
///              tolerance. Triangles follow their face as the worst of those beside them did at first, with kGrowth more of the
///              angle between normals and of the distance between chords and face, but for the least of the limits; the same
///              holds of chords and curves. Compared with what was at first, however many changes are made, none adds up.
///              Angles of triangles do not get below kLeastFacetAngle, or not smaller
/// Units        model units
/// Threads      one at a time: surfaces and curves are its own
class BoundaryGeometry
{
public:
    /// Facets may get angles down to this one, degrees; smaller ones do not get smaller.
    static constexpr double kLeastFacetAngle = 20.0;
    static constexpr double kCosineOfLeastFacetAngle = 0.93969262078590843;
    /// Of angles between normals, and of distances between chords and exact geometry.
    static constexpr double kGrowth = 1.25;

    /// `first` are the nodes as they are at first. Chords do not get further than `maxSag` from the exact geometry unless they
    /// are; 0 for no limit.
    BoundaryGeometry(const BrepModel& model, const TetComplex& complex,
                     const IdVector<NodeId, MeshNode>& first, double maxSag);

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
    [[nodiscard]] bool allowsSwap(const std::array<FacetId, 2>& facets,
                                  const std::array<FacetNodes, 2>& after);
    void commitSwap(const std::array<FacetId, 2>& facets, const std::array<FacetNodes, 2>& after);

private:
    /// How well facets follow their face.
    struct Fidelity
    {
        double agreement = 1.0;       ///< least cosine between normals
        double sag = 0.0;             ///< of chords, model units
        double cosineOfLeast = -1.0;  ///< of the smallest angle of a facet
    };
    struct Corners
    {
        std::array<SurfaceCorner, 3> corner;
        double side =
            0.0;  ///< 1 if the facet's normal is along the surface's, -1 against; 0 while nothing is known
    };

    [[nodiscard]] const Surface& surface(std::uint32_t face) const;
    [[nodiscard]] const Curve& curve(std::uint32_t edge) const;
    [[nodiscard]] bool isPlane(std::uint32_t face) const;
    [[nodiscard]] SurfaceCorner cornerAt(std::uint32_t face, Vec2 uv) const;
    [[nodiscard]] SurfaceCorner find(FacetId f, std::size_t k, const Corners& known) const;
    const Corners& cornersOf(FacetId f);
    bool moveOnFace(const MeshNode& node, const Vec3& target, BoundaryMove& move) const;
    bool moveOnCurve(const MeshNode& node, const Vec3& target, BoundaryMove& move) const;
    bool findCorners(BoundaryMove& move);
    [[nodiscard]] std::array<Vec3, 3> pointsOf(const FacetNodes& nodes) const;
    void judge(const std::array<Vec3, 3>& points, const Corners& corners, Fidelity& fidelity) const;
    /// Takes in what a facet's limits are and how small its angles are now.
    void includeLimits(FacetId f, Fidelity& limits);
    [[nodiscard]] bool isWithin(const Fidelity& after, const Fidelity& limits) const;
    [[nodiscard]] double largestSag(double first) const;
    [[nodiscard]] std::optional<Vec3> tangentAt(std::uint32_t edge, double t) const;
    [[nodiscard]] std::optional<double> parameterOn(std::uint32_t edge, const MeshNode& node,
                                                    double near) const;
    [[nodiscard]] std::optional<double> sagBeside(std::uint32_t edge, NodeId n, const MeshNode& place,
                                                  bool isAtFirst) const;
    [[nodiscard]] bool keepsChords(const BoundaryMove& move) const;
    [[nodiscard]] bool arrange(const std::array<FacetId, 2>& facets, const FacetNodes& after,
                               Corners& corners);

    const BrepModel& model_;
    const TetComplex& complex_;
    const IdVector<NodeId, MeshNode>& first_;
    double maxSag_;
    mutable std::vector<std::unique_ptr<Surface>> surfaces_;  ///< clones, made when asked
    mutable std::vector<std::unique_ptr<Curve>> curves_;
    IdVector<FacetId, Corners> corners_;
    IdVector<FacetId, Fidelity> atFirst_;  ///< of facets whose corners are known
};

}  // namespace mesher
