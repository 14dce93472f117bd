#include "brep/analytic/bspline_curve.h"

#include "brep/analytic/bspline_basis.h"
#include "brep/curve_projection.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

namespace mesher {

namespace {

Error invalid(std::string message)
{
    return Error{ErrorCode::InvalidArgument, std::move(message), "spline", {}, "correct its poles, weights and knots"};
}

std::optional<Error> findFault(const BSplineData& data)
{
    if (data.degree < 1 || data.degree > kHighestDegree) return invalid("the degree is not within 1 … 25");
    if (data.poles.size() < data.degree + 1) return invalid("there are fewer poles than the degree needs");
    if (data.knots.size() != data.poles.size() + data.degree + 1) {
        return invalid("the count of knots is not poles + degree + 1");
    }
    if (!data.weights.empty() && data.weights.size() != data.poles.size()) {
        return invalid("the count of weights is not that of the poles");
    }
    const auto isBadWeight = [](double w) { return !(w > 0.0 && std::isfinite(w)); };
    if (std::any_of(data.weights.begin(), data.weights.end(), isBadWeight)) {
        return invalid("a weight is not positive and finite");
    }
    if (!std::all_of(data.poles.begin(), data.poles.end(), [](const Vec3& p) { return isFinite(p); })) {
        return invalid("a pole is not finite");
    }
    for (std::size_t i = 0; i < data.knots.size(); ++i) {
        if (!std::isfinite(data.knots[i])) return invalid("a knot is not finite");
        if (i > 0 && data.knots[i] < data.knots[i - 1]) return invalid("the knots descend");
    }
    if (!(data.knots[data.degree] < data.knots[data.poles.size()])) return invalid("the knots span no range");
    if (!interiorKnots(data.knots, data.degree, data.degree + 1).empty()) {
        return invalid("an interior knot is repeated more often than the degree");
    }
    return {};
}

}  // namespace

Result<std::shared_ptr<const BSplineCurve>> BSplineCurve::make(BSplineData data)
{
    if (std::optional<Error> fault = findFault(data)) return *std::move(fault);
    return std::make_shared<const BSplineCurve>(std::move(data));
}

Result<std::shared_ptr<const BSplineCurve>> BSplineCurve::makeBezier(std::vector<Vec3> poles,
                                                                     std::vector<double> weights)
{
    BSplineData data;
    if (poles.size() < 2) return invalid("a Bézier curve needs two poles");
    data.degree = poles.size() - 1;
    data.knots.assign(poles.size(), 0.0);
    data.knots.insert(data.knots.end(), poles.size(), 1.0);
    data.poles = std::move(poles);
    data.weights = std::move(weights);
    return make(std::move(data));
}

BSplineCurve::BSplineCurve(BSplineData validData) : data_(std::move(validData))
{
    const std::size_t notTwice = data_.degree > 2 ? data_.degree - 1 : 1;
    breaks_ = mesher::interiorKnots(data_.knots, data_.degree, notTwice);
    interiorKnots_ = mesher::interiorKnots(data_.knots, data_.degree, 1);
}

CurveKind BSplineCurve::kind() const
{
    return interiorKnots_.empty() ? CurveKind::Bezier : CurveKind::BSpline;
}

Interval BSplineCurve::range() const
{
    return {data_.knots[data_.degree], data_.knots[data_.poles.size()]};
}

Vec3 BSplineCurve::position(double t) const
{
    return evaluate(t).position;
}

CurvePoint BSplineCurve::evaluate(double t) const
{
    const BSplineBasis basis = evaluateBasis(data_.knots, data_.degree, range().clamp(t));
    CurvePoint sum;
    double w = 0.0, w1 = 0.0, w2 = 0.0;
    for (std::size_t i = 0; i <= data_.degree; ++i) {
        const double weight = data_.weights.empty() ? 1.0 : data_.weights[basis.first + i];
        const Vec3 pole = weight * data_.poles[basis.first + i];
        sum.position = sum.position + basis.value[i] * pole;
        sum.d1 = sum.d1 + basis.d1[i] * pole;
        sum.d2 = sum.d2 + basis.d2[i] * pole;
        w += basis.value[i] * weight;
        w1 += basis.d1[i] * weight;
        w2 += basis.d2[i] * weight;
    }
    if (data_.weights.empty()) return sum;
    CurvePoint point;
    point.position = (1.0 / w) * sum.position;
    point.d1 = (1.0 / w) * (sum.d1 - w1 * point.position);
    point.d2 = (1.0 / w) * (sum.d2 - 2.0 * w1 * point.d1 - w2 * point.position);
    return point;
}

CurveProjection BSplineCurve::project(const Vec3& point, Interval part, std::optional<double> seed) const
{
    if (seed) return projectFromSeed(*this, point, part, *seed);
    const int perPiece = 2 * static_cast<int>(data_.degree) + 2;
    return projectOnCurve(*this, point, projectionStations(*this, part, perPiece));
}

}  // namespace mesher
