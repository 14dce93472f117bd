#include "triangulation2d/boundary_index.h"

#include <algorithm>
#include <boost/geometry/geometries/box.hpp>
#include <boost/geometry/geometries/point_xy.hpp>
#include <boost/geometry/geometry.hpp>
#include <boost/geometry/index/rtree.hpp>
#include <iterator>
#include <utility>

namespace mesher {
namespace {

namespace bg = boost::geometry;

using TreePoint = bg::model::d2::point_xy<double>;
using TreeBox = bg::model::box<TreePoint>;
using TreeValue = std::pair<TreeBox, std::uint32_t>;

TreeBox circleBox(const Boundary& boundary, SubcurveId s)
{
    const Vec2 a = boundary.from(s);
    const Vec2 b = boundary.to(s);
    const Vec2 centre = 0.5 * (a + b);
    // A little more than half the length, so that rounding hides no point of the circle.
    const double radius = 0.5000001 * length(b - a);
    return {{centre.x - radius, centre.y - radius}, {centre.x + radius, centre.y + radius}};
}

std::vector<TreeValue> allValues(const Boundary& boundary)
{
    std::vector<TreeValue> values;
    for (std::uint32_t i = 0; i < boundary.subcurves.size(); ++i) {
        if (boundary.subcurves[SubcurveId(i)].isAlive)
            values.emplace_back(circleBox(boundary, SubcurveId(i)), i);
    }
    return values;
}

}  // namespace

struct BoundaryIndex::Tree
{
    bg::index::rtree<TreeValue, bg::index::quadratic<16>> values;
};

BoundaryIndex::BoundaryIndex(const Boundary& boundary)
    : tree_(new Tree{bg::index::rtree<TreeValue, bg::index::quadratic<16>>(allValues(boundary))})
{
}

BoundaryIndex::~BoundaryIndex() = default;

void BoundaryIndex::insert(const Boundary& boundary, SubcurveId s)
{
    tree_->values.insert({circleBox(boundary, s), s.value});
}

void BoundaryIndex::remove(const Boundary& boundary, SubcurveId s)
{
    tree_->values.remove({circleBox(boundary, s), s.value});
}

void BoundaryIndex::query(const Box2& box, std::vector<SubcurveId>& found) const
{
    found.clear();
    const TreeBox treeBox({box.low.x, box.low.y}, {box.high.x, box.high.y});
    for (auto it = tree_->values.qbegin(bg::index::intersects(treeBox)); it != tree_->values.qend(); ++it) {
        found.push_back(SubcurveId(it->second));
    }
    std::sort(found.begin(), found.end());
}

}  // namespace mesher
