#pragma once

#include "delaunay/locate2d.h"
#include "delaunay/triangulation2d.h"
#include "predicates/static_filter.h"

#include <cstdint>
#include <vector>

namespace mesher {

/// The triangles that have to go when a point is inserted, and the edges they leave: what the insertion would do,
/// before it is done. Kept by the caller and filled again and again, so that an insertion allocates nothing.
struct Cavity2d
{
    struct BoundaryEdge
    {
        EdgeLink outer;   ///< the side that stays
        RegionId region;  ///< of the triangle that goes
    };

    Vec2 point;
    /// The place of the point. A constrained edge it lies on is split; both halves stay constrained.
    Location2d location;
    std::vector<TriangleId> triangles;
    /// Counter-clockwise around the point.
    std::vector<BoundaryEdge> boundary;
    /// Constrained edges of the boundary, seen from outside: those the point may encroach upon.
    std::vector<EdgeLink> constrained;
    /// Triangles taken out again because the point does not see one of their edges. Always 0 in a constrained
    /// Delaunay triangulation; a caller counts it.
    unsigned repairs = 0;
    /// Of the state in which the cavity was found; Delaunay2d tells a stale cavity by it.
    std::uint64_t revision = 0;

    /// An edge the search has yet to cross and the region it comes from, packed: written as two words and read as
    /// one, it would have to wait for the write to reach the cache each time.
    class PendingEdge
    {
    public:
        PendingEdge(EdgeLink side, RegionId region) : packed_(std::uint64_t{side.packed} << 32 | region.value)
        {
        }
        [[nodiscard]] EdgeLink side() const
        {
            const auto packed = static_cast<std::uint32_t>(packed_ >> 32);
            return EdgeLink(TriangleId(packed >> 2), packed & 3u);
        }
        [[nodiscard]] RegionId region() const { return RegionId(static_cast<std::uint32_t>(packed_)); }

    private:
        std::uint64_t packed_;
    };
    /// Scratch of the search.
    std::vector<PendingEdge> pending;
    std::vector<TriangleId> excluded;
};

/// Whether the star shape of a cavity, a theorem for exact predicates, is verified and repaired all the same.
enum class StarCheck
{
    Trust,
    Repair
};

/// Finds the triangles whose circumcircle holds the point and that can be reached from its place without crossing
/// a constrained edge; changes nothing.
/// Guarantees   the boundary is a star-shaped polygon around the point: every boundary edge turns counter-clockwise
///              around it (those of ghosts excepted)
/// Requires     a location of kind InTriangle, OnEdge or OutsideHull that `locate` gave for this point in this
///              state of a constrained Delaunay triangulation; a cavity has no vertex inside then, so the search
///              is the walk of a tree and needs no marks
/// Cost         linear in the size of the cavity, 6 edges expected
/// Reference    [bowyer1981] [watson1981]; thesis sections 1.2.2 and 1.2.4
void findCavity(const Triangulation2d& mesh, const StaticFilter2d& filter, Vec2 point,
                const Location2d& location, StarCheck check, Cavity2d& cavity);

/// Inserts the vertex, which must have the cavity's point for its position: the cavity becomes a fan around it. Cannot
/// fail. The mesh must be in the state in which the cavity was found.
/// Returns a triangle of the fan: the one that was connected last.
TriangleId commitCavity(Triangulation2d& mesh, const Cavity2d& cavity, VertexId vertex);

}  // namespace mesher
