#include "refinement/stubborn_tets3d.h"

#include "refinement/encroachment3d.h"

#include <algorithm>
#include <array>
#include <utility>

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
    Attempt result = insertion_.attempt(tet);
    insertion_.insist(false);
    if (result == Attempt::Impossible) result = insertion_.attemptNearer(tet);
    if (result != Attempt::Impossible) return result;
    if (pushOwnFacet(tet)) return Attempt::Rejected;
    if (swap_.expel(tet, swap_.mostHeight())) changed_ = swap_.changed();
    return Attempt::Impossible;
}

/// The largest one that may be split: of a tetrahedron along the surface its centre is nearly the circumcentre.
bool StubbornTets::pushOwnFacet(TetId tet)
{
    std::array<std::pair<double, TetFace>, 4> faces;
    for (int f = 0; f < 4; ++f) {
        const auto [a, b, c] = state_.mesh.faceVertices({tet, f});
        const auto ball = ProtectingBall::ofFacet(state_.mesh.position(a), state_.mesh.position(b),
                                                  state_.mesh.position(c));
        faces[static_cast<std::size_t>(f)] = {ball ? ball->squaredRadius : 0.0, TetFace(tet, f)};
    }
    std::stable_sort(faces.begin(), faces.end(),
                     [](const auto& a, const auto& b) { return a.first > b.first; });
    return std::any_of(faces.begin(), faces.end(), [&](const auto& face) {
        return state_.mesh.isFaceConstrained(face.second) && boundary_.pushFacetAt(face.second);
    });
}

}  // namespace mesher
