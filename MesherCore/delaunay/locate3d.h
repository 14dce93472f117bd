#pragma once

#include "base/random.h"
#include "delaunay/triangulation3d.h"
#include "predicates/static_filter.h"

namespace mesher {

/// Where a point lies in a triangulation.
struct Location3d
{
    enum class Kind : std::uint8_t
    {
        Vertex,  ///< on vertex `index` of `tet`
        Edge,    ///< inside edge `index` of `tet`
        Face,    ///< inside face `index` of `tet`
        Tet,     ///< inside `tet`
        Outside  ///< strictly beyond the hull facet of the ghost tetrahedron `tet`
    };

    Kind kind = Kind::Outside;
    TetId tet;
    int index = -1;
};

/// Walks from `hint` to a tetrahedron whose closure has the point, or to a ghost one whose hull facet the point lies
/// strictly beyond.
/// Guarantees   exact, also on faces, edges and vertices
/// Requires     a three-dimensional triangulation; `hint` alive
/// Terminates   always in a Delaunay triangulation; in any other with probability one, since the faces are tried in a
///              random order that `random` determines
/// Cost         the number of tetrahedra between the hint and the point
/// Reference    [devillers2002] remembering stochastic visibility walk
TetId walk3d(const Triangulation3d& mesh, const Vec3& point, TetId hint, const StaticFilter3d& filter,
             Random& random);

/// Tells how the point lies in the tetrahedron that walk3d found.
Location3d classifyLocation3d(const Triangulation3d& mesh, const Vec3& point, TetId found,
                              const StaticFilter3d& filter);

}  // namespace mesher
