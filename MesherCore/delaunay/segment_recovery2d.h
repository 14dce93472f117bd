#pragma once

#include "base/result.h"
#include "delaunay/triangulation2d.h"
#include "predicates/static_filter.h"

#include <cstddef>
#include <vector>

namespace mesher {

/// Scratch of `recoverSegment`, kept by the caller so that a recovery allocates nothing.
struct SegmentWorkspace2d
{
    std::vector<EdgeLink> crossed;
    std::vector<VertexId> leftEnds;
    std::vector<VertexId> chain;
    std::vector<EdgeLink> suspects;
    /// The vertices on the segment that was recovered last, from its start to its end.
    std::vector<VertexId> vertices;
};

struct SegmentRecovery2d
{
    std::size_t recoveryFlips = 0;
    std::size_t delaunayFlips = 0;
};

/// Makes the segment from a to b a chain of constrained edges by flips alone, then the triangulation constrained
/// Delaunay again. Vertices that lie exactly on the segment become vertices of the chain; none is added.
/// Guarantees   all or nothing: with an error the mesh is unchanged
/// Requires     a constrained Delaunay triangulation and two different vertices of it
/// Refuses      a segment that crosses a constrained edge (IntersectingConstraints, both segments and the place named)
/// Terminates   always: the vertices on the left of the segment are cut off the crossed strip one by one, at places
///              where it bulges, and there the fan of crossed edges of such a vertex always has one to flip
/// Cost         linear in the number of crossed edges in practice, quadratic at worst
/// Reference    [lawson1977] for the flips, [bernal1995] for the order that always ends, [sloan1993]
[[nodiscard]] Result<SegmentRecovery2d> recoverSegment(Triangulation2d& mesh, const StaticFilter2d& filter,
                                                       VertexId a, VertexId b, SegmentWorkspace2d& workspace);

}  // namespace mesher
