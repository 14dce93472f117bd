#include "triangulation2d/planar_domain.h"

#include <algorithm>
#include <cmath>

namespace mesher {
namespace {

// A domain of ordinary size is not scaled; at either limit the smallest difference the predicates resolve is still far
// below the rounding of its coordinates.
constexpr double kLargestUnscaled = 0x1p150;
constexpr double kSmallestUnscaled = 0x1p-60;
constexpr double kNegligible = 0x1p-147;

double onGrid(double coordinate) { return std::abs(coordinate) < kNegligible ? 0.0 : coordinate; }

double largestCoordinate(const Box2& box)
{
    return std::max({std::abs(box.low.x), std::abs(box.low.y), std::abs(box.high.x), std::abs(box.high.y)});
}

Error inputError(ErrorCode code, std::string entity, std::string message, std::string remedy)
{
    Error error;
    error.code = code;
    error.entity = std::move(entity);
    error.message = std::move(message);
    error.remedy = std::move(remedy);
    return error;
}

}  // namespace

Result<PlanarDomain> PlanarDomain::make(const PlanarCurveComplex& complex)
{
    PlanarDomain domain(complex);
    if (complex.curves.empty()) {
        return inputError(ErrorCode::DegenerateInput, "domain", "there are no curves",
                          "give the curves that bound the domain");
    }
    if (auto checked = domain.checkPoints(); !checked) return checked.error();
    domain.variations_.reserve(complex.curves.size());
    for (std::uint32_t i = 0; i < complex.curves.size(); ++i) {
        const PccCurve& curve = complex.curves[i];
        if (curve.curve == nullptr || curve.first.value >= complex.points.size() ||
            curve.last.value >= complex.points.size()) {
            return inputError(ErrorCode::InvalidArgument, "curve " + std::to_string(i),
                              "it has no geometry or no end point", "give both end points and a curve");
        }
        domain.variations_.emplace_back(curve.curve, curve.part);
    }
    domain.measure();
    for (std::uint32_t i = 0; i < complex.curves.size(); ++i) {
        if (auto checked = domain.checkCurve(PccCurveId(i)); !checked) return checked.error();
    }
    return domain;
}

Result<void> PlanarDomain::checkPoints() const
{
    for (std::uint32_t i = 0; i < complex_->points.size(); ++i) {
        const PccPoint& point = complex_->points[i];
        if (isFinite(point.position) && isFinite(point.spacePosition)) continue;
        return inputError(ErrorCode::NonFinitePoint, nameOf(PccPointId(i)),
                          "a coordinate is infinite or not a number", "repair the point");
    }
    for (const auto& embedded : complex_->embeddedPoints) {
        if (embedded.point.value < complex_->points.size()) continue;
        return inputError(ErrorCode::InvalidArgument, "embedded point", "it does not exist", "");
    }
    return {};
}

void PlanarDomain::measure()
{
    constexpr int kSamplesPerCurve = 16;
    for (const PccCurve& curve : complex_->curves) {
        for (int i = 0; i <= kSamplesPerCurve; ++i) {
            box_.include(
                complex_->frame.toPlane(curve.curve->position(curve.part.at(i / double{kSamplesPerCurve}))));
        }
    }
    for (const PccPoint& point : complex_->points) box_.include(point.position);
    const double largest = largestCoordinate(box_);
    if (largest > 0.0 && std::isfinite(largest) &&
        (largest > kLargestUnscaled || largest < kSmallestUnscaled)) {
        scale_ = std::ldexp(1.0, -std::ilogb(largest));
        box_ = {scale_ * box_.low, scale_ * box_.high};
    }
}

Result<void> PlanarDomain::checkCurve(PccCurveId id) const
{
    // CAD tolerances reach 1e-3 of a model; beyond that the curve does not belong to its point.
    constexpr double kLargestGap = 1e-2;
    const PccCurve& c = curve(id);
    const double curveLength = variation(id).totalLength();
    if (!std::isfinite(curveLength) || !std::isfinite(variation(id).totalVariation())) {
        return inputError(ErrorCode::NonFinitePoint, nameOf(id), "the curve has no finite length",
                          "trim or repair the curve");
    }
    if (!(curveLength > 0.0) || !(c.part.first < c.part.last)) {
        return inputError(ErrorCode::DegenerateInput, nameOf(id), "the curve has no length",
                          "remove the curve");
    }
    for (const auto& [point, t] : {std::pair(c.first, c.part.first), std::pair(c.last, c.part.last)}) {
        const double gap = length(place(point).position - place(id, t).position);
        if (gap <= kLargestGap * scale_ * curveLength) continue;
        Error error = inputError(ErrorCode::InvalidArgument, nameOf(id),
                                 "an end of the curve is away from its point", "close the gap");
        error.point = complex_->points[point.value].spacePosition;
        return error;
    }
    return {};
}

PlanarPlace PlanarDomain::place(PccPointId point) const
{
    const PccPoint& p = complex_->points[point.value];
    const Vec2 scaled = scale_ * p.position;
    return {{onGrid(scaled.x), onGrid(scaled.y)}, p.spacePosition};
}

PlanarPlace PlanarDomain::place(PccCurveId id, double t) const
{
    const Vec3 space = curve(id).curve->position(t);
    return {toTriangulation(space), space};
}

Vec2 PlanarDomain::toTriangulation(const Vec3& space) const
{
    const Vec2 scaled = scale_ * complex_->frame.toPlane(space);
    return {onGrid(scaled.x), onGrid(scaled.y)};
}

Vec2 PlanarDomain::directionInto(PccCurveId id, Interval span, CurveEnd end) const
{
    // A little inside, so that at a corner the derivative is that of this side.
    constexpr double kInside = 1e-9;
    const bool isFirst = end == CurveEnd::First;
    for (double inside = kInside; inside < 1.0; inside *= 100.0) {
        const double t = span.at(isFirst ? inside : 1.0 - inside);
        const Vec2 d = complex_->frame.directionToPlane(curve(id).curve->evaluate(t).d1);
        const double norm = length(d);
        if (norm > 0.0 && std::isfinite(norm)) return ((isFirst ? 1.0 : -1.0) / norm) * d;
    }
    const Vec2 chord = place(id, span.last).position - place(id, span.first).position;
    return ((isFirst ? 1.0 : -1.0) / length(chord)) * chord;
}

std::string PlanarDomain::nameOf(PccCurveId id) const
{
    const BrepEdgeId edge = curve(id).edge;
    return edge.isValid() ? mesher::nameOf(edge) : "curve " + std::to_string(id.value);
}

std::string PlanarDomain::nameOf(PccPointId id) const
{
    const BrepVertexId vertex = complex_->points[id.value].vertex;
    return vertex.isValid() ? mesher::nameOf(vertex) : "point " + std::to_string(id.value);
}

}  // namespace mesher
