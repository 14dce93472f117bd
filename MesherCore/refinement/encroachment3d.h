#pragma once

#include "base/vec.h"
#include "delaunay/cavity3d.h"
#include "delaunay/delaunay3d.h"
#include "delaunay/triangulation3d.h"
#include "predicates/static_filter.h"

#include <optional>
#include <utility>
#include <vector>

namespace mesher {

/// A ball that no vertex may lie in: the diametral one of a segment, the equatorial one of a facet.
struct ProtectingBall
{
    Vec3 centre;
    double squaredRadius = 0.0;

    [[nodiscard]] static ProtectingBall ofSegment(const Vec3& a, const Vec3& b);
    /// Nothing for a facet that has no area in double arithmetic.
    [[nodiscard]] static std::optional<ProtectingBall> ofFacet(const Vec3& a, const Vec3& b, const Vec3& c);

    /// Squared distance from the centre over the squared radius; below 1 inside.
    [[nodiscard]] double depthOf(const Vec3& p) const { return squaredLength(p - centre) / squaredRadius; }
    /// Strictly inside, by more than rounding: four points of a rectangle do not encroach upon each other.
    [[nodiscard]] bool contains(const Vec3& p) const
    {
        return squaredLength(p - centre) < (1.0 - 1e-8) * squaredRadius;
    }
};

/// Tetrahedra in conflict with one point beyond which the search for them is worth to be avoided. A few dozen are usual.
inline constexpr std::size_t kOrdinaryConflicts = 256;

/// What a point would encroach upon.
struct Encroached3d
{
    /// The segment that it is deepest in, by its ends; else invalid.
    std::array<VertexId, 2> segment;
    /// The facet that it is deepest in, seen from outside of the cavity; else invalid.
    TetFace facet;
    /// A facet of the conflicts does not see the point: the point may lie behind it.
    bool hasFacetBehind = false;
};

/// Encroachment by the point of a set of conflicts (CavityOperator3d::findConflicts) on the constrained faces around it and
/// the constrained edges in it: what the point sees. Costs nothing beyond looking at them.
/// Reference    [gosselin] section 4.3
[[nodiscard]] Encroached3d findEncroached(const Triangulation3d& mesh, const Cavity3d& conflicts,
                                          const StaticFilter3d& filter);

/// What keeps a point from being inserted beside a tetrahedron that it is in conflict with: what it encroaches upon, else
/// the first facet in front of it. With none of them `makeStarShaped` may follow.
/// Cost  the conflicts of the point, or those next to the tetrahedron and a walk: along thin places thousands of flat
///       tetrahedra can be in conflict with a point far outside of the region
[[nodiscard]] Encroached3d findInTheWay(Delaunay3d& delaunay, TetId tet, const Vec3& point);

/// The first constrained face between a tetrahedron's centroid and a point, seen from the side of the tetrahedron; invalid
/// if nothing is in the way.
/// Terminates   after a number of steps that a straight walk needs in no sound mesh; invalid then
[[nodiscard]] TetFace firstConstraintTowards(const Triangulation3d& mesh, TetId from, const Vec3& point,
                                             const StaticFilter3d& filter);

}  // namespace mesher
