#include "brep/analytic/simple_trims.h"

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
    return std::max(sideOf(uv.x, u_, tolerance_.x), sideOf(uv.y, v_, tolerance_.y));
}

TrimSide DiskTrim::classify(Vec2 uv) const
{
    return sideOf(radius_ - length(uv), tolerance_);
}

}  // namespace mesher
