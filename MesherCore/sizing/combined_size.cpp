#include "sizing/combined_size.h"

#include <algorithm>

namespace mesher {

double CombinedSize::sizeAt(const Vec3& point) const
{
    double size = cap_;
    for (const auto& field : fields_) size = std::min(size, field->sizeAt(point));
    return std::max(size, floor_);
}

double CombinedSize::smallestNear(const Vec3& centre, double radius) const
{
    double size = cap_;
    for (const auto& field : fields_) size = std::min(size, field->smallestNear(centre, radius));
    return std::max(size, floor_);
}

}  // namespace mesher
