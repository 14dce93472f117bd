#include "brep/occt/wire_order.h"

#include <limits>
#include <map>
#include <optional>
#include <utility>

namespace mesher {

namespace {

class WireOrder
{
public:
    WireOrder(const BrepModel& model, std::vector<BrepCoedge> coedges)
        : model_(model), coedges_(std::move(coedges)), isUsed_(coedges_.size(), false)
    {
        for (std::size_t i = 0; i < coedges_.size(); ++i) leaving_[vertexAt(i, false)].push_back(i);
    }

    OrderedWire run()
    {
        OrderedWire result;
        for (std::size_t start = 0; start < coedges_.size(); ++start) {
            if (isUsed_[start]) continue;
            BrepLoop loop;
            std::size_t last = start;
            for (std::optional<std::size_t> next = start; next; next = findNext(*next)) {
                isUsed_[*next] = true;
                loop.coedges.push_back(coedges_[*next]);
                last = *next;
            }
            if (vertexAt(last, true) != vertexAt(start, false)) result.openVertices.push_back(vertexAt(last, true));
            result.loops.push_back(std::move(loop));
        }
        return result;
    }

private:
    BrepVertexId vertexAt(std::size_t i, bool isHead) const
    {
        const BrepEdge& edge = model_.edges[coedges_[i].edge];
        return isHead != coedges_[i].isReversed ? edge.last : edge.first;
    }

    Vec2 parametersAt(std::size_t i, bool isHead) const
    {
        const BrepCoedge& coedge = coedges_[i];
        if (!coedge.parameterCurve) return {};
        const Interval part = model_.edges[coedge.edge].part;
        return coedge.parameterCurve->position(isHead != coedge.isReversed ? part.last : part.first);
    }

    std::optional<std::size_t> findNext(std::size_t i) const
    {
        const auto found = leaving_.find(vertexAt(i, true));
        if (found == leaving_.end()) return {};
        const Vec2 head = parametersAt(i, true);
        std::optional<std::size_t> best;
        double least = std::numeric_limits<double>::infinity();
        for (const std::size_t candidate : found->second) {
            if (isUsed_[candidate]) continue;
            const double distance = length(parametersAt(candidate, false) - head);
            if (!best || distance < least) {
                best = candidate;
                least = distance;
            }
        }
        return best;
    }

    const BrepModel& model_;
    std::vector<BrepCoedge> coedges_;
    std::vector<bool> isUsed_;
    std::map<BrepVertexId, std::vector<std::size_t>> leaving_;
};

}  // namespace

OrderedWire orderWire(const BrepModel& model, std::vector<BrepCoedge> coedges)
{
    return WireOrder(model, std::move(coedges)).run();
}

}  // namespace mesher
