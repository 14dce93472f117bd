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
        if (verdict.need != TetNeed::HeldBack && state_.criteria.isSink(tet))
            sinks_.push(tet, state_.mesh.generation(tet), verdict.key);
        return;
    }
    if (verdict.need == TetNeed::HeldBack) {
        heldBack_.push_back({tet, state_.mesh.generation(tet), verdict.key});
        return;
    }
    queueFor(verdict.need).push(tet, state_.mesh.generation(tet), verdict.key);
}

bool BadTetQueue::isCurrent(const Entry& entry) const
{
    return state_.mesh.generation(entry.id) == entry.generation && state_.isMeshed(entry.id);
}

std::size_t BadTetQueue::pushHeldBack()
{
    std::vector<Entry> waiting;
    waiting.swap(heldBack_);
    std::size_t count = 0;
    for (const Entry& entry : waiting) {
        if (!isCurrent(entry) || state_.judge(entry.id).need != TetNeed::Quality) continue;
        push(entry.id);
        ++count;
    }
    return count;
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
    return sinks_.popCurrent([&](const Entry& e) { return isCurrent(e); });
}

std::optional<BadTetQueue::Entry> BadTetQueue::take(TetNeed need)
{
    return queueFor(need).popCurrent([&](const Entry& e) {
        if (!isCurrent(e)) return false;
        const TetVerdict verdict = state_.judge(e.id);
        if (verdict.need == TetNeed::HeldBack) heldBack_.push_back(e);
        return verdict.need == need && verdict.key == e.key;
    });
}

}  // namespace mesher
