#include "io/draw_space.h"

#include "io/depth_raster.h"
#include "io/picture_style.h"
#include "io/visible_facets.h"

#include <algorithm>
#include <cmath>
#include <span>
#include <utility>
#include <vector>

namespace mesher {

namespace {

constexpr Vec3 kTowardsEye = {1.0, -1.2, 0.9};
constexpr double kShade = 0.45;            // light on facets turned away from the lamp
constexpr double kMostSamples = 64e6;      // pixels before the picture is made smaller
constexpr std::size_t kLargestFactor = 3;  // of samples along each side of a pixel
constexpr std::array<Colour, 4> kSolidColours = {
    {{232, 176, 92}, {140, 190, 120}, {196, 150, 196}, {216, 138, 120}}};

using NodePair = std::pair<NodeId, NodeId>;

class SpaceDrawing
{
public:
    SpaceDrawing(const ClassifiedMesh& mesh, const DrawingOptions& options)
        : mesh_(mesh), options_(options), view_(viewAlong(kTowardsEye))
    {
        for (const MeshNode& node : mesh.nodes) box_.include(view_.projected(node.position));
        for (const MeshElement<2>& line : mesh.lines)
            lines_.push_back(std::minmax(line.node[0], line.node[1]));
        std::sort(lines_.begin(), lines_.end());
    }

    /// A picture of this width, in which the whole mesh has room.
    [[nodiscard]] Image draw(std::span<const VisibleFacet> facets, std::size_t width)
    {
        const Vec2 extent = box_.extent();
        const double largest = std::max(extent.x, extent.y);
        const double room = std::max(static_cast<double>(width) - 2.0 * kMargin, 1.0);
        const double scale = largest > 0.0 ? room / largest : 1.0;
        const auto height = static_cast<std::size_t>(std::ceil(extent.y * scale + 2.0 * kMargin));
        factor_ = kLargestFactor;
        while (factor_ > 1 && static_cast<double>(width * height * factor_ * factor_) > kMostSamples)
            --factor_;
        samples_ = scale * static_cast<double>(factor_);
        origin_ = {0.5 * (static_cast<double>(width * factor_) - samples_ * (box_.low.x + box_.high.x)),
                   0.5 * (static_cast<double>(height * factor_) + samples_ * (box_.low.y + box_.high.y))};
        DepthRaster raster(width * factor_, height * factor_, kBackground);
        const double opacity = edgeOpacity(facets, scale);
        for (const VisibleFacet& facet : facets) raster.draw(onPicture(facet, opacity));
        return raster.reduced(factor_);
    }

private:
    [[nodiscard]] Vec3 onPicture(NodeId node) const
    {
        const Vec3& p = mesh_.nodes[node].position;
        const Vec2 q = samples_ * view_.projected(p);
        return {origin_.x + q.x, origin_.y - q.y, samples_ * dot(p, view_.towardsEye)};
    }

    [[nodiscard]] Vec3 normalOf(const VisibleFacet& facet) const
    {
        const Vec3& origin = mesh_.nodes[facet.node[0]].position;
        return cross(mesh_.nodes[facet.node[1]].position - origin,
                     mesh_.nodes[facet.node[2]].position - origin);
    }

    /// From the side that the eye sees, by a lamp to the left of it and above.
    [[nodiscard]] double lightOn(const VisibleFacet& facet) const
    {
        const Vec3 lamp = view_.towardsEye + 0.5 * view_.up - 0.35 * view_.right;
        const Vec3 normal = normalOf(facet);
        const double size = length(normal) * length(lamp);
        if (!(size > 0.0)) return 1.0;
        const double side = dot(normal, view_.towardsEye) < 0.0 ? -1.0 : 1.0;
        return kShade + (1.0 - kShade) * std::max(0.0, side * dot(normal, lamp) / size);
    }

    [[nodiscard]] RasterTriangle onPicture(const VisibleFacet& facet, double opacity) const
    {
        const auto& node = facet.node;
        const Colour colour = facet.entity.dimension == 3
                                  ? kSolidColours[facet.entity.index % kSolidColours.size()]
                                  : colourOf(facet.entity);
        RasterTriangle triangle;
        triangle.corner = {onPicture(node[0]), onPicture(node[1]), onPicture(node[2])};
        triangle.colour = lit(colour, lightOn(facet));
        for (std::size_t k = 0; k < 3; ++k) {
            const NodePair side = std::minmax(node[k], node[(k + 1) % 3]);
            const bool isOnLine = std::binary_search(lines_.begin(), lines_.end(), side);
            // Half of each line lies in either of the two triangles beside it.
            const double width = isOnLine ? options_.boundaryWidth : options_.edgeWidth;
            triangle.lineWidth[k] = 0.5 * width * static_cast<double>(factor_);
            triangle.lineColour[k] = isOnLine ? kBoundaryColour : kEdgeColour;
            triangle.lineOpacity[k] = isOnLine ? 1.0 : opacity;
        }
        return triangle;
    }

    /// By the mean size of a facet.
    [[nodiscard]] double edgeOpacity(std::span<const VisibleFacet> facets, double scale) const
    {
        double area = 0.0;
        for (const VisibleFacet& facet : facets) area += 0.5 * length(normalOf(facet));
        const double count = static_cast<double>(std::max<std::size_t>(facets.size(), 1));
        return std::clamp(scale * std::sqrt(2.3 * area / count) / kFullyDrawnLength, kFaintestEdge, 1.0);
    }

    const ClassifiedMesh& mesh_;
    const DrawingOptions& options_;
    View view_;
    Box2 box_;                     // of the picture's plane, model units
    std::vector<NodePair> lines_;  // sorted
    std::size_t factor_ = 1;
    double samples_ = 1.0;  // per model unit
    Vec2 origin_;
};

/// One at the left, one at the right end of a picture of this width.
Image besideEachOther(const Image& left, const Image& right, std::size_t width)
{
    Image both(width, left.height, kBackground);
    for (std::size_t y = 0; y < left.height; ++y) {
        for (std::size_t x = 0; x < left.width; ++x) both.at(x, y) = left.at(x, y);
        for (std::size_t x = 0; x < right.width; ++x) both.at(width - right.width + x, y) = right.at(x, y);
    }
    return both;
}

}  // namespace

Image drawInSpace(const ClassifiedMesh& mesh, const DrawingOptions& options)
{
    SpaceDrawing drawing(mesh, options);
    const auto cut = [&] { return cutSurfaceOf(mesh, cutPlaneOf(mesh, options), kTowardsEye); };
    const bool hasBoth = options.part == DrawnPart::SurfaceAndCut && !mesh.tets.empty();
    if (hasBoth) {
        const std::size_t half = options.width / 2;
        const Image surface = drawing.draw(surfaceOf(mesh), half);
        return besideEachOther(surface, drawing.draw(cut(), half), options.width);
    }
    return drawing.draw(options.part == DrawnPart::Cut ? cut() : surfaceOf(mesh), options.width);
}

}  // namespace mesher
