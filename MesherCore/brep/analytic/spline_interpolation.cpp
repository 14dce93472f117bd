#include "brep/analytic/spline_interpolation.h"

#include "brep/analytic/bspline_basis.h"

#include <algorithm>
#include <utility>
#include <vector>

namespace mesher {

namespace {

struct TridiagonalRow
{
    double below = 0.0;
    double diagonal = 1.0;
    double above = 0.0;
    Vec3 right;
};

/// Thomas' algorithm; the rows of spline interpolation are diagonally dominant enough to need no pivots.
std::vector<Vec3> solve(std::vector<TridiagonalRow> rows)
{
    for (std::size_t i = 1; i < rows.size(); ++i) {
        const double factor = rows[i].below / rows[i - 1].diagonal;
        rows[i].diagonal -= factor * rows[i - 1].above;
        rows[i].right = rows[i].right - factor * rows[i - 1].right;
    }
    std::vector<Vec3> solution(rows.size());
    for (std::size_t i = rows.size(); i-- > 0;) {
        const Vec3 known = i + 1 < rows.size() ? rows[i].above * solution[i + 1] : Vec3{};
        solution[i] = (1.0 / rows[i].diagonal) * (rows[i].right - known);
    }
    return solution;
}

std::vector<double> knotsOfChords(std::span<const Vec3> points)
{
    std::vector<double> knots(4, 0.0);
    for (std::size_t i = 1; i < points.size(); ++i) {
        knots.push_back(knots.back() + length(points[i] - points[i - 1]));
    }
    knots.insert(knots.end(), 3, knots.back());
    return knots;
}

/// The condition for the pole beside an end: `near` and `far` are the lengths of the end's span and of its two spans.
TridiagonalRow endRow(const Vec3& endPoint, const std::optional<Vec3>& outwardDerivative, double near, double far)
{
    if (outwardDerivative) return {0.0, 1.0, 0.0, endPoint - (near / 3.0) * *outwardDerivative};
    return {0.0, 1.0 / near + 1.0 / far, -1.0 / far, (1.0 / near) * endPoint};
}

}  // namespace

Result<std::shared_ptr<const BSplineCurve>> interpolateCubic(std::span<const Vec3> points, const SplineEnds& ends)
{
    const Error few{ErrorCode::InvalidArgument, "an interpolating spline needs three points", "spline", {}, ""};
    if (points.size() < 3) return few;
    for (std::size_t i = 0; i < points.size(); ++i) {
        const std::string name = "point " + std::to_string(i + 1);
        if (!isFinite(points[i])) return Error{ErrorCode::NonFinitePoint, "a coordinate is not finite", name, {}, ""};
        if (i > 0 && points[i] == points[i - 1]) {
            return Error{ErrorCode::DuplicatePoint, "it equals the point before", name, points[i], "remove one"};
        }
    }
    const std::size_t last = points.size() - 1;
    BSplineData data;
    data.knots = knotsOfChords(points);
    const std::vector<double>& t = data.knots;
    std::optional<Vec3> outwardFirst;
    if (ends.firstTangent) outwardFirst = -1.0 * *ends.firstTangent;

    // One row per pole 1 … last + 1; poles 0 and last + 2 are the end points.
    std::vector<TridiagonalRow> rows(last + 1);
    rows.front() = endRow(points.front(), outwardFirst, t[4] - t[3], t[5] - t[3]);
    for (std::size_t i = 1; i < last; ++i) {
        const BSplineBasis basis = evaluateBasis(t, 3, t[i + 3]);
        rows[i] = {basis.value[0], basis.value[1], basis.value[2], points[i]};
    }
    rows.back() = endRow(points.back(), ends.lastTangent, t[last + 3] - t[last + 2], t[last + 3] - t[last + 1]);
    std::swap(rows.back().below, rows.back().above);

    const std::vector<Vec3> inner = solve(std::move(rows));
    data.poles.push_back(points.front());
    data.poles.insert(data.poles.end(), inner.begin(), inner.end());
    data.poles.push_back(points.back());
    return BSplineCurve::make(std::move(data));
}

}  // namespace mesher
