#pragma once

#include "refinement/bad_tet_queue.h"
#include "refinement/boundary_queue3d.h"
#include "refinement/encroachment3d.h"
#include "refinement/refinement_state3d.h"

#include <cstdint>
#include <optional>

namespace mesher {

enum class Attempt : std::uint8_t
{
    Inserted,
    Rejected,  ///< something of the boundary was queued: try again when it is split
    Impossible
};

/// Coordinates next to zero become zero, so that all of them are on the grid of the exact range.
[[nodiscard]] Vec3 onGrid(const Vec3& p);

/// Inserts the circumcentre of a tetrahedron, or queues what of the boundary it would encroach upon.
/// Guarantees   what is inserted lies in the tetrahedron's region; new tetrahedra that need something are queued
/// Reference    [gosselin] sections 4.3 and 4.7.2
class CircumcentreInsertion
{
public:
    CircumcentreInsertion(RefinementState3d& state, BadTetQueue& badTets, BoundaryQueue3d& boundary)
        : state_(state), badTets_(badTets), boundary_(boundary)
    {
    }

    Attempt attempt(TetId tet);
    /// Inserts a point between the circumcentre and the centroid that encroaches upon nothing and leaves room around it, if any of a
    /// few does: where what the circumcentre encroaches upon is not split.
    Attempt attemptNearer(TetId tet);
    /// Whether edges may get shorter at angles that are not very small: for a few tetrahedra at the end.
    void insist(bool isInsisting) { isInsisting_ = isInsisting; }
    /// What of the model kept the last attempt from inserting anything; none if that was something inside.
    [[nodiscard]] EntityRef inTheWay() const { return inTheWay_; }

private:
    static constexpr double kLeastInsisted = 25.0;  // degrees

    Attempt attemptAt(TetId tet, const Vec3& point);
    Attempt insertShortOf(TetId tet, const Vec3& centre);
    Attempt reject(TetId tet, const Encroached3d& encroached);
    void insert(RegionId region, bool isRepaired);
    [[nodiscard]] double crossingOf(TetFace face, const Vec3& start, const Vec3& end) const;
    [[nodiscard]] double roomOf(TetId tet) const;
    [[nodiscard]] bool hasRoomAtCorners(TetId tet, const Vec3& point) const;
    [[nodiscard]] std::optional<std::uint32_t> fanCrowdedBy(const Cavity3d& cavity) const;
    Attempt insertCentreOf(std::uint32_t fan, TetId tet);
    [[nodiscard]] bool hasRoom(const Cavity3d& cavity, TetId tet) const;
    [[nodiscard]] bool makesFlatter(const Cavity3d& cavity, TetId tet) const;
    bool wouldShrink(TetId tet, std::span<const VertexId> entity);
    [[nodiscard]] double shortestSquaredEdge(TetId tet) const;

    RefinementState3d& state_;
    BadTetQueue& badTets_;
    BoundaryQueue3d& boundary_;
    EntityRef inTheWay_;
    bool isInsisting_ = false;
};

}  // namespace mesher
