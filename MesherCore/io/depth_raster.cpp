#include "io/depth_raster.h"

#include "io/line_raster.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace mesher {

namespace {

/// The three distances from the lines along the edges (negative outside), and the depth, as linear functions of the place.
class TriangleFunctions
{
public:
    explicit TriangleFunctions(const std::array<Vec3, 3>& corner)
    {
        const Vec2 origin = {corner[0].x, corner[0].y};
        const Vec2 first = Vec2{corner[1].x, corner[1].y} - origin;
        const Vec2 second = Vec2{corner[2].x, corner[2].y} - origin;
        area_ = cross(first, second);
        if (isSeenEdgeOn()) return;
        const double turn = area_ < 0.0 ? -1.0 : 1.0;
        for (std::size_t k = 0; k < 3; ++k) {
            from_[k] = {corner[k].x, corner[k].y};
            const Vec2 to = {corner[(k + 1) % 3].x, corner[(k + 1) % 3].y};
            direction_[k] = (turn / length(to - from_[k])) * (to - from_[k]);
        }
        const double rise1 = corner[1].z - corner[0].z;
        const double rise2 = corner[2].z - corner[0].z;
        slope_ = {(rise1 * second.y - rise2 * first.y) / area_, (rise2 * first.x - rise1 * second.x) / area_};
        depth_ = corner[0].z;
    }

    [[nodiscard]] bool isSeenEdgeOn() const { return !(std::abs(area_) > 1e-9); }
    [[nodiscard]] double distance(std::size_t edge, Vec2 place) const
    {
        return cross(direction_[edge], place - from_[edge]);
    }
    [[nodiscard]] double depth(Vec2 place) const { return depth_ + dot(slope_, place - from_[0]); }

private:
    double area_ = 0.0;
    std::array<Vec2, 3> from_{};
    std::array<Vec2, 3> direction_{};
    Vec2 slope_;
    double depth_ = 0.0;
};

/// The triangle's own colour, or that of the line the place lies on; the widest line where several meet.
Colour colourAt(const RasterTriangle& triangle, const std::array<double, 3>& distance)
{
    double widest = 0.0;
    Colour colour = triangle.colour;
    for (std::size_t k = 0; k < 3; ++k) {
        if (triangle.lineWidth[k] <= widest || distance[k] > triangle.lineWidth[k]) continue;
        widest = triangle.lineWidth[k];
        colour = mixed(triangle.colour, triangle.lineColour[k], triangle.lineOpacity[k]);
    }
    return colour;
}

}  // namespace

DepthRaster::DepthRaster(std::size_t width, std::size_t height, Colour background)
    : image_(width, height, background), depth_(width * height, -std::numeric_limits<float>::infinity())
{
}

void DepthRaster::draw(const RasterTriangle& triangle)
{
    const TriangleFunctions functions(triangle.corner);
    if (functions.isSeenEdgeOn()) return;
    const auto& [a, b, c] = triangle.corner;
    const PixelRange rows =
        pixelsBetween(std::min({a.y, b.y, c.y}), std::max({a.y, b.y, c.y}), image_.height);
    const PixelRange columns =
        pixelsBetween(std::min({a.x, b.x, c.x}), std::max({a.x, b.x, c.x}), image_.width);
    for (std::size_t y = rows.first; y < rows.last; ++y) {
        for (std::size_t x = columns.first; x < columns.last; ++x) {
            const Vec2 centre = {static_cast<double>(x) + 0.5, static_cast<double>(y) + 0.5};
            std::array<double, 3> distance{};
            for (std::size_t k = 0; k < 3; ++k) distance[k] = functions.distance(k, centre);
            if (*std::min_element(distance.begin(), distance.end()) < 0.0) continue;
            float& nearest = depth_[y * image_.width + x];
            const auto depth = static_cast<float>(functions.depth(centre));
            if (depth <= nearest) continue;
            nearest = depth;
            image_.at(x, y) = colourAt(triangle, distance);
        }
    }
}

Image DepthRaster::reduced(std::size_t factor) const
{
    Image small(image_.width / factor, image_.height / factor, {});
    for (std::size_t y = 0; y < small.height; ++y) {
        for (std::size_t x = 0; x < small.width; ++x) {
            std::array<std::size_t, 3> sum{};
            for (std::size_t i = 0; i < factor * factor; ++i) {
                const Colour& pixel = image_.at(x * factor + i % factor, y * factor + i / factor);
                sum[0] += pixel.red;
                sum[1] += pixel.green;
                sum[2] += pixel.blue;
            }
            const auto mean = [&](std::size_t k) {
                return static_cast<std::uint8_t>((sum[k] + factor * factor / 2) / (factor * factor));
            };
            small.at(x, y) = {mean(0), mean(1), mean(2)};
        }
    }
    return small;
}

}  // namespace mesher
