#include "sizing/shape_sizes.h"

#include <algorithm>

namespace mesher {

double DistanceProfile::at(double distance) const
{
    if (distance > reach) return kNoSize;
    return std::min(largest, size + growth * std::max(0.0, distance - plateau));
}

double BoxSize::smallestNear(const Vec3& centre, double radius) const
{
    const Vec3 outside{std::max({box_.low.x - centre.x, 0.0, centre.x - box_.high.x}),
                       std::max({box_.low.y - centre.y, 0.0, centre.y - box_.high.y}),
                       std::max({box_.low.z - centre.z, 0.0, centre.z - box_.high.z})};
    return profile_.at(std::max(0.0, length(outside) - radius));
}

double BallSize::smallestNear(const Vec3& centre, double radius) const
{
    return profile_.at(std::max(0.0, length(centre - centre_) - radius_ - radius));
}

}  // namespace mesher
