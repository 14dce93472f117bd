#include "delaunay/replay2d.h"

#include "delaunay/delaunay_check2d.h"

namespace mesher {

bool Replayer2d::apply(const ReplayOperation& operation)
{
    const VertexId first = vertexOf(operation.labels[0]);
    const VertexId second = vertexOf(operation.labels[1]);
    switch (operation.kind) {
        case ReplayKind::Insert: return insert(operation);
        case ReplayKind::Remove: return remove(operation.labels[0], RemovalPolicy::FreeVertices);
        case ReplayKind::RemoveFromChain:
            return remove(operation.labels[0], RemovalPolicy::StraightChainsToo);
        case ReplayKind::Constrain: return delaunay_.recoverSegment(first, second).hasValue();
        case ReplayKind::Unconstrain: return unconstrain(first, second);
    }
    return false;
}

VertexId Replayer2d::vertexOf(std::uint32_t label) const
{
    const auto found = vertices_.find(label);
    return found != vertices_.end() && delaunay_.mesh().isAlive(found->second) ? found->second : VertexId();
}

bool Replayer2d::insert(const ReplayOperation& operation)
{
    const auto inserted = delaunay_.insert({operation.coordinates[0], operation.coordinates[1]});
    if (!inserted) return false;
    vertices_[operation.labels[0]] = inserted->vertex;
    return inserted->outcome != InsertOutcome::Duplicate;
}

bool Replayer2d::remove(std::uint32_t label, RemovalPolicy policy)
{
    const VertexId vertex = vertexOf(label);
    if (!vertex.isValid() || delaunay_.remove(vertex, policy) != RemovalOutcome::Removed) return false;
    // The slot may be given to another vertex, which has other labels.
    std::erase_if(vertices_, [vertex](const auto& binding) { return binding.second == vertex; });
    return true;
}

bool Replayer2d::unconstrain(VertexId a, VertexId b)
{
    if (!a.isValid() || !b.isValid()) return false;
    const EdgeLink edge = delaunay_.mesh().findEdge(a, b);
    if (!edge.isValid() || !delaunay_.mesh().isConstrained(edge)) return false;
    delaunay_.unconstrainEdge(edge);
    return true;
}

Replay2dResult replay2d(const ReplayLog& log, std::size_t checkInterval)
{
    MESHER_PRECONDITION(checkInterval > 0);
    Replayer2d replayer;
    Replay2dResult result;
    for (const ReplayOperation& operation : log.operations()) {
        replayer.apply(operation);
        ++result.operationsDone;
        if (result.operationsDone % checkInterval != 0) continue;
        result.report = checkDelaunay2d(replayer.delaunay().mesh());
        if (!result.report.isValid()) return result;
    }
    result.report = checkDelaunay2d(replayer.delaunay().mesh());
    return result;
}

}  // namespace mesher
