#pragma once

#include "base/id_vector.h"
#include "base/ids.h"
#include "mesh/classified_mesh.h"
#include "mesh/surface_mesh.h"
#include "quality/tet_measures.h"

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace mesher {

using TetNodes = std::array<NodeId, 4>;
using FacetNodes = std::array<NodeId, 3>;

/// The tetrahedra and boundary triangles of a finished mesh with the elements around each node: what local changes need to know.
/// Neither the outside nor links between tetrahedra are kept. So nodes of the boundary may move and edges of it be swapped
/// without regard to tetrahedra outside, and nodes at which solids merely touch are nothing special.
/// Guarantees   stars, scores and facets agree with the elements after each change; the order in stars depends on the changes
///              only
/// Cost         a star is walked to find a neighbour: about 24 tetrahedra
class TetComplex
{
public:
    explicit TetComplex(const ClassifiedMesh& mesh);

    /// Puts nodes, triangles and tetrahedra in the place of those that the mesh had, in their order; lines and points are
    /// numbered again.
    void writeTo(ClassifiedMesh& mesh) const;

    // --- nodes
    [[nodiscard]] std::uint32_t nodeLimit() const { return static_cast<std::uint32_t>(nodes_.size()); }
    [[nodiscard]] const MeshNode& node(NodeId n) const { return nodes_[n]; }
    [[nodiscard]] const Vec3& position(NodeId n) const { return nodes_[n].position; }
    [[nodiscard]] std::span<const TetId> star(NodeId n) const { return stars_[n]; }
    [[nodiscard]] std::span<const FacetId> facets(NodeId n) const { return facetStars_[n]; }
    /// The other ends of the lines at a node.
    [[nodiscard]] std::span<const NodeId> lines(NodeId n) const { return lines_[n]; }
    [[nodiscard]] bool isInside(NodeId n) const { return facetStars_[n].empty(); }
    [[nodiscard]] bool isLine(NodeId a, NodeId b) const;
    /// Grows whenever an element at the node changes.
    [[nodiscard]] std::uint32_t version(NodeId n) const { return versions_[n]; }

    // --- tetrahedra
    [[nodiscard]] std::uint32_t tetLimit() const { return static_cast<std::uint32_t>(tets_.size()); }
    [[nodiscard]] bool isAlive(TetId t) const { return tets_[t].node[0].isValid(); }
    [[nodiscard]] const TetNodes& nodes(TetId t) const { return tets_[t].node; }
    [[nodiscard]] std::uint32_t solid(TetId t) const { return tets_[t].solid; }
    [[nodiscard]] double score(TetId t) const { return tets_[t].score; }
    [[nodiscard]] TetCorners corners(const TetNodes& tet) const
    {
        return {position(tet[0]), position(tet[1]), position(tet[2]), position(tet[3])};
    }
    [[nodiscard]] bool hasNode(TetId t, NodeId n) const
    {
        const TetNodes& v = tets_[t].node;
        return v[0] == n || v[1] == n || v[2] == n || v[3] == n;
    }
    [[nodiscard]] bool isPositive(const TetNodes& tet) const;
    /// The tetrahedron of three nodes other than `not`; invalid if there is none.
    [[nodiscard]] TetId tetBeside(NodeId a, NodeId b, NodeId c, TetId except) const;
    [[nodiscard]] bool isEdge(NodeId a, NodeId b) const;
    /// The face opposite to a slot, counter-clockwise as seen from the node there.
    [[nodiscard]] FacetNodes faceOf(TetId t, std::size_t slot) const;

    // --- triangles of the boundary and between solids
    [[nodiscard]] const FacetNodes& nodes(FacetId f) const { return facets_[f].node; }
    [[nodiscard]] std::uint32_t face(FacetId f) const { return facets_[f].face; }
    [[nodiscard]] std::uint32_t facetLimit() const { return static_cast<std::uint32_t>(facets_.size()); }
    /// How many triangles have the edge; the first two are told.
    int facetsAt(NodeId a, NodeId b, std::array<FacetId, 2>& found) const;
    [[nodiscard]] bool isOnSurface(NodeId a, NodeId b) const;
    [[nodiscard]] bool isFacet(const FacetNodes& face) const;

    // --- changes
    /// The new tetrahedra are of the solid of the old ones and must be positive.
    void replaceTets(std::span<const TetId> before, std::span<const TetNodes> after);
    /// The ids of the two triangles stay, the nodes change.
    void replaceFacets(const std::array<FacetId, 2>& facets, const std::array<FacetNodes, 2>& after);
    void move(NodeId n, const Vec3& position, Vec2 parameters);
    /// A node that has lost all its elements.
    void removeNode(NodeId n);
    /// A node inside of a solid, without elements yet.
    NodeId addNode(const MeshNode& node);

private:
    struct Tet
    {
        TetNodes node;  ///< the first one is invalid in a free slot
        std::uint32_t solid = 0;
        double score = 0.0;
    };
    struct Facet
    {
        FacetNodes node;
        std::uint32_t face = 0;
    };

    void put(TetId t, const TetNodes& nodes, std::uint32_t solid);
    void take(TetId t);

    IdVector<NodeId, MeshNode> nodes_;
    IdVector<NodeId, std::vector<TetId>> stars_;
    IdVector<NodeId, std::vector<FacetId>> facetStars_;
    IdVector<NodeId, std::vector<NodeId>> lines_;
    IdVector<NodeId, std::uint32_t> versions_;
    IdVector<TetId, Tet> tets_;
    IdVector<FacetId, Facet> facets_;
    std::vector<TetId> freeTets_;
    IdVector<NodeId, std::uint8_t> isRemoved_;
};

}  // namespace mesher
