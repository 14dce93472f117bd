#include "predicates/coordinate_range.h"

#include <algorithm>
#include <cmath>
#include <string>

namespace mesher {

namespace {

constexpr double kLargestCoordinate = 0x1p200;
static_assert(kLargestExponent == 200 && kGridExponent == -200);

/// Doubles of at least this magnitude, 2^52 times the grid, are multiples of the grid.
constexpr double kAlwaysOnGrid = 0x1p-148;

double roundedToGrid(double coordinate)
{
    if (!(std::abs(coordinate) < kAlwaysOnGrid)) return coordinate;
    // The sum lies where the doubles are exactly the multiples of the grid.
    return std::copysign((std::abs(coordinate) + kAlwaysOnGrid) - kAlwaysOnGrid, coordinate);
}

bool isInExactRange(double coordinate)
{
    return std::abs(coordinate) <= kLargestCoordinate && roundedToGrid(coordinate) == coordinate;
}

double scaledToKernel(double coordinate, int exponent, std::size_t& roundedCoordinates)
{
    const double scaled = std::scalbn(coordinate, exponent);
    const double rounded = roundedToGrid(scaled);
    // Scaling itself rounds only far below the grid, where the result is rounded to zero in the end.
    if (rounded != scaled || (scaled == 0.0 && coordinate != 0.0)) ++roundedCoordinates;
    // Minus zero is the same point as zero; one spelling of it keeps output reproducible.
    return rounded == 0.0 ? 0.0 : rounded;
}

Error nonFinite(std::string entity)
{
    return {ErrorCode::NonFinitePoint, "a coordinate is infinite or not a number", std::move(entity),
            std::nullopt, "remove the point or repair the model"};
}

double largestMagnitude(const Vec2& p) { return std::max(std::abs(p.x), std::abs(p.y)); }
double largestMagnitude(const Vec3& p)
{
    return std::max(std::max(std::abs(p.x), std::abs(p.y)), std::abs(p.z));
}

/// The largest magnitude of a coordinate, or the first point with one that is not finite.
template <class Point>
Result<double> largestMagnitude(std::span<const Point> points)
{
    double largest = 0.0;
    for (std::size_t i = 0; i < points.size(); ++i) {
        if (!isFinite(points[i])) return nonFinite("point " + std::to_string(i));
        largest = std::max(largest, largestMagnitude(points[i]));
    }
    return largest;
}

template <class Box>
Result<double> largestMagnitudeOf(const Box& box)
{
    // An empty box is full of infinities, but a box with a NaN is not empty: it is refused.
    if (box.low == Box{}.low && box.high == Box{}.high) return 0.0;
    if (!isFinite(box.low) || !isFinite(box.high)) return nonFinite("box");
    return std::max(largestMagnitude(box.low), largestMagnitude(box.high));
}

}  // namespace

bool isInExactRange(const Vec2& p) { return isInExactRange(p.x) && isInExactRange(p.y); }
bool isInExactRange(const Vec3& p)
{
    return isInExactRange(p.x) && isInExactRange(p.y) && isInExactRange(p.z);
}

PowerOfTwoScaling::PowerOfTwoScaling(double largestMagnitude)
{
    if (largestMagnitude == 0.0) return;
    int exponentOfLargest = 0;
    static_cast<void>(std::frexp(largestMagnitude, &exponentOfLargest));
    exponent_ = kKernelExponent - exponentOfLargest;
}

Result<PowerOfTwoScaling> PowerOfTwoScaling::forBox(const Box2& box)
{
    const Result<double> largest = largestMagnitudeOf(box);
    if (!largest) return largest.error();
    return PowerOfTwoScaling(*largest);
}
Result<PowerOfTwoScaling> PowerOfTwoScaling::forBox(const Box3& box)
{
    const Result<double> largest = largestMagnitudeOf(box);
    if (!largest) return largest.error();
    return PowerOfTwoScaling(*largest);
}
Result<PowerOfTwoScaling> PowerOfTwoScaling::forPoints(std::span<const Vec2> points)
{
    const Result<double> largest = largestMagnitude(points);
    if (!largest) return largest.error();
    return PowerOfTwoScaling(*largest);
}
Result<PowerOfTwoScaling> PowerOfTwoScaling::forPoints(std::span<const Vec3> points)
{
    const Result<double> largest = largestMagnitude(points);
    if (!largest) return largest.error();
    return PowerOfTwoScaling(*largest);
}

Vec2 PowerOfTwoScaling::toKernel(const Vec2& p, std::size_t& roundedCoordinates) const
{
    return {scaledToKernel(p.x, exponent_, roundedCoordinates),
            scaledToKernel(p.y, exponent_, roundedCoordinates)};
}
Vec3 PowerOfTwoScaling::toKernel(const Vec3& p, std::size_t& roundedCoordinates) const
{
    return {scaledToKernel(p.x, exponent_, roundedCoordinates),
            scaledToKernel(p.y, exponent_, roundedCoordinates),
            scaledToKernel(p.z, exponent_, roundedCoordinates)};
}

Vec2 PowerOfTwoScaling::toModel(const Vec2& p) const
{
    return {std::scalbn(p.x, -exponent_), std::scalbn(p.y, -exponent_)};
}
Vec3 PowerOfTwoScaling::toModel(const Vec3& p) const
{
    return {std::scalbn(p.x, -exponent_), std::scalbn(p.y, -exponent_), std::scalbn(p.z, -exponent_)};
}

}  // namespace mesher
