#include "brep/analytic/simple_trims.h"

#include "brep/analytic/periodic.h"

#include <algorithm>

namespace mesher {

namespace {

TrimSide sideOf(double depth, double tolerance)
{
    if (depth > tolerance) return TrimSide::Inside;
    return depth < -tolerance ? TrimSide::Outside : TrimSide::OnBoundary;
}

TrimSide sideOf(double value, Interval range, double tolerance)
{
    return sideOf(std::min(value - range.first, range.last - value), tolerance);
}

}  // namespace

TrimSide RectangleTrim::classify(Vec2 uv) const
{
    // The enumerators go from inside to outside.
    const double u = periods_.x > 0.0 ? wrapInto(uv.x, u_.first - tolerance_.x, periods_.x) : uv.x;
    const double v = periods_.y > 0.0 ? wrapInto(uv.y, v_.first - tolerance_.y, periods_.y) : uv.y;
    return std::max(sideOf(u, u_, tolerance_.x), sideOf(v, v_, tolerance_.y));
}

TrimSide DiskTrim::classify(Vec2 uv) const
{
    return sideOf(radius_ - length(uv), tolerance_);
}

}  // namespace mesher
