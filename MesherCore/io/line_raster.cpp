#include "io/line_raster.h"

#include <algorithm>
#include <cmath>

namespace mesher {

namespace {

double distanceToSegment(Vec2 p, Vec2 from, Vec2 direction, double squared)
{
    const double along = squared > 0.0 ? std::clamp(dot(p - from, direction) / squared, 0.0, 1.0) : 0.0;
    return length(p - (from + along * direction));
}

}  // namespace

PixelRange pixelsBetween(double low, double high, std::size_t count)
{
    const double limit = static_cast<double>(count);
    const double first = std::clamp(std::ceil(low - 0.5), 0.0, limit);
    const double last = std::clamp(std::floor(high - 0.5) + 1.0, first, limit);
    return {static_cast<std::size_t>(first), static_cast<std::size_t>(last)};
}

Colour mixed(Colour under, Colour over, double share)
{
    const auto mix = [share](std::uint8_t below, std::uint8_t above) {
        return static_cast<std::uint8_t>(std::lround((1.0 - share) * below + share * above));
    };
    return {mix(under.red, over.red), mix(under.green, over.green), mix(under.blue, over.blue)};
}

void drawLine(Image& image, Vec2 from, Vec2 to, double width, Colour colour, double opacity)
{
    const Vec2 direction = to - from;
    const double squared = squaredLength(direction);
    const double reach = 0.5 * width + 0.5;
    const PixelRange rows =
        pixelsBetween(std::min(from.y, to.y) - reach, std::max(from.y, to.y) + reach, image.height);
    for (std::size_t y = rows.first; y < rows.last; ++y) {
        const double centreY = static_cast<double>(y) + 0.5;
        double low = std::min(from.x, to.x);
        double high = std::max(from.x, to.x);
        if (std::abs(direction.y) > 1e-9) {
            // Of a slanted line only the part near this row is looked at.
            const double slope = direction.x / direction.y;
            const double spread = reach * (1.0 + std::abs(slope));
            const double middle = from.x + slope * (centreY - from.y);
            low = std::max(low, middle - spread);
            high = std::min(high, middle + spread);
        }
        const PixelRange columns = pixelsBetween(low - reach, high + reach, image.width);
        for (std::size_t x = columns.first; x < columns.last; ++x) {
            const Vec2 centre = {static_cast<double>(x) + 0.5, centreY};
            const double coverage = reach - distanceToSegment(centre, from, direction, squared);
            if (coverage <= 0.0) continue;
            image.at(x, y) = mixed(image.at(x, y), colour, opacity * std::min(coverage, 1.0));
        }
    }
}

void fillTriangle(Image& image, const std::array<Vec2, 3>& corners, Colour colour)
{
    const auto [lowX, highX] = std::minmax({corners[0].x, corners[1].x, corners[2].x});
    const auto [lowY, highY] = std::minmax({corners[0].y, corners[1].y, corners[2].y});
    const double turn = cross(corners[1] - corners[0], corners[2] - corners[0]) < 0.0 ? -1.0 : 1.0;
    const PixelRange rows = pixelsBetween(lowY, highY, image.height);
    const PixelRange columns = pixelsBetween(lowX, highX, image.width);
    for (std::size_t y = rows.first; y < rows.last; ++y) {
        for (std::size_t x = columns.first; x < columns.last; ++x) {
            const Vec2 centre = {static_cast<double>(x) + 0.5, static_cast<double>(y) + 0.5};
            bool isInside = true;
            for (std::size_t k = 0; k < 3; ++k) {
                isInside =
                    isInside && turn * cross(corners[(k + 1) % 3] - corners[k], centre - corners[k]) >= 0.0;
            }
            if (isInside) image.at(x, y) = colour;
        }
    }
}

}  // namespace mesher
