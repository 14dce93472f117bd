#include "triangulation2d/visibility2d.h"

#include "predicates/orient2d.h"
#include "triangulation2d/boundary_intersection.h"

#include <algorithm>
#include <cmath>

namespace mesher {
namespace {

// Heights are differences of coordinates; below this fraction of the domain they are rounding.
constexpr double kHeightNoise = 4e-16;

/// The curve's height over its edge at a place along the edge: bisection, because the place grows with the parameter.
double heightAt(const PlanarDomain& domain, const Boundary& boundary, SubcurveId s, Vec2 direction,
                double along)
{
    const Subcurve& subcurve = boundary.subcurves[s];
    const Vec2 start = boundary.from(s);
    Interval bracket = subcurve.part;
    Vec2 offset;
    for (int step = 0; step < 60; ++step) {
        const double t = bracket.at(0.5);
        offset = domain.place(subcurve.curve, t).position - start;
        if (!(bracket.first < t && t < bracket.last)) break;
        (dot(offset, direction) < along ? bracket.first : bracket.last) = t;
    }
    return cross(direction, offset);
}

}  // namespace

CurveSide sideOfEdge(const Boundary& boundary, SubcurveId s, Vec2 point)
{
    switch (orient2d(boundary.from(s), boundary.to(s), point)) {
        case Sign::Positive: return CurveSide::Left;
        case Sign::Negative: return CurveSide::Right;
        default: return CurveSide::On;
    }
}

CurveSide sideOfSubcurve(const PlanarDomain& domain, const Boundary& boundary, SubcurveId s, Vec2 point)
{
    const CurveSide ofEdge = sideOfEdge(boundary, s, point);
    const Subcurve& subcurve = boundary.subcurves[s];
    const double turning =
        domain.variation(subcurve.curve).variation(subcurve.part.first, subcurve.part.last);
    const Vec2 edge = boundary.to(s) - boundary.from(s);
    const double edgeLength = length(edge);
    const Vec2 direction = (1.0 / edgeLength) * edge;
    const Vec2 offset = point - boundary.from(s);
    const double along = dot(offset, direction);
    const double height = cross(direction, offset);
    const Vec2 extent = domain.box().extent();
    const double noise =
        kHeightNoise * (std::max(extent.x, extent.y) + std::abs(point.x) + std::abs(point.y));
    // The tangents keep within the turning around the edge's direction, and so does the curve.
    const double reach = std::min(along, edgeLength - along);
    const double largest = turning < 1.5 ? std::max(reach, 0.0) * std::tan(turning) : edgeLength;
    if (std::abs(height) > largest + noise || largest < noise) return ofEdge;
    const double above = height - heightAt(domain, boundary, s, direction, along);
    if (std::abs(above) <= noise) return ofEdge;
    return above > 0.0 ? CurveSide::Left : CurveSide::Right;
}

bool Visibility2d::isVisible(BoundaryVertexId v, SubcurveId from)
{
    const Vec2 point = boundary_.position(v);
    const CurveSide ofEdge = sideOfEdge(boundary_, from, point);
    if (ofEdge == CurveSide::On) return true;
    const CurveSide ofCurve = sideOfSubcurve(domain_, boundary_, from, point);
    if (ofEdge != ofCurve) return true;
    const PccCurve& curve = domain_.curve(boundary_.subcurves[from].curve);
    const RegionId region = ofCurve == CurveSide::Left ? curve.left : curve.right;
    if (region.value == 0) return false;
    return !isSightBlocked(point, from);
}

bool Visibility2d::isSightBlocked(Vec2 point, SubcurveId from)
{
    const Vec2 a = boundary_.from(from);
    const Vec2 b = boundary_.to(from);
    Box2 box;
    for (const Vec2 corner : {a, b, point}) box.include(corner);
    index_.query(box, near_);
    bool isBlockedFromA = false;
    bool isBlockedFromB = false;
    for (const SubcurveId other : near_) {
        const Vec2 c = boundary_.from(other);
        const Vec2 d = boundary_.to(other);
        isBlockedFromA = isBlockedFromA || doSegmentsCross(a, point, c, d);
        isBlockedFromB = isBlockedFromB || doSegmentsCross(b, point, c, d);
        if (isBlockedFromA && isBlockedFromB) return true;
    }
    return false;
}

}  // namespace mesher
