#include "refinement/bad_tet_queue.h"

namespace mesher {

void BadTetQueue::endSinks()
{
    sinks_.clear();
    isSinkPhase_ = false;
}

void BadTetQueue::push(TetId tet)
{
    const TetVerdict verdict = state_.judge(tet);
    if (verdict.need == TetNeed::Nothing) return;
    if (isSinkPhase_) {
        if (state_.criteria.isSink(tet)) sinks_.push(tet, state_.mesh.generation(tet), verdict.key);
        return;
    }
    queueFor(verdict.need).push(tet, state_.mesh.generation(tet), verdict.key);
}

void BadTetQueue::pushAll()
{
    for (std::uint32_t i = 0; i < state_.mesh.tetLimit(); ++i) {
        if (state_.isMeshed(TetId(i))) push(TetId(i));
    }
}

void BadTetQueue::gradeAround(VertexId v)
{
    state_.scale.gradeAgainFrom(v, lowered_);
    for (const VertexId w : lowered_) pushStar(w);
}

void BadTetQueue::pushStar(VertexId v)
{
    state_.mesh.collectStar(v, star_);
    for (const TetId tet : star_) {
        if (state_.isMeshed(tet)) push(tet);
    }
}

std::optional<BadTetQueue::Entry> BadTetQueue::takeSink()
{
    return sinks_.popCurrent([&](const Entry& e) {
        return state_.mesh.generation(e.id) == e.generation && state_.isMeshed(e.id);
    });
}

std::optional<BadTetQueue::Entry> BadTetQueue::take(TetNeed need)
{
    return queueFor(need).popCurrent([&](const Entry& e) {
        if (state_.mesh.generation(e.id) != e.generation || !state_.isMeshed(e.id)) return false;
        const TetVerdict verdict = state_.judge(e.id);
        return verdict.need == need && verdict.key == e.key;
    });
}

}  // namespace mesher
