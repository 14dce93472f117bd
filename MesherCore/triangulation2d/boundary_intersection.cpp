#include "triangulation2d/boundary_intersection.h"

#include "predicates/orient2d.h"

#include <algorithm>

namespace mesher {
namespace {

bool isBetween(Vec2 a, Vec2 b, Vec2 p)
{
    return std::min(a.x, b.x) <= p.x && p.x <= std::max(a.x, b.x) && std::min(a.y, b.y) <= p.y &&
           p.y <= std::max(a.y, b.y);
}

/// The point lies on the segment without being one of its ends.
bool isInside(Vec2 a, Vec2 b, Vec2 p)
{
    return p != a && p != b && isBetween(a, b, p) && orient2d(a, b, p) == Sign::Zero;
}

}  // namespace

bool doSegmentsCross(Vec2 a, Vec2 b, Vec2 c, Vec2 d)
{
    const Sign cSide = orient2d(a, b, c);
    if (cSide == Sign::Zero || orient2d(a, b, d) != -cSide) return false;
    const Sign aSide = orient2d(c, d, a);
    return aSide != Sign::Zero && orient2d(c, d, b) == -aSide;
}

bool doSegmentsMeet(Vec2 a, Vec2 b, Vec2 c, Vec2 d)
{
    return doSegmentsCross(a, b, c, d) || isInside(a, b, c) || isInside(a, b, d) || isInside(c, d, a) ||
           isInside(c, d, b);
}

std::vector<std::pair<SubcurveId, SubcurveId>> findIntersections(const Boundary& boundary,
                                                                 const BoundaryIndex& index)
{
    std::vector<std::pair<SubcurveId, SubcurveId>> result;
    std::vector<SubcurveId> near;
    for (std::uint32_t i = 0; i < boundary.subcurves.size(); ++i) {
        const SubcurveId s(i);
        if (!boundary.subcurves[s].isAlive) continue;
        Box2 box;
        box.include(boundary.from(s));
        box.include(boundary.to(s));
        index.query(box, near);
        for (const SubcurveId other : near) {
            if (s < other &&
                doSegmentsMeet(boundary.from(s), boundary.to(s), boundary.from(other), boundary.to(other))) {
                result.emplace_back(s, other);
            }
        }
    }
    return result;
}

}  // namespace mesher
