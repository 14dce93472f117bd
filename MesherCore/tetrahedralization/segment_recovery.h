#pragma once

#include "base/error.h"
#include "tetrahedralization/edge_crossing.h"
#include "tetrahedralization/flip_search.h"
#include "tetrahedralization/surface_constraints.h"

#include <optional>

namespace mesher {

enum class RecoveryStatus : std::uint8_t
{
    Recovered,
    Stuck,         ///< no operation helps
    Intersection,  ///< another constraint is in the way: the input intersects itself
    VertexInWay    ///< a vertex lies on the constraint
};

/// What is in the way of a constraint that intersects the input: a vertex, the ends of an edge or the corners of a face.
struct RecoveryObstacle
{
    std::array<VertexId, 3> vertex;
    Vec3 point;  ///< where they meet, in coordinates of the tetrahedralization
};

/// Recovers a missing edge by flips and edge removals along the line: each step has to lessen what the line passes through,
/// else it is taken back. A recovered edge is locked.
/// Terminates   always: the weight of the crossings falls
/// Reference    [gosselin] §3.3.3 "Edge Recovery by Swapping", with the search of [si2015]
class SegmentRecovery
{
public:
    SegmentRecovery(SurfaceConstraints& constraints, FlipSearch& flips)
        : constraints_(constraints), flips_(flips), crossings_(std::as_const(constraints).mesh())
    {
    }

    RecoveryStatus recover(VertexId a, VertexId b, int depth);

    /// Of the last call that did not recover.
    [[nodiscard]] const std::vector<EdgeCrossing>& crossings() const { return found_; }
    [[nodiscard]] const RecoveryObstacle& obstacle() const { return obstacle_; }

private:
    RecoveryStatus findObstacle(VertexId a, VertexId b);
    [[nodiscard]] static std::uint32_t weigh(const std::vector<EdgeCrossing>& crossings);
    bool improve(VertexId a, VertexId b, int depth);
    bool tryAt(const EdgeCrossing& crossing, VertexId a, VertexId b, VertexId apex, int depth);
    bool lessens(VertexId a, VertexId b, std::size_t mark);

    SurfaceConstraints& constraints_;
    FlipSearch& flips_;
    EdgeCrossings crossings_;
    std::vector<EdgeCrossing> found_;
    std::vector<EdgeCrossing> trial_;
    RecoveryObstacle obstacle_;
};

}  // namespace mesher
