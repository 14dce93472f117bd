#pragma once

#include "base/id_vector.h"
#include "base/ids.h"
#include "base/indexed_map.h"
#include "base/result.h"
#include "base/vec.h"
#include "delaunay/triangulation2d.h"
#include "mesh/surface_mesh.h"
#include "surface_sampling/face_geometry.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <utility>
#include <vector>

namespace mesher {

/// A vertex of the mesh of one face.
struct FaceVertex
{
    Vec3 position;
    Vec3 normal;                                            ///< of the surface, unit; zero where it has none
    double size = std::numeric_limits<double>::infinity();  ///< the edge length wanted here
    double curvatureRadius = std::numeric_limits<double>::infinity();
    TriangleId triangle;  ///< one of those around it
    /// In the mesh of the model; invalid as long as only this face knows the vertex. Several vertices have one node where the
    /// face touches itself in it.
    NodeId node;
    bool isAlive = true;
    bool isFree = false;  ///< not on an edge or vertex of the model: refinement made it and may remove it
    bool isSingularU = false;
    bool isSingularV = false;
    bool isOnShell =
        false;  ///< free, and halves a side between two nodes of a shell around the apex of a small angle
    bool isOnRing = false;  ///< around a tip of the face: sides between two such vertices stay

    [[nodiscard]] static FaceVertex of(const SurfaceFacts& facts);
    /// Gives the normal up unless another image of the vertex has the same: a face may meet itself at an angle.
    void keepNormal(const Vec3& other);
    [[nodiscard]] bool isPole() const { return isSingularU || isSingularV; }
};

/// Whether and why refinement has given up a facet in its present shape.
enum class FacetLeft : std::uint8_t
{
    No,
    SmallAngle,  ///< its shortest side spans a small angle of the edges between two nodes of one shell
    Rim,  ///< it is flat, on the rim of a wall that is to have few facets, or waits for what becomes of such a place
    Strip,      ///< it is flat, across a narrow face that is to have few facets
    Resolution  ///< no vertex was found that would remove it, or not without coming too near to others
};

/// Corners counter-clockwise about du x dv; side i lies opposite corner i and runs from corner i+1 to corner i+2.
struct FaceTriangle
{
    std::array<VertexId, 3> v;
    std::array<EdgeLink, 3> n;   ///< invalid where the face ends
    std::array<SegmentId, 3> s;  ///< valid on a piece of an edge; a seam has it beside a valid link
    std::array<Vec2, 3> uv;  ///< in one image of the face; meaningless in the singular direction of a pole
    std::uint16_t generation = 0;
    bool isAlive = true;
    FacetLeft left = FacetLeft::No;
    bool isForced = false;  ///< is to be split, whatever its shape

    [[nodiscard]] unsigned cornerOf(VertexId vertex) const
    {
        return v[0] == vertex ? 0 : (v[1] == vertex ? 1 : 2);
    }
};

/// The segments of the edges of one face, by their ends, the smaller id first.
using SegmentsByEnds = IndexedMap<std::pair<NodeId, NodeId>, SegmentId>;

/// The triangle mesh of one face: flat arrays and links. It knows incidences and what the surface told about its
/// vertices; which triangles there are is decided by the algorithms beside it, face_mesh_check.h tells whether they are
/// right.
/// Across a seam, or wherever unwrapping has come to it, the parameters of two linked sides differ by whole periods.
/// Reference   thesis §3.2, the restricted triangulation of one patch
class FaceMesh
{
public:
    /// From the facets of one face, that are a 2-manifold with boundary and name their nodes in `nodes`; `ringNodes` ascend.
    /// Refuses      a side that more than two facets use or that two use the same way, and one at the border that is no
    ///              segment: IntersectingConstraints, with the face and the point
    [[nodiscard]] static Result<FaceMesh> make(BrepFaceId face, const FaceGeometry& geometry,
                                               std::span<const SurfaceFacet> facets,
                                               const IdVector<NodeId, MeshNode>& nodes,
                                               const SegmentsByEnds& segments,
                                               std::span<const NodeId> ringNodes = {});

    [[nodiscard]] BrepFaceId face() const { return face_; }
    [[nodiscard]] std::size_t vertexSlots() const { return vertices_.size(); }
    [[nodiscard]] std::size_t triangleSlots() const { return triangles_.size(); }
    [[nodiscard]] std::size_t vertexCount() const { return vertices_.size() - deadVertices_; }
    [[nodiscard]] std::size_t triangleCount() const { return triangles_.size() - freeTriangles_.size(); }
    [[nodiscard]] const FaceVertex& vertex(VertexId v) const { return vertices_[v]; }
    [[nodiscard]] FaceVertex& vertex(VertexId v) { return vertices_[v]; }
    [[nodiscard]] const FaceTriangle& triangle(TriangleId t) const { return triangles_[t]; }
    [[nodiscard]] FaceTriangle& triangle(TriangleId t) { return triangles_[t]; }
    [[nodiscard]] const Vec3& position(VertexId v) const { return vertices_[v].position; }

    [[nodiscard]] VertexId from(EdgeLink side) const
    {
        return triangles_[side.triangle()].v[nextCorner(side.edge())];
    }
    [[nodiscard]] VertexId to(EdgeLink side) const
    {
        return triangles_[side.triangle()].v[previousCorner(side.edge())];
    }
    [[nodiscard]] VertexId apex(EdgeLink side) const { return triangles_[side.triangle()].v[side.edge()]; }
    [[nodiscard]] EdgeLink across(EdgeLink side) const { return triangles_[side.triangle()].n[side.edge()]; }
    [[nodiscard]] SegmentId segment(EdgeLink side) const
    {
        return triangles_[side.triangle()].s[side.edge()];
    }

    /// A side of the ring around a tip, beyond which facets are left as they are.
    [[nodiscard]] bool isOnRing(VertexId a, VertexId b) const
    {
        return vertices_[a].isOnRing && vertices_[b].isOnRing;
    }
    [[nodiscard]] bool isOnRing(EdgeLink side) const { return isOnRing(from(side), to(side)); }
    /// A side from a tip to the ring around it.
    [[nodiscard]] bool isSpoke(VertexId a, VertexId b) const
    {
        return (vertices_[a].isOnRing && vertices_[b].isPole()) ||
               (vertices_[b].isOnRing && vertices_[a].isPole());
    }
    [[nodiscard]] bool isSpoke(EdgeLink side) const { return isSpoke(from(side), to(side)); }
    /// Of the fan around a tip, which stays as it is.
    [[nodiscard]] bool isOfFan(EdgeLink side) const { return isOnRing(side) || isSpoke(side); }
    /// A facet between a tip and the ring around it.
    [[nodiscard]] bool isOfFan(TriangleId t) const;
    /// Some vertices are on rings.
    void noteRing() { hasRings_ = true; }
    /// Gives the ring at the facet up, so that its facets may be split.
    void releaseFan(TriangleId t);

    VertexId addVertex(const FaceVertex& vertex) { return vertices_.push_back(vertex); }
    void removeVertex(VertexId v);
    /// A free slot, or a new one, with the next generation; its content is to be written by the caller.
    TriangleId allocateTriangle();
    void freeTriangle(TriangleId t);
    /// Writes corners, parameters and no links; a pole's undefined parameter becomes that between the other corners.
    void writeTriangle(TriangleId t, const std::array<VertexId, 3>& v, const std::array<Vec2, 3>& uv);
    /// Makes two sides the two sides of one edge; `b` may be invalid.
    void link(EdgeLink a, EdgeLink b);

    /// What to add to parameters behind the side to have them in the image of its own triangle.
    [[nodiscard]] Vec2 shiftAcross(const FaceGeometry& geometry, EdgeLink side) const;
    /// The side that runs from a to b, invalid if there is none. Costs the degree of a.
    [[nodiscard]] EdgeLink findSide(VertexId a, VertexId b) const;
    [[nodiscard]] bool areJoined(VertexId a, VertexId b) const
    {
        return findSide(a, b).isValid() || findSide(b, a).isValid();
    }
    /// Calls visit(EdgeLink) for each triangle around the vertex with the side opposite to it: counter-clockwise from
    /// the border, where there is one.
    template <class Visit>
    void forEachTriangleAround(VertexId v, Visit&& visit) const;

private:
    bool hasRings_ = false;
    BrepFaceId face_;
    IdVector<VertexId, FaceVertex> vertices_;
    IdVector<TriangleId, FaceTriangle> triangles_;
    std::vector<TriangleId> freeTriangles_;
    std::size_t deadVertices_ = 0;
};

template <class Visit>
void FaceMesh::forEachTriangleAround(VertexId v, Visit&& visit) const
{
    const TriangleId start = vertices_[v].triangle;
    // Clockwise to the border first; around an inner vertex this comes back to the start.
    TriangleId first = start;
    for (;;) {
        const FaceTriangle& record = triangles_[first];
        const EdgeLink link = record.n[previousCorner(record.cornerOf(v))];
        if (!link.isValid()) break;
        first = link.triangle();
        if (first == start) break;
    }
    TriangleId t = first;
    do {
        const FaceTriangle& record = triangles_[t];
        const unsigned corner = record.cornerOf(v);
        visit(EdgeLink(t, corner));
        const EdgeLink link = record.n[nextCorner(corner)];
        if (!link.isValid()) return;
        t = link.triangle();
    } while (t != first);
}

}  // namespace mesher
