#include "sizing/background_size.h"

#include "sizing/distances.h"

#include <cmath>
#include <limits>
#include <string>
#include <utility>

namespace mesher {
namespace {

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
    const double share = closestShare(p, a, b);
    closest.consider(squaredLength(p - (a + share * (b - a))), (1.0 - share) * sizeA + share * sizeB);
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

BackgroundSize::BackgroundSize(BackgroundMesh mesh, BoxTree tree)
    : mesh_(std::move(mesh)), tree_(std::move(tree))
{
}

Result<std::shared_ptr<const BackgroundSize>> BackgroundSize::make(BackgroundMesh mesh)
{
    if (mesh.sizes.size() != mesh.nodes.size())
        return backgroundError("background mesh", "it needs one size per node");
    for (std::size_t i = 0; i < mesh.sizes.size(); ++i) {
        if (mesh.sizes[i] > 0.0 && std::isfinite(mesh.sizes[i]) && isFinite(mesh.nodes[i])) continue;
        return backgroundError("background node " + std::to_string(i),
                               "its size or place is not a positive, finite number");
    }
    std::vector<Box3> boxes;
    bool areIndicesValid = true;
    const auto add = [&](const auto& element) {
        Box3 box;
        for (const std::uint32_t node : element) {
            if (node >= mesh.nodes.size()) {
                areIndicesValid = false;
                return;
            }
            box.include(mesh.nodes[node]);
        }
        boxes.push_back(box);
    };
    for (const auto& triangle : mesh.triangles) add(triangle);
    for (const auto& tet : mesh.tets) add(tet);
    if (!areIndicesValid)
        return backgroundError("background mesh", "an element has a node that does not exist");
    if (boxes.empty()) return backgroundError("background mesh", "it has no elements");
    return std::shared_ptr<const BackgroundSize>(new BackgroundSize(std::move(mesh), BoxTree(boxes)));
}

double BackgroundSize::sizeAt(const Vec3& point) const
{
    Closest closest;
    const std::vector<Vec3>& n = mesh_.nodes;
    const std::vector<double>& s = mesh_.sizes;
    const auto boundOf = [&](std::uint32_t node) { return squaredDistance(point, tree_.nodes()[node].box); };
    const auto look = [&](std::uint32_t i) {
        const std::uint32_t element = tree_.order()[i];
        if (element < mesh_.triangles.size()) {
            const auto& e = mesh_.triangles[element];
            considerTriangle(point, {n[e[0]], n[e[1]], n[e[2]]}, {s[e[0]], s[e[1]], s[e[2]]}, closest);
        } else {
            const auto& e = mesh_.tets[element - mesh_.triangles.size()];
            considerTet(point, {n[e[0]], n[e[1]], n[e[2]], n[e[3]]}, {s[e[0]], s[e[1]], s[e[2]], s[e[3]]},
                        closest);
        }
        return closest.squaredDistance;
    };
    tree_.searchSmallest(boundOf, look, closest.squaredDistance);
    return closest.value;
}

}  // namespace mesher
