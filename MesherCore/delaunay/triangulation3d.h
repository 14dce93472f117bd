#pragma once

#include "base/id_vector.h"
#include "base/ids.h"
#include "base/vec.h"
#include "delaunay/ghost_vertex.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace mesher {

/// One face of one tetrahedron: the face opposite vertex `face()` of `tet()`, packed as links are stored.
struct TetFace
{
    std::uint32_t code = 0xFFFFFFFFu;

    constexpr TetFace() = default;
    constexpr explicit TetFace(std::uint32_t packed) : code(packed) {}
    constexpr TetFace(TetId tet, int face) : code((tet.value << 2) | static_cast<std::uint32_t>(face)) {}

    [[nodiscard]] constexpr TetId tet() const { return TetId(code >> 2); }
    [[nodiscard]] constexpr int face() const { return static_cast<int>(code & 3u); }
    [[nodiscard]] constexpr bool isValid() const { return code != 0xFFFFFFFFu; }
    friend constexpr auto operator<=>(const TetFace&, const TetFace&) = default;
};

/// Slots of the vertices of face i, ordered so that (f0, f1, f2, vertex i) is an even permutation of (0, 1, 2, 3):
/// vertex i of a positively oriented tetrahedron lies on the positive side of its face i.
inline constexpr int kFaceSlots[4][3] = {{1, 3, 2}, {0, 2, 3}, {0, 3, 1}, {0, 1, 2}};
/// Slots of the ends of edge e.
inline constexpr int kEdgeSlots[6][2] = {{0, 1}, {0, 2}, {0, 3}, {1, 2}, {1, 3}, {2, 3}};
/// Edge between two different slots.
inline constexpr int kEdgeOfSlots[4][4] = {{-1, 0, 1, 2}, {0, -1, 3, 4}, {1, 3, -1, 5}, {2, 4, 5, -1}};

/// Vertices and links of a tetrahedron: 32 bytes, so that a visit touches one cache line.
struct alignas(32) TetRecord
{
    std::array<VertexId, 4> vertex;
    /// neighbour[i] is the same face as face i, seen from the tetrahedron on its other side.
    std::array<TetFace, 4> neighbour;
};

/// Flags of a tetrahedron, and a generation that grows whenever its slot is given other vertices or freed:
/// a queue entry {tet, generation} is stale exactly when the two differ (up to wrap-around after 65,536 changes).
struct TetState
{
    std::uint16_t flags = 0;
    std::uint16_t generation = 0;
};

namespace tet_flag {
inline constexpr std::uint16_t kFaces = 0x000F;  ///< bit i: face i is constrained
inline constexpr std::uint16_t kEdges = 0x03F0;  ///< bit 4 + e: edge e is constrained
inline constexpr std::uint16_t kDead = 0x0400;   ///< the slot is on the free list
inline constexpr std::uint16_t kInCavity =
    0x0800;  ///< scratch of one local operation, clear between operations
inline constexpr std::uint16_t kAllowed =
    0x1000;  ///< scratch of one local operation, clear between operations
inline constexpr std::uint16_t kConstraints = kFaces | kEdges;

constexpr std::uint16_t face(int i) { return static_cast<std::uint16_t>(1u << i); }
constexpr std::uint16_t edge(int e) { return static_cast<std::uint16_t>(16u << e); }
}  // namespace tet_flag

/// A point and the length scale (model units, 0 when unset) of the sizing field there.
struct alignas(32) VertexRecord
{
    Vec3 position;
    double lengthScale = 0.0;
};

/// The B-rep entity a vertex lies on: dimension 0 (point), 1 (curve), 2 (surface), 3 (volume or unclassified).
struct VertexClass
{
    static constexpr std::uint32_t kNoEntity = 0x0FFFFFFFu;

    std::uint32_t dimension : 3 = 3;
    /// A scaffold point (scaffold.h) belongs to no model and is to be removed again.
    std::uint32_t scaffold : 1 = 0;
    std::uint32_t entity : 28 = kNoEntity;

    friend constexpr bool operator==(const VertexClass&, const VertexClass&) = default;
};

/// Old-to-new numbering that `Triangulation3d::compact` made; an invalid id where the old one was dead.
struct Renumbering3d
{
    IdVector<VertexId, VertexId> vertex;
    IdVector<TetId, TetId> tet;
};

/// The combinatorial structure of a triangulation of the 3-sphere: the tetrahedra of the convex hull of the vertices
/// and one ghost tetrahedron per hull facet. Flat arrays owned by this class alone; it stores and links, and knows
/// no geometry but the vertices' positions.
///
/// Limits       2^30 tetrahedra (allocateTet throws std::length_error beyond), 2^32 - 2 vertices
/// Guarantees   a live tetrahedron has four different vertices and four symmetric links (checkTopology);
///              a ghost tetrahedron has the ghost in slot 3.
/// Cost         40 bytes a tetrahedron, 40 bytes a vertex.
class Triangulation3d
{
public:
    static constexpr std::uint32_t kMaxTets = 1u << 30;

    // --- vertices
    VertexId addVertex(Vec3 position, VertexClass classification = {});
    /// The vertex must have no tetrahedron left. Its id is reused by a later addVertex.
    void removeVertex(VertexId vertex);
    [[nodiscard]] bool isVertexAlive(VertexId vertex) const;
    [[nodiscard]] const Vec3& position(VertexId vertex) const { return vertices_[vertex].position; }
    void setPosition(VertexId vertex, Vec3 position) { vertices_[vertex].position = position; }
    [[nodiscard]] double lengthScale(VertexId vertex) const { return vertices_[vertex].lengthScale; }
    void setLengthScale(VertexId vertex, double scale) { vertices_[vertex].lengthScale = scale; }
    [[nodiscard]] VertexClass classification(VertexId vertex) const { return vertexClass_[vertex]; }
    void setClassification(VertexId vertex, VertexClass value) { vertexClass_[vertex] = value; }
    /// A live tetrahedron at the vertex (possibly a ghost one); invalid while the vertex is in none.
    [[nodiscard]] TetId incidentTet(VertexId vertex) const { return incidentTet_[vertex]; }
    void setIncidentTet(VertexId vertex, TetId tet) { incidentTet_[vertex] = tet; }
    /// One past the largest vertex id in use; dead ids below it answer false to isVertexAlive.
    [[nodiscard]] std::uint32_t vertexLimit() const { return static_cast<std::uint32_t>(vertices_.size()); }
    [[nodiscard]] std::uint32_t vertexCount() const { return vertexLimit() - freeVertexCount_; }

    // --- tetrahedra
    [[nodiscard]] const TetRecord& tet(TetId tet) const { return tets_[tet]; }
    [[nodiscard]] TetRecord& tet(TetId tet) { return tets_[tet]; }
    [[nodiscard]] VertexId vertex(TetId tet, int slot) const
    {
        return tets_[tet].vertex[static_cast<unsigned>(slot)];
    }
    [[nodiscard]] TetFace neighbour(TetId tet, int face) const
    {
        return tets_[tet].neighbour[static_cast<unsigned>(face)];
    }
    [[nodiscard]] TetFace neighbour(TetFace face) const { return neighbour(face.tet(), face.face()); }
    [[nodiscard]] bool isAlive(TetId tet) const { return (states_[tet].flags & tet_flag::kDead) == 0; }
    [[nodiscard]] bool isGhostTet(TetId tet) const { return isGhost(tets_[tet].vertex[3]); }
    [[nodiscard]] std::uint16_t generation(TetId tet) const { return states_[tet].generation; }
    [[nodiscard]] std::uint16_t flags(TetId tet) const { return states_[tet].flags; }
    [[nodiscard]] TetState& state(TetId tet) { return states_[tet]; }
    [[nodiscard]] RegionId region(TetId tet) const { return regions_[tet]; }
    void setRegion(TetId tet, RegionId region) { regions_[tet] = region; }
    /// One past the largest tetrahedron id in use, ghosts and dead slots included.
    [[nodiscard]] std::uint32_t tetLimit() const { return static_cast<std::uint32_t>(tets_.size()); }
    /// Live tetrahedra, ghosts included.
    [[nodiscard]] std::uint32_t tetCount() const
    {
        return tetLimit() - static_cast<std::uint32_t>(freeTets_.size());
    }
    /// Live tetrahedra without ghosts. Cost: linear.
    [[nodiscard]] std::uint32_t finiteTetCount() const;

    /// A slot for a new tetrahedron: unconstrained, exterior, its vertices and links for the caller to fill.
    TetId allocateTet();
    void freeTet(TetId tet);
    /// Counts a change of the slot's vertices and drops its constraint flags.
    void renewTet(TetId tet)
    {
        TetState& state = states_[tet];
        state.flags = 0;
        ++state.generation;
    }
    void link(TetFace a, TetFace b)
    {
        tets_[a.tet()].neighbour[static_cast<unsigned>(a.face())] = b;
        tets_[b.tet()].neighbour[static_cast<unsigned>(b.face())] = a;
    }

    // --- incidence
    /// Slot of the vertex in the tetrahedron, or -1.
    [[nodiscard]] int slotOf(TetId tet, VertexId vertex) const;
    /// Vertices of a face such that the tetrahedron lies on its positive side.
    [[nodiscard]] std::array<VertexId, 3> faceVertices(TetFace face) const;
    /// The live tetrahedra at a vertex, ghosts included, in a deterministic order. Cost: proportional to their number.
    void collectStar(VertexId vertex, std::vector<TetId>& star) const;
    /// A tetrahedron with the edge, or invalid. Cost: the star of `a`.
    [[nodiscard]] TetId findEdge(VertexId a, VertexId b) const;
    /// The face with the three vertices, or invalid. Cost: the star of `a`.
    [[nodiscard]] TetFace findFace(VertexId a, VertexId b, VertexId c) const;
    /// The tetrahedra around edge (a, b) in order, starting with `start`, which must have both.
    void collectEdgeRing(TetId start, VertexId a, VertexId b, std::vector<TetId>& ring) const;

    // --- constraints: kept in every tetrahedron that has the face or edge; these keep the copies equal
    [[nodiscard]] bool isFaceConstrained(TetFace face) const
    {
        return (states_[face.tet()].flags & tet_flag::face(face.face())) != 0;
    }
    [[nodiscard]] bool isEdgeConstrained(TetId tet, int edge) const
    {
        return (states_[tet].flags & tet_flag::edge(edge)) != 0;
    }
    void setFaceConstrained(TetFace face, bool constrained);
    void setEdgeConstrained(TetId tet, VertexId a, VertexId b, bool constrained);
    /// Whether any face or edge was constrained since the triangulation was empty.
    [[nodiscard]] bool wasConstrained() const { return wasConstrained_; }

    // --- storage
    void clear();
    void reserve(std::size_t vertices, std::size_t tets);
    /// Renumbers vertices and tetrahedra without gaps, in their order; generations of all slots grow.
    Renumbering3d compact();
    /// Recomputes incidentTet of every vertex. Cost: linear.
    void rebuildIncidentTets();
    /// Bytes held by all arrays, reserved space included.
    [[nodiscard]] std::size_t bytes() const;

    [[nodiscard]] const VertexRecord* vertexData() const { return vertices_.data(); }
    [[nodiscard]] TetRecord* tetData() { return tets_.data(); }
    [[nodiscard]] const TetRecord* tetData() const { return tets_.data(); }
    [[nodiscard]] TetState* stateData() { return states_.data(); }
    [[nodiscard]] const TetState* stateData() const { return states_.data(); }

private:
    template <class Predicate>
    TetId walkStar(VertexId vertex, std::vector<TetId>& star, const Predicate& isSought) const;
    void growTets();

    IdVector<VertexId, VertexRecord> vertices_;
    IdVector<VertexId, TetId> incidentTet_;
    IdVector<VertexId, VertexClass> vertexClass_;
    VertexId freeVertex_;  ///< head of the list of dead vertices, threaded through incidentTet_
    std::uint32_t freeVertexCount_ = 0;

    IdVector<TetId, TetRecord> tets_;
    IdVector<TetId, TetState> states_;
    IdVector<TetId, RegionId> regions_;
    std::vector<TetId> freeTets_;
    std::uint16_t firstGeneration_ = 0;  ///< of a slot at the end of the arrays
    bool wasConstrained_ = false;
};

inline int Triangulation3d::slotOf(TetId tet, VertexId vertex) const
{
    const auto& vertices = tets_[tet].vertex;
    for (int slot = 0; slot < 4; ++slot) {
        if (vertices[static_cast<unsigned>(slot)] == vertex) return slot;
    }
    return -1;
}

inline std::array<VertexId, 3> Triangulation3d::faceVertices(TetFace face) const
{
    const auto& vertices = tets_[face.tet()].vertex;
    const auto& slots = kFaceSlots[face.face()];
    return {vertices[static_cast<unsigned>(slots[0])], vertices[static_cast<unsigned>(slots[1])],
            vertices[static_cast<unsigned>(slots[2])]};
}

/// The region outside of every solid, and of a tetrahedron that nobody classified.
inline constexpr RegionId kExteriorRegion{0u};

}  // namespace mesher
