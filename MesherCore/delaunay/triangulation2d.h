#pragma once

#include "base/id_vector.h"
#include "base/ids.h"
#include "base/vec.h"
#include "delaunay/ghost_vertex.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace mesher {

/// A side of a triangle: the triangle and the index of its edge, packed into 32 bits.
struct EdgeLink
{
    std::uint32_t packed = 0xFFFFFFFFu;

    constexpr EdgeLink() = default;
    constexpr EdgeLink(TriangleId triangle, unsigned edge) : packed(triangle.value << 2 | edge) {}

    [[nodiscard]] constexpr TriangleId triangle() const { return TriangleId(packed >> 2); }
    [[nodiscard]] constexpr unsigned edge() const { return packed & 3u; }
    [[nodiscard]] constexpr bool isValid() const { return packed != 0xFFFFFFFFu; }
    friend constexpr auto operator<=>(const EdgeLink&, const EdgeLink&) = default;
};

/// The corner after i and the one before it, counter-clockwise.
constexpr unsigned nextCorner(unsigned i) { return i == 2 ? 0 : i + 1; }
constexpr unsigned previousCorner(unsigned i) { return i == 0 ? 2 : i - 1; }

/// A triangle: corners counter-clockwise; edge i lies opposite corner i and runs from corner i+1 to corner i+2.
/// The ghost vertex, if any, is corner 2: edge 2 of a ghost triangle is the hull edge seen from outside.
/// The region sits in the record, not beside it: the 32 bytes are half a cache line and never straddle two.
struct alignas(32) Triangle2d
{
    static constexpr std::uint16_t kConstrainedEdges = 7;  ///< bit i: edge i is constrained
    static constexpr std::uint16_t kDead = 8;              ///< the slot is free
    static constexpr std::uint16_t kFirstFreeMark = 16;    ///< this bit and the higher ones are the caller's

    VertexId v[3];
    EdgeLink n[3];
    std::uint16_t flags = 0;
    std::uint16_t generation = 0;  ///< changes whenever the corners change; wraps
    RegionId region{0};

    [[nodiscard]] bool isAlive() const { return (flags & kDead) == 0; }
    [[nodiscard]] bool isGhost() const { return v[2] == kGhostVertex; }
    [[nodiscard]] bool isConstrained(unsigned edge) const { return (flags >> edge & 1u) != 0; }
    [[nodiscard]] unsigned cornerOf(VertexId vertex) const
    {
        return v[0] == vertex ? 0 : (v[1] == vertex ? 1 : 2);
    }
};
static_assert(sizeof(Triangle2d) == 32);

/// Where a vertex came from: on a corner of the model, on a curve, or inside of a face.
enum class VertexOrigin : std::uint8_t
{
    Corner = 0,
    Curve = 1,
    Face = 2,
    Unset = 3
};

/// Flat storage of a triangulation of the plane with one ghost vertex. It knows incidences, not geometry: which
/// triangles there are is decided by the algorithms beside it, and delaunay_check2d.h tells whether they are right.
/// Limits  2^30 triangles, ghosts included, so about 2^29 vertices
/// Cost    32 bytes a triangle and 33 a vertex: 97 bytes a vertex in all
class Triangulation2d
{
public:
    static constexpr std::uint32_t kMaxTriangles = 1u << 30;
    static constexpr std::uint32_t kMaxVertices = (1u << 29) - 8;

    /// \name Vertices
    ///@{
    VertexId addVertex(Vec2 position);
    void removeVertex(VertexId vertex);
    [[nodiscard]] std::size_t vertexCount() const { return vertices_.size() - freeVertices_; }
    /// Ids run from 0 to vertexSlots() - 1; those of removed vertices are not alive.
    [[nodiscard]] std::size_t vertexSlots() const { return vertices_.size(); }
    [[nodiscard]] bool isAlive(VertexId vertex) const
    {
        return vertex.value < vertices_.size() && origins_[vertex] != kFreeVertex;
    }
    [[nodiscard]] Vec2 position(VertexId vertex) const { return vertices_[vertex].position; }
    /// A triangle at the vertex; invalid as long as the triangulation has no triangles.
    [[nodiscard]] TriangleId triangleAt(VertexId vertex) const { return vertices_[vertex].triangle; }
    void setTriangleAt(VertexId vertex, TriangleId triangle) { vertices_[vertex].triangle = triangle; }
    [[nodiscard]] double lengthScale(VertexId vertex) const { return vertices_[vertex].lengthScale; }
    void setLengthScale(VertexId vertex, double scale) { vertices_[vertex].lengthScale = scale; }
    /// Number of the model entity the vertex lies on, of the kind that `origin` tells.
    [[nodiscard]] std::uint32_t entity(VertexId vertex) const { return vertices_[vertex].entity; }
    [[nodiscard]] VertexOrigin origin(VertexId vertex) const
    {
        return static_cast<VertexOrigin>(origins_[vertex]);
    }
    void setOrigin(VertexId vertex, VertexOrigin origin, std::uint32_t entity);
    ///@}

    /// \name Triangles
    ///@{
    [[nodiscard]] std::size_t triangleSlots() const { return triangles_.size(); }
    /// Alive triangles, ghosts included.
    [[nodiscard]] std::size_t triangleCount() const { return triangles_.size() - freeTriangles_; }
    [[nodiscard]] bool isAlive(TriangleId t) const
    {
        return t.value < triangles_.size() && triangles_[t].isAlive();
    }
    [[nodiscard]] const Triangle2d& triangle(TriangleId t) const { return triangles_[t]; }
    [[nodiscard]] Triangle2d& triangle(TriangleId t) { return triangles_[t]; }
    /// A free slot with the next generation, flags cleared; its corners and links are to be set by the caller.
    TriangleId allocateTriangle();
    void freeTriangle(TriangleId t);
    void freeAllTriangles();
    void setRegion(TriangleId t, RegionId region) { triangles_[t].region = region; }
    ///@}

    /// \name Edges
    ///@{
    [[nodiscard]] VertexId edgeFrom(EdgeLink e) const
    {
        return triangles_[e.triangle()].v[nextCorner(e.edge())];
    }
    [[nodiscard]] VertexId edgeTo(EdgeLink e) const
    {
        return triangles_[e.triangle()].v[previousCorner(e.edge())];
    }
    /// The same edge seen from the other side.
    [[nodiscard]] EdgeLink across(EdgeLink e) const { return triangles_[e.triangle()].n[e.edge()]; }
    [[nodiscard]] VertexId apex(EdgeLink e) const { return triangles_[e.triangle()].v[e.edge()]; }
    [[nodiscard]] bool isConstrained(EdgeLink e) const
    {
        return triangles_[e.triangle()].isConstrained(e.edge());
    }
    /// Sets the flag on both sides.
    void setConstrained(EdgeLink e, bool isConstrained);
    /// Makes two sides the two sides of one edge.
    void link(EdgeLink a, EdgeLink b);
    /// The side that runs from a to b, or an invalid link if there is no such edge. Costs the degree of a.
    [[nodiscard]] EdgeLink findEdge(VertexId a, VertexId b) const;
    ///@}

    /// Calls `visit(EdgeLink)` for each triangle around the vertex, counter-clockwise, ghosts included; the link's
    /// edge is the one opposite the vertex. `visit` returns false to stop; it must not change the triangulation.
    template <class Visit>
    void forEachTriangleAround(VertexId vertex, Visit&& visit) const;

    void reserve(std::size_t vertexCount);

    /// What `compact` did: new ids by old slot, invalid for what was dead.
    struct Renumbering
    {
        IdVector<VertexId, VertexId> vertices;
        IdVector<TriangleId, TriangleId> triangles;
    };
    /// Removes dead slots, keeping the order of the rest, and gives spare memory back.
    Renumbering compact();

    /// Heap memory held, spare capacity included.
    [[nodiscard]] std::size_t bytes() const;

private:
    struct Vertex
    {
        Vec2 position;
        double lengthScale = 0.0;
        TriangleId triangle;
        std::uint32_t entity = 0;
    };
    static_assert(sizeof(Vertex) == 32);

    static constexpr std::uint8_t kFreeVertex = 0xFF;

    IdVector<TriangleId, Triangle2d> triangles_;
    IdVector<VertexId, Vertex> vertices_;
    IdVector<VertexId, std::uint8_t> origins_;
    // Free slots form lists: a triangle's next is in v[0], a vertex' next in `triangle`.
    std::uint32_t firstFreeTriangle_ = TriangleId::kInvalid;
    std::uint32_t firstFreeVertex_ = VertexId::kInvalid;
    std::size_t freeTriangles_ = 0;
    std::size_t freeVertices_ = 0;
};

inline TriangleId Triangulation2d::allocateTriangle()
{
    if (firstFreeTriangle_ == TriangleId::kInvalid) {
        MESHER_PRECONDITION(triangles_.size() < kMaxTriangles);
        return triangles_.push_back({});
    }
    const TriangleId t(firstFreeTriangle_);
    Triangle2d& record = triangles_[t];
    firstFreeTriangle_ = record.v[0].value;
    --freeTriangles_;
    record.flags = 0;
    record.region = RegionId(0);
    return t;
}

template <class Visit>
void Triangulation2d::forEachTriangleAround(VertexId vertex, Visit&& visit) const
{
    const TriangleId first = triangleAt(vertex);
    TriangleId t = first;
    do {
        const Triangle2d& record = triangles_[t];
        const unsigned corner = record.cornerOf(vertex);
        if (!visit(EdgeLink(t, corner))) return;
        t = record.n[nextCorner(corner)].triangle();
    } while (t != first);
}

}  // namespace mesher
