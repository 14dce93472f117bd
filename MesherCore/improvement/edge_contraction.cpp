#include "improvement/edge_contraction.h"

#include "improvement/dihedral_score.h"

#include <algorithm>
#include <limits>

namespace mesher {

namespace {

constexpr double kLongest = 1.3;

TetNodes withInstead(TetNodes v, NodeId old, NodeId other)
{
    *std::find(v.begin(), v.end(), old) = other;
    return v;
}

/// Of the tetrahedra that stay when the node is drawn into `target`; 0 when not more than `floor`.
double scoreInto(const TetComplex& complex, NodeId node, NodeId target, double floor)
{
    double least = std::numeric_limits<double>::infinity();
    for (const TetId t : complex.star(node)) {
        if (complex.hasNode(t, target)) continue;
        const TetNodes moved = withInstead(complex.nodes(t), node, target);
        least = std::min(least, dihedralScore(complex.corners(moved)));
        if (least <= floor) return 0.0;
    }
    return least;
}

}  // namespace

bool evaluateContraction(const TetComplex& complex, NodeId node, LocalChange& change)
{
    change.clear();
    if (!complex.isInside(node) || complex.node(node).entity.dimension != 3) return false;
    change.removed[0].assign(complex.star(node).begin(), complex.star(node).end());
    change.before = std::numeric_limits<double>::infinity();
    std::vector<NodeId> neighbours;
    double longest = 0.0;
    for (const TetId t : change.removed[0]) {
        change.before = std::min(change.before, complex.score(t));
        for (const NodeId n : complex.nodes(t)) {
            if (n == node || std::find(neighbours.begin(), neighbours.end(), n) != neighbours.end()) continue;
            neighbours.push_back(n);
            longest = std::max(longest, squaredLength(complex.position(n) - complex.position(node)));
        }
    }
    NodeId best;
    double floor = leastBetter(change.before);
    for (const NodeId target : neighbours) {
        const bool isTooLong = std::any_of(neighbours.begin(), neighbours.end(), [&](NodeId n) {
            return squaredLength(complex.position(n) - complex.position(target)) >
                   kLongest * kLongest * longest;
        });
        if (isTooLong) continue;
        const double score = scoreInto(complex, node, target, floor);
        if (score <= floor) continue;
        floor = score;
        best = target;
    }
    if (!best.isValid()) return false;
    for (const TetId t : change.removed[0]) {
        if (complex.hasNode(t, best)) continue;
        change.added[0].push_back(withInstead(complex.nodes(t), node, best));
        if (!complex.isPositive(change.added[0].back())) return false;
    }
    change.score = floor;
    change.gone.assign(1, node);
    return true;
}

}  // namespace mesher
