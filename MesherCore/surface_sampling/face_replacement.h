#pragma once

#include "surface_sampling/face_mesh.h"

#include <array>
#include <span>
#include <vector>

namespace mesher {

struct FacetCorners
{
    std::array<VertexId, 3> v;
    std::array<Vec2, 3> uv;
};

/// A side between new facets, or at the border, that is a segment.
struct NewSegmentSide
{
    VertexId a;
    VertexId b;
    SegmentId segment;
};

/// Replaces triangles by others that fill the same polygon: sides are matched by their corners. Corners that no triangle is
/// left at are to be removed by the caller.
/// Requires   the sides of `added` without a partner among them are those of `removed`, or named by `segments`
/// Cost       quadratic in the numbers handed in, which are small
void replaceTriangles(FaceMesh& mesh, std::span<const TriangleId> removed,
                      std::span<const FacetCorners> added, std::span<const NewSegmentSide> segments,
                      std::vector<TriangleId>& made);

/// The removal of a vertex that is free, evaluated before it is made: the polygon around it is cut into ears, those first whose
/// circle is the emptiest.
class FaceVertexRemoval
{
public:
    FaceVertexRemoval(FaceMesh& mesh, const FaceGeometry& geometry) : mesh_(mesh), geometry_(geometry) {}

    /// False if the vertex is not free, or no triangulation of its polygon keeps the mesh a manifold that looks to the
    /// surface's side.
    [[nodiscard]] bool evaluate(VertexId v);
    /// Requires   the mesh as it was evaluated
    void commit();
    [[nodiscard]] const std::vector<TriangleId>& made() const { return made_; }

private:
    struct RingCorner
    {
        VertexId v;
        Vec2 uv;
    };

    void collectRing(VertexId v);
    [[nodiscard]] double costOf(std::size_t ear) const;
    [[nodiscard]] FacetCorners cornersOf(std::size_t ear) const;

    FaceMesh& mesh_;
    const FaceGeometry& geometry_;
    VertexId vertex_;
    double leastAgreement_ = 0.0;
    std::vector<TriangleId> removed_;
    std::vector<RingCorner> ring_;
    std::vector<FacetCorners> added_;
    std::vector<TriangleId> made_;
};

}  // namespace mesher
