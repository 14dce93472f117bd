#include "io/draw_png.h"

#include "base/box.h"
#include "io/format_writers.h"
#include "io/line_raster.h"
#include "quality/quality_statistics.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <vector>

namespace mesher {

namespace {

constexpr Colour kBackground = {255, 255, 255};
constexpr Colour kEdgeColour = {60, 66, 80};
constexpr Colour kBoundaryColour = {12, 16, 28};
constexpr double kMargin = 24.0;           // pixels
constexpr double kFullyDrawnLength = 6.0;  // pixels: shorter edges fade
constexpr double kFaintestEdge = 0.12;
constexpr std::array<Colour, 8> kFaceColours = {{{176, 205, 232},
                                                 {247, 208, 158},
                                                 {186, 222, 178},
                                                 {233, 184, 184},
                                                 {206, 194, 228},
                                                 {240, 232, 160},
                                                 {170, 220, 218},
                                                 {222, 204, 188}}};

/// Two axes of the picture and the direction towards the eye.
struct View
{
    Vec3 right;
    Vec3 up;
    Vec3 towardsEye;
};

Vec3 normalised(const Vec3& v) { return (1.0 / length(v)) * v; }

View viewAlong(const Vec3& towardsEye)
{
    // What points up in the model points up in the picture, unless one looks along it.
    const Vec3 eye = normalised(towardsEye);
    const Vec3 up = std::abs(eye.z) > 0.99 ? Vec3{0.0, 1.0, 0.0} : Vec3{0.0, 0.0, 1.0};
    const Vec3 right = normalised(cross(up, eye));
    return {right, cross(eye, right), eye};
}

/// The common normal of all triangles if they have one.
std::optional<Vec3> commonNormal(const ClassifiedMesh& mesh)
{
    Vec3 sum;
    double size = 0.0;
    for (const MeshElement<3>& triangle : mesh.triangles) {
        const Vec3 area = doubleAreaVector(cornersOf(mesh, triangle));
        sum = sum + area;
        size += length(area);
    }
    const bool isPlane = size > 0.0 && length(sum) > (1.0 - 1e-6) * size;
    if (!isPlane) return std::nullopt;
    return sum.z < 0.0 ? -1.0 * sum : sum;
}

class MeshDrawing
{
public:
    MeshDrawing(const ClassifiedMesh& mesh, const DrawingOptions& options)
        : mesh_(mesh), options_(options), view_(viewAlong(commonNormal(mesh).value_or(Vec3{1.0, -1.2, 0.9})))
    {
        for (const MeshNode& node : mesh.nodes) {
            if (isFinite(node.position)) box_.include(projected(node.position));
        }
        if (options.window) box_ = *options.window;
        const Vec2 extent = box_.extent();
        const double room = static_cast<double>(options.width) - 2.0 * kMargin;
        const double largest = std::max(extent.x, extent.y);
        scale_ = largest > 0.0 ? room / largest : 1.0;
    }

    [[nodiscard]] Image draw() const
    {
        Image image(pixelsFor(box_.extent().x), pixelsFor(box_.extent().y), kBackground);
        const double opacity = edgeOpacity();
        for (const std::uint32_t i : farthestFirst()) {
            const std::array<Vec2, 3> corners = cornersOnImage(mesh_.triangles[i], image);
            fillTriangle(image, corners, colourOf(mesh_.triangles[i]));
            if (isSolid()) drawEdges(image, corners, opacity);
        }
        if (!isSolid()) {
            for (const MeshElement<3>& triangle : mesh_.triangles) {
                drawEdges(image, cornersOnImage(triangle, image), 0.5 * opacity);  // inner edges come twice
            }
            for (const MeshElement<2>& line : mesh_.lines) {
                drawLine(image, onImage(line.node[0], image), onImage(line.node[1], image),
                         options_.boundaryWidth, kBoundaryColour, 1.0);
            }
        }
        return image;
    }

private:
    [[nodiscard]] bool isSolid() const { return !mesh_.tets.empty(); }
    [[nodiscard]] Vec2 projected(const Vec3& p) const { return {dot(p, view_.right), dot(p, view_.up)}; }
    [[nodiscard]] std::size_t pixelsFor(double extent) const
    {
        return static_cast<std::size_t>(std::ceil(extent * scale_ + 2.0 * kMargin));
    }
    [[nodiscard]] Vec2 onImage(NodeId node, const Image& image) const
    {
        const Vec2 p = scale_ * (projected(mesh_.nodes[node].position) - box_.low);
        return {p.x + kMargin, static_cast<double>(image.height) - kMargin - p.y};
    }
    [[nodiscard]] std::array<Vec2, 3> cornersOnImage(const MeshElement<3>& triangle, const Image& image) const
    {
        return {onImage(triangle.node[0], image), onImage(triangle.node[1], image),
                onImage(triangle.node[2], image)};
    }
    void drawEdges(Image& image, const std::array<Vec2, 3>& corners, double opacity) const
    {
        for (std::size_t k = 0; k < 3; ++k) {
            drawLine(image, corners[k], corners[(k + 1) % 3], options_.edgeWidth, kEdgeColour, opacity);
        }
    }
    [[nodiscard]] bool isOnPicture(const MeshElement<3>& triangle) const
    {
        Box2 box;
        for (const NodeId node : triangle.node) box.include(projected(mesh_.nodes[node].position));
        return box.low.x <= box_.high.x && box_.low.x <= box.high.x && box.low.y <= box_.high.y &&
               box_.low.y <= box.high.y;
    }
    /// By the mean size of a triangle on the picture.
    [[nodiscard]] double edgeOpacity() const
    {
        double area = 0.0;
        std::size_t count = 0;
        for (const MeshElement<3>& triangle : mesh_.triangles) {
            if (!isOnPicture(triangle)) continue;
            area += shapeOf(cornersOf(mesh_, triangle)).area;
            ++count;
        }
        const double edge =
            scale_ * std::sqrt(2.3 * area / static_cast<double>(std::max<std::size_t>(count, 1)));
        return std::clamp(edge / kFullyDrawnLength, kFaintestEdge, 1.0);
    }
    [[nodiscard]] Colour colourOf(const MeshElement<3>& triangle) const
    {
        const Colour base = kFaceColours[triangle.entity.index % kFaceColours.size()];
        const Vec3 normal = doubleAreaVector(cornersOf(mesh_, triangle));
        const double size = length(normal);
        const double facing = size > 0.0 ? std::abs(dot(normal, view_.towardsEye)) / size : 1.0;
        const double light = 0.55 + 0.45 * facing;
        const auto dim = [light](std::uint8_t value) {
            return static_cast<std::uint8_t>(std::lround(light * value));
        };
        return {dim(base.red), dim(base.green), dim(base.blue)};
    }
    [[nodiscard]] std::vector<std::uint32_t> farthestFirst() const
    {
        std::vector<std::pair<double, std::uint32_t>> order;
        for (std::uint32_t i = 0; i < mesh_.triangles.size(); ++i) {
            double depth = 0.0;
            for (const NodeId node : mesh_.triangles[i].node) {
                depth += dot(mesh_.nodes[node].position, view_.towardsEye);
            }
            order.emplace_back(depth, i);
        }
        std::sort(order.begin(), order.end());
        std::vector<std::uint32_t> indices;
        for (const auto& [depth, index] : order) indices.push_back(index);
        return indices;
    }

    const ClassifiedMesh& mesh_;
    DrawingOptions options_;
    View view_;
    Box2 box_;
    double scale_ = 1.0;
};

}  // namespace

Result<Image> drawMesh(const ClassifiedMesh& mesh, const DrawingOptions& options)
{
    if (mesh.triangles.empty())
        return Error{ErrorCode::InvalidArgument, "the mesh has no triangles to draw", {}, {}, {}};
    if (options.width < 64 || options.width > 16384) {
        return Error{ErrorCode::InvalidArgument,
                     "the width of the picture is not in the range from 64 to 16384",
                     {},
                     {},
                     {}};
    }
    if (options.window && !(options.window->extent().x > 0.0 && options.window->extent().y > 0.0)) {
        return Error{ErrorCode::InvalidArgument, "the window of the picture has no area", {}, {}, {}};
    }
    for (const MeshNode& node : mesh.nodes) {
        if (!isFinite(node.position)) {
            return Error{ErrorCode::NonFinitePoint, "the mesh has a node that is not finite", {}, {}, {}};
        }
    }
    return MeshDrawing(mesh, options).draw();
}

Result<void> writePng(const ClassifiedMesh& mesh, FileBuffer& out)
{
    const Result<Image> image = drawMesh(mesh);
    if (!image) return image.error();
    writePngFile(image.value(), out);
    return {};
}

}  // namespace mesher
