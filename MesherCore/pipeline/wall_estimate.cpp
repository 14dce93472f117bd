#include "pipeline/wall_estimate.h"

#include "sizing/box_tree.h"
#include "surface_sampling/triangle_intersection.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>
#include <vector>

namespace mesher {

namespace {

constexpr double kTetsPerSquare = 3.8;
constexpr std::size_t kMostRays = 4000;
constexpr double kParallel = 0.97;  // cosine between the sides of a wall
constexpr double kOwnFacet = 1e-9;  // share of a ray that is its own facet
constexpr double kThinnest = 0.7;   // of a facet's longest edge: thicker walls are no finer than their facets

class WallSearch
{
public:
    WallSearch(const SurfaceMesh& mesh, const RegionSides& sides)
        : mesh_(mesh), sides_(sides), facets_(livingFacets(mesh)), tree_(boxes())
    {
    }

    WallEstimate run()
    {
        const std::size_t stride = std::max<std::size_t>(1, facets_.size() / kMostRays);
        for (std::size_t i = 0; i < facets_.size(); i += stride)
            lookBehind(facets_[i], static_cast<double>(stride));
        return estimate_;
    }

private:
    static std::vector<FacetId> livingFacets(const SurfaceMesh& mesh)
    {
        std::vector<FacetId> facets;
        for (std::uint32_t i = 0; i < mesh.facets.size(); ++i) {
            if (mesh.facets[FacetId(i)].isAlive()) facets.push_back(FacetId(i));
        }
        return facets;
    }

    [[nodiscard]] TrianglePoints cornersOf(FacetId facet) const
    {
        TrianglePoints corners;
        for (std::size_t i = 0; i < 3; ++i) corners[i] = mesh_.nodes[mesh_.facets[facet].node[i]].position;
        return corners;
    }

    [[nodiscard]] std::vector<Box3> boxes() const
    {
        std::vector<Box3> boxes;
        for (const FacetId facet : facets_) boxes.push_back(Box3::of(cornersOf(facet)));
        return boxes;
    }

    void lookBehind(FacetId facet, double weight)
    {
        const TrianglePoints corner = cornersOf(facet);
        const Vec3 normal = cross(corner[1] - corner[0], corner[2] - corner[0]);
        const double doubleArea = length(normal);
        if (!(doubleArea > 0.0)) return;
        const double longest = std::max(
            {length(corner[1] - corner[0]), length(corner[2] - corner[1]), length(corner[0] - corner[2])});
        const Vec3 middle = (1.0 / 3.0) * (corner[0] + corner[1] + corner[2]);
        for (const std::size_t side : {0u, 1u}) {
            if (sides_[mesh_.facets[facet].face][side].value == 0) continue;
            const double reach = (side == 0 ? kThinnest : -kThinnest) * longest / doubleArea;
            const std::optional<double> share = firstWall(facet, middle, middle + reach * normal);
            if (!share) continue;
            const double thickness = *share * kThinnest * longest;
            // Each side of the wall has half of what is between them.
            add(facet, middle, thickness,
                weight * 0.25 * kTetsPerSquare * doubleArea / (thickness * thickness));
        }
    }

    void add(FacetId facet, const Vec3& place, double thickness, double elements)
    {
        estimate_.elements += elements;
        if (elements <= most_) return;
        most_ = elements;
        estimate_.face = mesh_.facets[facet].face;
        estimate_.place = place;
        estimate_.thickness = thickness;
    }

    /// The share of the way from a to b at which the first facet is met, if that is the other side of a wall.
    [[nodiscard]] std::optional<double> firstWall(FacetId own, const Vec3& a, const Vec3& b) const
    {
        const Box3 way = Box3::of(std::array{a, b});
        double first = 2.0;
        FacetId met;
        std::vector<std::uint32_t> waiting = {0};
        while (!waiting.empty()) {
            const BoxTree::Node& node = tree_.nodes()[waiting.back()];
            const std::uint32_t index = waiting.back();
            waiting.pop_back();
            if (!doMeet(way, node.box)) continue;
            if (!node.isLeaf()) {
                waiting.push_back(index + 1);
                waiting.push_back(node.second);
                continue;
            }
            for (std::uint32_t i = node.begin; i < node.end; ++i) {
                const FacetId facet = facets_[tree_.order()[i]];
                if (facet == own || !doesSegmentMeetTriangle(a, b, cornersOf(facet))) continue;
                const double share = shareAt(a, b, cornersOf(facet));
                if (share < first) {
                    first = share;
                    met = facet;
                }
            }
        }
        if (!met.isValid() || first < kOwnFacet || !isOtherSide(own, met)) return std::nullopt;
        return first;
    }

    static bool doMeet(const Box3& a, const Box3& b)
    {
        return a.low.x <= b.high.x && b.low.x <= a.high.x && a.low.y <= b.high.y && b.low.y <= a.high.y &&
               a.low.z <= b.high.z && b.low.z <= a.high.z;
    }

    static double shareAt(const Vec3& a, const Vec3& b, const TrianglePoints& corner)
    {
        const Vec3 normal = cross(corner[1] - corner[0], corner[2] - corner[0]);
        const double before = dot(a - corner[0], normal), after = dot(b - corner[0], normal);
        return before == after ? 0.0 : std::clamp(before / (before - after), 0.0, 1.0);
    }

    [[nodiscard]] bool isOtherSide(FacetId own, FacetId met) const
    {
        const auto& a = mesh_.facets[own].node;
        const auto& b = mesh_.facets[met].node;
        if (std::find_first_of(a.begin(), a.end(), b.begin(), b.end()) != a.end()) return false;
        const TrianglePoints p = cornersOf(own), q = cornersOf(met);
        const Vec3 n = cross(p[1] - p[0], p[2] - p[0]), m = cross(q[1] - q[0], q[2] - q[0]);
        return std::abs(dot(n, m)) >= kParallel * length(n) * length(m);
    }

    const SurfaceMesh& mesh_;
    const RegionSides& sides_;
    std::vector<FacetId> facets_;
    BoxTree tree_;
    WallEstimate estimate_;
    double most_ = 0.0;
};

}  // namespace

WallEstimate estimateWalls(const SurfaceMesh& mesh, const RegionSides& sides)
{
    return WallSearch(mesh, sides).run();
}

}  // namespace mesher
