#include "sizing/shape_sizes.h"

#include "sizing/distances.h"

#include <algorithm>
#include <cmath>

namespace mesher {

double DistanceProfile::at(double distance) const
{
    if (distance > reach) return kNoSize;
    return std::min(largest, size + growth * std::max(0.0, distance - plateau));
}

double BoxSize::smallestNear(const Vec3& centre, double radius) const
{
    return profile_.at(std::max(0.0, std::sqrt(squaredDistance(centre, box_)) - radius));
}

double BallSize::smallestNear(const Vec3& centre, double radius) const
{
    return profile_.at(std::max(0.0, length(centre - centre_) - radius_ - radius));
}

}  // namespace mesher
