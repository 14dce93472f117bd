#include "quality/triangle_measures.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace mesher {

namespace {

constexpr double kDegrees = 180.0 / std::numbers::pi;

}  // namespace

TriangleShape shapeOf(const TriangleCorners& corners)
{
    TriangleShape shape;
    const double doubleArea = length(doubleAreaVector(corners));
    std::array<double, 3> edge{};  // opposite to each corner
    for (std::size_t i = 0; i < 3; ++i) {
        const Vec3 toNext = corners[(i + 1) % 3] - corners[i];
        const Vec3 toPrevious = corners[(i + 2) % 3] - corners[i];
        edge[i] = length(corners[(i + 2) % 3] - corners[(i + 1) % 3]);
        shape.angle[i] = std::atan2(doubleArea, dot(toNext, toPrevious)) * kDegrees;
    }
    shape.area = 0.5 * doubleArea;
    const auto [minAngle, maxAngle] = std::minmax_element(shape.angle.begin(), shape.angle.end());
    shape.minAngle = *minAngle;
    shape.maxAngle = *maxAngle;
    const auto [shortest, longest] = std::minmax_element(edge.begin(), edge.end());
    shape.shortestEdge = *shortest;
    shape.longestEdge = *longest;
    // r = 2 A / (a + b + c), R = a b c / (4 A)
    const double denominator = edge[0] * edge[1] * edge[2] * (edge[0] + edge[1] + edge[2]);
    shape.radiusRatio = denominator > 0.0 ? 4.0 * doubleArea * doubleArea / denominator : 0.0;
    return shape;
}

}  // namespace mesher
