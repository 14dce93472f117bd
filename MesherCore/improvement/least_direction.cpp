#include "improvement/least_direction.h"

#include <algorithm>

namespace mesher {

Vec3 leastOfHull(std::span<const Vec3> gradients)
{
    constexpr int kSteps = 64;
    constexpr double kAccuracy = 0.05;  // of the squared length
    if (gradients.empty()) return {};
    Vec3 best = gradients.front();
    for (const Vec3& g : gradients) {
        if (squaredLength(g) < squaredLength(best)) best = g;
    }
    for (int step = 0; step < kSteps; ++step) {
        const double square = squaredLength(best);
        const Vec3* lowest = &gradients.front();
        for (const Vec3& g : gradients) {
            if (dot(g, best) < dot(*lowest, best)) lowest = &g;
        }
        const double gap = square - dot(*lowest, best);
        if (gap <= kAccuracy * square) break;
        const Vec3 side = *lowest - best;
        best = best + std::clamp(gap / squaredLength(side), 0.0, 1.0) * side;
    }
    return best;
}

}  // namespace mesher
