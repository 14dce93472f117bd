#include "io/draw_png.h"

#include "base/box.h"
#include "io/draw_space.h"
#include "io/format_writers.h"
#include "io/line_raster.h"
#include "io/picture_style.h"
#include "quality/quality_statistics.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

namespace mesher {

namespace {

/// The common normal of all triangles if they have one, towards positive z.
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

class PlaneDrawing
{
public:
    PlaneDrawing(const ClassifiedMesh& mesh, const Vec3& normal, const DrawingOptions& options)
        : mesh_(mesh), options_(options), view_(viewAlong(normal))
    {
        for (const MeshNode& node : mesh.nodes) box_.include(view_.projected(node.position));
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
        for (const MeshElement<3>& triangle : mesh_.triangles) {
            fillTriangle(image, cornersOnImage(triangle, image), colourOf(triangle.entity));
        }
        for (const MeshElement<3>& triangle : mesh_.triangles) {
            drawEdges(image, cornersOnImage(triangle, image), 0.5 * opacity);  // inner edges come twice
        }
        for (const MeshElement<2>& line : mesh_.lines) {
            drawLine(image, onImage(line.node[0], image), onImage(line.node[1], image),
                     options_.boundaryWidth, kBoundaryColour, 1.0);
        }
        return image;
    }

private:
    [[nodiscard]] std::size_t pixelsFor(double extent) const
    {
        return static_cast<std::size_t>(std::ceil(extent * scale_ + 2.0 * kMargin));
    }
    [[nodiscard]] Vec2 onImage(NodeId node, const Image& image) const
    {
        const Vec2 p = scale_ * (view_.projected(mesh_.nodes[node].position) - box_.low);
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
        for (const NodeId node : triangle.node) box.include(view_.projected(mesh_.nodes[node].position));
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
    const ClassifiedMesh& mesh_;
    DrawingOptions options_;
    View view_;
    Box2 box_;
    double scale_ = 1.0;
};

}  // namespace

Result<Image> drawMesh(const ClassifiedMesh& mesh, const DrawingOptions& options)
{
    if (mesh.triangles.empty() && mesh.tets.empty())
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
    const std::optional<Vec3> normal = mesh.tets.empty() ? commonNormal(mesh) : std::nullopt;
    return normal ? PlaneDrawing(mesh, *normal, options).draw() : drawInSpace(mesh, options);
}

Result<void> writePng(const ClassifiedMesh& mesh, FileBuffer& out, const WriteOptions&)
{
    const Result<Image> image = drawMesh(mesh);
    if (!image) return image.error();
    writePngFile(image.value(), out);
    return {};
}

}  // namespace mesher
