#include "improvement/vertex_insertion.h"

#include <algorithm>

namespace mesher {

void VertexInsertion::collectAround(NodeId a, NodeId b)
{
    cavity_.clear();
    for (const TetId t : complex_.star(a)) {
        if (complex_.hasNode(t, b)) cavity_.push_back(t);
    }
}

/// The tetrahedron and those of its solid behind some of its faces.
void VertexInsertion::collectBehind(TetId tet, std::size_t first, std::size_t last)
{
    cavity_.assign(1, tet);
    for (std::size_t i = first; i < last; ++i) {
        const FacetNodes face = complex_.faceOf(tet, i);
        const TetId behind = complex_.tetBeside(face[0], face[1], face[2], tet);
        if (behind.isValid() && !complex_.isFacet(face)) cavity_.push_back(behind);
    }
}

/// False if the cavity is no use: it is a single tetrahedron, which is not said to be of one solid.
bool VertexInsertion::findHull()
{
    hull_.clear();
    for (const TetId t : cavity_) {
        for (std::size_t i = 0; i < 4; ++i) {
            const FacetNodes face = complex_.faceOf(t, i);
            const bool isInside = std::any_of(cavity_.begin(), cavity_.end(), [&](TetId other) {
                return other != t && complex_.hasNode(other, face[0]) && complex_.hasNode(other, face[1]) &&
                       complex_.hasNode(other, face[2]);
            });
            if (!isInside) hull_.push_back(face);
        }
    }
    return cavity_.size() > 1;
}

/// Nodes with all of their tetrahedra in the cavity: one with four may have been inside.
void VertexInsertion::collectEnclosed(std::vector<NodeId>& enclosed) const
{
    enclosed.clear();
    for (const TetId t : cavity_) {
        for (const NodeId n : complex_.nodes(t)) {
            const bool isOnHull = std::any_of(hull_.begin(), hull_.end(), [n](const FacetNodes& face) {
                return std::find(face.begin(), face.end(), n) != face.end();
            });
            if (!isOnHull && std::find(enclosed.begin(), enclosed.end(), n) == enclosed.end())
                enclosed.push_back(n);
        }
    }
}

void VertexInsertion::tryCavity(double target, LocalChange& change)
{
    if (!findHull()) return;
    double before = 1.0;
    for (const TetId t : cavity_) before = std::min(before, complex_.score(t));
    const double floor = std::max(change.score, leastBetter(before));
    if (!smoothing_.evaluateNew(hull_, target) || smoothing_.score() <= floor) return;
    change.removed[0] = cavity_;
    change.added[0].clear();
    for (const FacetNodes& face : hull_) change.added[0].push_back({face[0], face[1], face[2], NodeId()});
    collectEnclosed(change.gone);
    change.before = before;
    change.score = smoothing_.score();
    change.inserted = smoothing_.move().position;
}

bool VertexInsertion::evaluate(TetId tet, double floor, double target, LocalChange& change)
{
    change.clear();
    change.score = floor;
    const TetNodes v = complex_.nodes(tet);
    for (const auto& [i, j] : kTetEdgeCorners) {
        if (complex_.isOnSurface(v[i], v[j])) continue;
        collectAround(v[i], v[j]);
        tryCavity(target, change);
    }
    for (std::size_t i = 0; i < 4; ++i) {
        collectBehind(tet, i, i + 1);
        tryCavity(target, change);
    }
    collectBehind(tet, 0, 4);
    tryCavity(target, change);
    return change.inserted.has_value();
}

}  // namespace mesher
