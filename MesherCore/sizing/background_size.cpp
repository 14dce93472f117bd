#include "sizing/background_size.h"

#include "base/box.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <utility>

namespace mesher {
namespace {

constexpr std::uint32_t kLeafSize = 4;

double component(const Vec3& v, int axis) { return axis == 0 ? v.x : (axis == 1 ? v.y : v.z); }

double squaredDistanceToBox(const Vec3& p, const Box3& box)
{
    return squaredLength(Vec3{std::max({box.low.x - p.x, 0.0, p.x - box.high.x}),
                              std::max({box.low.y - p.y, 0.0, p.y - box.high.y}),
                              std::max({box.low.z - p.z, 0.0, p.z - box.high.z})});
}

/// A value at the closest point of an element, and how far that is.
struct Closest
{
    double squaredDistance = std::numeric_limits<double>::infinity();
    double value = kNoSize;

    void consider(double squared, double candidate)
    {
        if (squared < squaredDistance) *this = {squared, candidate};
    }
};

void considerSegment(const Vec3& p, const Vec3& a, const Vec3& b, double sizeA, double sizeB,
                     Closest& closest)
{
    const Vec3 edge = b - a;
    const double square = squaredLength(edge);
    const double along = square > 0.0 ? std::clamp(dot(p - a, edge) / square, 0.0, 1.0) : 0.0;
    closest.consider(squaredLength(p - (a + along * edge)), (1.0 - along) * sizeA + along * sizeB);
}

void considerTriangle(const Vec3& p, const std::array<Vec3, 3>& c, const std::array<double, 3>& sizes,
                      Closest& closest)
{
    const Vec3 normal = cross(c[1] - c[0], c[2] - c[0]);
    const double square = squaredLength(normal);
    std::array<double, 3> weights{};
    for (std::size_t i = 0; i < 3; ++i) {
        weights[i] = dot(cross(c[(i + 2) % 3] - c[(i + 1) % 3], p - c[(i + 1) % 3]), normal) / square;
    }
    if (square > 0.0 && weights[0] >= 0.0 && weights[1] >= 0.0 && weights[2] >= 0.0) {
        const double height = dot(p - c[0], normal);
        closest.consider(height * height / square,
                         weights[0] * sizes[0] + weights[1] * sizes[1] + weights[2] * sizes[2]);
        return;
    }
    for (std::size_t i = 0; i < 3; ++i) {
        considerSegment(p, c[i], c[(i + 1) % 3], sizes[i], sizes[(i + 1) % 3], closest);
    }
}

void considerTet(const Vec3& p, const std::array<Vec3, 4>& c, const std::array<double, 4>& sizes,
                 Closest& closest)
{
    const double volume = dot(cross(c[1] - c[0], c[2] - c[0]), c[3] - c[0]);
    bool isInside = volume != 0.0;
    double value = 0.0;
    for (std::size_t i = 0; i < 4; ++i) {
        std::array<Vec3, 4> moved = c;
        moved[i] = p;
        const double weight =
            dot(cross(moved[1] - moved[0], moved[2] - moved[0]), moved[3] - moved[0]) / volume;
        isInside = isInside && weight >= 0.0;
        value += weight * sizes[i];
    }
    if (isInside) {
        closest.consider(0.0, value);
        return;
    }
    for (std::size_t i = 0; i < 4; ++i) {
        const std::size_t a = (i + 1) % 4;
        const std::size_t b = (i + 2) % 4;
        const std::size_t d = (i + 3) % 4;
        considerTriangle(p, {c[a], c[b], c[d]}, {sizes[a], sizes[b], sizes[d]}, closest);
    }
}

Error backgroundError(std::string entity, std::string message)
{
    Error error;
    error.code = ErrorCode::InvalidArgument;
    error.entity = std::move(entity);
    error.message = std::move(message);
    error.remedy = "repair the background mesh";
    return error;
}

}  // namespace

/// A tree of boxes over the elements, triangles first.
struct BackgroundSize::Tree
{
    struct Node
    {
        Box3 box;
        std::uint32_t begin = 0;
        std::uint32_t end = 0;
        std::uint32_t second = 0;  ///< 0 for a leaf
    };
    struct Item
    {
        Box3 box;
        std::uint32_t element = 0;
    };

    std::vector<Node> nodes;
    std::vector<Item> items;

    std::uint32_t build(std::uint32_t begin, std::uint32_t end)
    {
        const auto index = static_cast<std::uint32_t>(nodes.size());
        Node node{{}, begin, end, 0};
        for (std::uint32_t i = begin; i < end; ++i) {
            node.box.include(items[i].box.low);
            node.box.include(items[i].box.high);
        }
        nodes.push_back(node);
        if (end - begin <= kLeafSize) return index;
        const Vec3 extent = node.box.extent();
        const int axis = extent.x >= extent.y && extent.x >= extent.z ? 0 : (extent.y >= extent.z ? 1 : 2);
        const std::uint32_t half = begin + (end - begin) / 2;
        std::nth_element(items.begin() + begin, items.begin() + half, items.begin() + end,
                         [axis](const Item& a, const Item& b) {
                             return component(a.box.low, axis) + component(a.box.high, axis) <
                                    component(b.box.low, axis) + component(b.box.high, axis);
                         });
        build(begin, half);
        const std::uint32_t second = build(half, end);
        nodes[index].second = second;
        return index;
    }
};

BackgroundSize::BackgroundSize(BackgroundMesh mesh, std::unique_ptr<Tree> tree)
    : mesh_(std::move(mesh)), tree_(std::move(tree))
{
}

BackgroundSize::~BackgroundSize() = default;

Result<std::shared_ptr<const BackgroundSize>> BackgroundSize::make(BackgroundMesh mesh)
{
    if (mesh.sizes.size() != mesh.nodes.size())
        return backgroundError("background mesh", "it needs one size per node");
    for (std::size_t i = 0; i < mesh.sizes.size(); ++i) {
        if (mesh.sizes[i] > 0.0 && std::isfinite(mesh.sizes[i]) && isFinite(mesh.nodes[i])) continue;
        return backgroundError("background node " + std::to_string(i),
                               "its size or place is not a positive, finite number");
    }
    auto tree = std::make_unique<Tree>();
    bool areIndicesValid = true;
    const auto add = [&](const auto& element) {
        Tree::Item item{{}, static_cast<std::uint32_t>(tree->items.size())};
        for (const std::uint32_t node : element) {
            if (node >= mesh.nodes.size()) {
                areIndicesValid = false;
                return;
            }
            item.box.include(mesh.nodes[node]);
        }
        tree->items.push_back(item);
    };
    for (const auto& triangle : mesh.triangles) add(triangle);
    for (const auto& tet : mesh.tets) add(tet);
    if (!areIndicesValid)
        return backgroundError("background mesh", "an element has a node that does not exist");
    if (tree->items.empty()) return backgroundError("background mesh", "it has no elements");
    tree->build(0, static_cast<std::uint32_t>(tree->items.size()));
    return std::shared_ptr<const BackgroundSize>(new BackgroundSize(std::move(mesh), std::move(tree)));
}

double BackgroundSize::sizeAt(const Vec3& point) const
{
    Closest closest;
    std::vector<std::uint32_t> stack{0};
    while (!stack.empty()) {
        const std::uint32_t index = stack.back();
        stack.pop_back();
        const Tree::Node& node = tree_->nodes[index];
        if (squaredDistanceToBox(point, node.box) >= closest.squaredDistance) continue;
        if (node.second != 0) {
            stack.push_back(node.second);
            stack.push_back(index + 1);
            continue;
        }
        for (std::uint32_t i = node.begin; i < node.end; ++i) {
            const std::uint32_t element = tree_->items[i].element;
            const auto& n = mesh_.nodes;
            const auto& s = mesh_.sizes;
            if (element < mesh_.triangles.size()) {
                const auto& e = mesh_.triangles[element];
                considerTriangle(point, {n[e[0]], n[e[1]], n[e[2]]}, {s[e[0]], s[e[1]], s[e[2]]}, closest);
            } else {
                const auto& e = mesh_.tets[element - mesh_.triangles.size()];
                considerTet(point, {n[e[0]], n[e[1]], n[e[2]], n[e[3]]}, {s[e[0]], s[e[1]], s[e[2]], s[e[3]]},
                            closest);
            }
        }
    }
    return closest.value;
}

}  // namespace mesher
