#include "improvement/face_removal.h"

#include "improvement/dihedral_score.h"

#include <algorithm>

namespace mesher {

namespace {

constexpr int kMostFaces = 6;

/// Grows the set of faces between two nodes from one of them, depth first, as long as the least score of the ring around
/// the new edge rises by it.
class FaceSet
{
public:
    FaceSet(const TetComplex& complex, NodeId above, NodeId below, double floor, LocalChange& change)
        : complex_(complex), above_(above), below_(below), floor_(floor), change_(change)
    {
    }

    /// False as soon as the floor is not exceeded.
    bool start(const FacetNodes& face, TetId upper, TetId lower)
    {
        addPair(upper, lower);
        for (std::size_t k = 0; k < 3; ++k) {
            const double value = addSide(face[k], face[(k + 1) % 3], upper, lower);
            change_.score = k == 0 ? value : std::min(change_.score, value);
            if (change_.score <= floor_) return false;
        }
        return true;
    }

private:
    void addPair(TetId upper, TetId lower)
    {
        change_.removed[0].push_back(upper);
        change_.removed[0].push_back(lower);
        ++faces_;
    }

    /// Closes the ring at a side of the last face, or goes on to the face behind it, whichever is better; returns the least score
    /// of the tetrahedra that come here.
    double addSide(NodeId p, NodeId q, TetId upper, TetId lower)
    {
        const TetNodes closing{p, q, below_, above_};
        const double closed = dihedralScore(complex_.corners(closing));
        const std::size_t removedBefore = change_.removed[0].size();
        const std::size_t addedBefore = change_.added[0].size();
        const double open = goOn(p, q, upper, lower, closed);
        if (open > closed) return open;
        faces_ -= static_cast<int>((change_.removed[0].size() - removedBefore) / 2);
        change_.removed[0].resize(removedBefore);
        change_.added[0].resize(addedBefore);
        change_.added[0].push_back(closing);
        return closed;
    }

    double goOn(NodeId p, NodeId q, TetId upper, TetId lower, double atLeast)
    {
        if (faces_ >= kMostFaces || complex_.isOnSurface(p, q)) return 0.0;
        const TetId nextUpper = complex_.tetBeside(p, q, above_, upper);
        const TetId nextLower = complex_.tetBeside(p, q, below_, lower);
        if (!nextUpper.isValid() || !nextLower.isValid() || nextUpper == nextLower) return 0.0;
        if (isTaken(nextUpper) || isTaken(nextLower)) return 0.0;
        const NodeId x = fourth(nextUpper, p, q, above_);
        if (x == below_ || x != fourth(nextLower, p, q, below_)) return 0.0;
        addPair(nextUpper, nextLower);
        const double first = addSide(p, x, nextUpper, nextLower);
        if (first <= atLeast) return 0.0;
        return std::min(first, addSide(x, q, nextUpper, nextLower));
    }

    [[nodiscard]] bool isTaken(TetId t) const
    {
        const auto& list = change_.removed[0];
        return std::find(list.begin(), list.end(), t) != list.end();
    }
    [[nodiscard]] NodeId fourth(TetId t, NodeId a, NodeId b, NodeId c) const
    {
        for (const NodeId n : complex_.nodes(t)) {
            if (n != a && n != b && n != c) return n;
        }
        return {};
    }

    const TetComplex& complex_;
    NodeId above_;
    NodeId below_;
    double floor_;
    LocalChange& change_;
    int faces_ = 0;
};

}  // namespace

bool evaluateFaceRemoval(const TetComplex& complex, TetId tet, std::size_t opposite, double floor,
                         LocalChange& change)
{
    change.clear();
    const FacetNodes face = complex.faceOf(tet, opposite);
    const TetId other = complex.tetBeside(face[0], face[1], face[2], tet);
    if (!other.isValid() || complex.isFacet(face)) return false;
    NodeId below;
    for (const NodeId n : complex.nodes(other)) {
        if (std::find(face.begin(), face.end(), n) == face.end()) below = n;
    }
    change.before = std::min(complex.score(tet), complex.score(other));
    FaceSet set(complex, complex.nodes(tet)[opposite], below, std::max(floor, leastBetter(change.before)),
                change);
    if (!set.start(face, tet, other)) return false;
    for (const TetId t : change.removed[0]) change.before = std::min(change.before, complex.score(t));
    return std::all_of(change.added[0].begin(), change.added[0].end(),
                       [&](const TetNodes& nodes) { return complex.isPositive(nodes); });
}

}  // namespace mesher
