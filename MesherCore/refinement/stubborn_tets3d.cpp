#include "refinement/stubborn_tets3d.h"

namespace mesher {

std::vector<TetId> StubbornTets::findFew(std::size_t most) const
{
    std::vector<TetId> bad;
    for (std::uint32_t i = 0; i < state_.mesh.tetLimit(); ++i) {
        if (!state_.isMeshed(TetId(i)) || state_.judge(TetId(i)).need != TetNeed::Quality) continue;
        if (bad.size() == most) return {};
        bad.push_back(TetId(i));
    }
    return bad;
}

Attempt StubbornTets::attempt(TetId tet)
{
    changed_.clear();
    insertion_.insist(true);
    const Attempt result = insertion_.attempt(tet);
    insertion_.insist(false);
    if (result == Attempt::Impossible && swap_.expel(tet, FacetSwap3d::kThin)) changed_ = swap_.changed();
    return result;
}

}  // namespace mesher
