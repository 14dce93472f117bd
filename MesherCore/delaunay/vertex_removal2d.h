#pragma once

#include "delaunay/triangulation2d.h"
#include "predicates/static_filter.h"

#include <cstdint>
#include <vector>

namespace mesher {

/// Scratch of `removeVertex`, kept by the caller so that a removal allocates nothing.
struct RemovalWorkspace2d
{
    /// A corner of the hole and the edge to the next one, counter-clockwise around the vertex that goes.
    struct Corner
    {
        VertexId vertex;
        EdgeLink outer;  ///< the side of the edge to the next corner that stays
        RegionId region;
        std::uint32_t next;
        std::uint32_t previous;
        bool isCut;
    };

    std::vector<Corner> ring;
    std::vector<TriangleId> slots;
    std::vector<std::uint32_t> candidates;
    std::vector<EdgeLink> suspects;
};

/// The two neighbours along a straight constrained chain that are joined when the vertex between them goes.
struct ChainEnds
{
    VertexId from;
    VertexId to;
};

/// Whether the vertices that are not `vertex` lie on one line, so that its removal leaves no triangle.
/// Cost  O(1) unless every finite triangle is incident to the vertex
[[nodiscard]] bool isLastOffLine(const Triangulation2d& mesh, const StaticFilter2d& filter, VertexId vertex,
                                 RemovalWorkspace2d& workspace);

/// Removes a vertex and fills its star again: ears are cut that do not hide the vertex' place from the rest of the
/// hole, then edges are flipped.
/// Guarantees   the constrained Delaunay triangulation of the remaining vertices; the vertex slot is freed
/// Requires     a constrained Delaunay triangulation; not isLastOffLine; no constrained edge at the vertex, except,
///              with `chain`, one to either of its ends, the three being collinear: these become one constrained edge
/// Terminates   always: among the corners of a star-shaped polygon at least two are ears, at most one of which
///              holds the centre
/// Cost         linear in the degree for the ears, quadratic at worst for the flips
/// Reference    [devillers2002] discusses the alternatives; [lawson1977] for the flips
/// Returns      the number of flips
std::size_t removeVertex(Triangulation2d& mesh, const StaticFilter2d& filter, VertexId vertex,
                         const ChainEnds* chain, RemovalWorkspace2d& workspace);

}  // namespace mesher
