#pragma once

#include "base/random.h"
#include "tetrahedralization/coplanar_swap.h"
#include "tetrahedralization/edge_crossing.h"
#include "tetrahedralization/flip_search.h"
#include "tetrahedralization/surface_constraints.h"

#include <vector>

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

/// Recovers a missing edge by flips and edge removals along the line: a step has to lessen what the line passes through, or
/// be one of a limited number that only change it. A recovered edge is locked; if it fails, all is taken back.
/// Terminates   always: the weight of the crossings falls, but for that number of steps
/// Reference    [gosselin] §3.3.3 "Edge Recovery by Swapping", with the search of [si2015]
class SegmentRecovery
{
public:
    /// At the depth `maxDepth` it may add vertices beside the plane of edges that it swaps.
    SegmentRecovery(SurfaceConstraints& constraints, FlipSearch& flips, int maxDepth, std::uint64_t seed)
        : constraints_(constraints),
          flips_(flips),
          crossings_(std::as_const(constraints).mesh()),
          swap_(constraints.mesh(), flips),
          random_(seed),
          maxDepth_(maxDepth)
    {
    }

    RecoveryStatus recover(VertexId a, VertexId b, int depth);

    /// Of the last call that did not recover.
    [[nodiscard]] const std::vector<EdgeCrossing>& crossings() const { return found_; }
    [[nodiscard]] const RecoveryObstacle& obstacle() const { return obstacle_; }

private:
    RecoveryStatus findObstacle(VertexId a, VertexId b);
    void loosenFacets(VertexId a, VertexId b);
    [[nodiscard]] static std::uint32_t weigh(const std::vector<EdgeCrossing>& crossings);
    bool improve(VertexId a, VertexId b, int depth, std::uint32_t limit, std::uint32_t first);
    bool tryAt(const EdgeCrossing& crossing, VertexId a, VertexId b, VertexId apex, int depth,
               std::uint32_t limit);
    bool lessens(VertexId a, VertexId b, std::size_t mark, std::uint32_t limit);

    SurfaceConstraints& constraints_;
    FlipSearch& flips_;
    EdgeCrossings crossings_;
    CoplanarSwap swap_;
    std::vector<EdgeCrossing> found_;
    std::vector<EdgeCrossing> trial_;
    RecoveryObstacle obstacle_;
    Random random_;
    int maxDepth_;
};

}  // namespace mesher
