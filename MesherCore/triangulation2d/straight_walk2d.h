#pragma once

#include "delaunay/locate2d.h"
#include "delaunay/triangulation2d.h"
#include "predicates/static_filter.h"

namespace mesher {

/// Where a point is, seen from inside of a triangle.
struct StraightWalk2d
{
    enum class Outcome
    {
        Found,    ///< at `location`
        Blocked,  ///< a constrained edge lies between: `blocker`, seen from the near side
        Lost      ///< rounding of the start misled the walk, which happens in needles only
    };

    Outcome outcome = Outcome::Lost;
    Location2d location;
    EdgeLink blocker;
};

/// Follows the straight line from the centroid of a triangle to a point, as far as the first constrained edge.
/// Guarantees   exact decisions; a location that is found is right whatever the rounding of the centroid
/// Terminates   after a fixed number of steps at the latest
/// Cost         the number of triangles on the line
[[nodiscard]] StraightWalk2d walkStraight(const Triangulation2d& mesh, const StaticFilter2d& filter,
                                          TriangleId start, Vec2 point);

}  // namespace mesher
