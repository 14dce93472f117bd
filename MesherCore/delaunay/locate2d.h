#pragma once

#include "delaunay/triangulation2d.h"
#include "predicates/static_filter.h"

#include <cstdint>

namespace mesher {

/// Where a point lies in a triangulation. Two words, so that it travels in one register.
struct Location2d
{
    enum class Kind : std::uint32_t
    {
        InTriangle,   ///< strictly inside `triangle`
        OnEdge,       ///< strictly between the ends of `edge`
        OnVertex,     ///< on corner `index` of `triangle`
        OutsideHull,  ///< `triangle` is a ghost whose hull edge has the point strictly on its outer side
        NoTriangles   ///< all vertices lie on one line, or there are fewer than three
    };

    Kind kind = Kind::NoTriangles;
    EdgeLink edge;

    [[nodiscard]] TriangleId triangle() const { return edge.triangle(); }
    [[nodiscard]] unsigned index() const { return edge.edge(); }
};

/// Walks from `start` towards the point, over an edge that has the point strictly on its far side each time; which
/// edge is tried first is drawn, or the walk could go in circles where constraints break the Delaunay property.
/// Guarantees   exact; the answer's kind does not depend on `start`
/// Requires     at least one triangle; an alive `start`; `filter` holds for the vertices and the point
/// Terminates   with probability one (always, where there are no constraints)
/// Cost         O(sqrt n) expected from a random start, O(1) from a near one
/// Reference    [devillers2001] stochastic and remembering walks
[[nodiscard]] Location2d locate(const Triangulation2d& mesh, const StaticFilter2d& filter, Vec2 point,
                                TriangleId start);

}  // namespace mesher
