#pragma once

#include "delaunay/check_report.h"
#include "delaunay/delaunay2d.h"
#include "delaunay/replay_log.h"

#include <cstddef>
#include <cstdint>
#include <unordered_map>

namespace mesher {

/// Does logged operations on a triangulation of its own. Operations on labels that are not bound are passed over, and
/// so is what the kernel refuses: both are without effect.
class Replayer2d
{
public:
    /// Whether the operation had an effect.
    bool apply(const ReplayOperation& operation);

    [[nodiscard]] const Delaunay2d& delaunay() const { return delaunay_; }
    /// An invalid id if the label is not bound, or its vertex was removed.
    [[nodiscard]] VertexId vertexOf(std::uint32_t label) const;

private:
    bool insert(const ReplayOperation& operation);
    bool remove(std::uint32_t label, RemovalPolicy policy);
    bool unconstrain(VertexId a, VertexId b);

    Delaunay2d delaunay_;
    std::unordered_map<std::uint32_t, VertexId> vertices_;
};

struct Replay2dResult
{
    std::size_t operationsDone = 0;
    /// Of the check after the last operation done.
    CheckReport report;
};

/// Does all operations of a log, checking the triangulation after each `checkInterval` of them and at the end; the first
/// check that fails ends the replay.
Replay2dResult replay2d(const ReplayLog& log, std::size_t checkInterval);

}  // namespace mesher
