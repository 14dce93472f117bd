#include "sizing/sizing_field.h"

#include <algorithm>

namespace mesher {

double SizingField::smallestNear(const Vec3& centre, double radius) const
{
    double smallest = sizeAt(centre);
    for (const double offset : {-radius, radius}) {
        smallest =
            std::min({smallest, sizeAt(centre + Vec3{offset, 0.0, 0.0}),
                      sizeAt(centre + Vec3{0.0, offset, 0.0}), sizeAt(centre + Vec3{0.0, 0.0, offset})});
    }
    return smallest;
}

}  // namespace mesher
