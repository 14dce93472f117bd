#include "predicates/coordinate_range.h"

#include <cmath>

namespace mesher {

namespace {

constexpr double kLargestCoordinate = 0x1p200;

/// A double of magnitude 2^52 * 2^kGridExponent or more is a multiple of the grid; adding and taking away
/// 3/2 of that rounds a smaller one to it.
constexpr double kAlwaysOnGrid = 0x1p-148;
constexpr double kRounder = 1.5 * kAlwaysOnGrid;

double roundedToGrid(double coordinate)
{
    if (!(std::abs(coordinate) < kAlwaysOnGrid / 2)) return coordinate;
    return (coordinate + kRounder) - kRounder;
}

bool isInExactRange(double coordinate)
{
    return std::abs(coordinate) <= kLargestCoordinate && roundedToGrid(coordinate) == coordinate;
}

}  // namespace

bool isInExactRange(const Vec2& p) { return isInExactRange(p.x) && isInExactRange(p.y); }
bool isInExactRange(const Vec3& p) { return isInExactRange(p.x) && isInExactRange(p.y) && isInExactRange(p.z); }

}  // namespace mesher
