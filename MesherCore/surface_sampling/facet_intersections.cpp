#include "surface_sampling/facet_intersections.h"

#include "base/assert.h"
#include "base/box.h"
#include "surface_sampling/triangle_intersection.h"

#include <algorithm>
#include <array>
#include <cstdint>

namespace mesher {
namespace {

constexpr std::size_t kLeafSize = 4;

bool doBoxesMeet(const Box3& a, const Box3& b)
{
    return a.low.x <= b.high.x && b.low.x <= a.high.x && a.low.y <= b.high.y && b.low.y <= a.high.y &&
           a.low.z <= b.high.z && b.low.z <= a.high.z;
}

double coordinate(const Vec3& p, int axis) { return axis == 0 ? p.x : (axis == 1 ? p.y : p.z); }

/// Boxes of facets in a binary tree, cut at the median along the longer axis.
class FacetTree
{
public:
    FacetTree(const BrepModel& model, const SurfaceMesh& mesh, const FacetMarks* asked, RunContext& context)
        : mesh_(mesh), context_(context), watch_(context), isPlane_(model.faces.size())
    {
        for (std::uint32_t f = 0; f < model.faces.size(); ++f) {
            isPlane_[f] = model.faces[BrepFaceId(f)].surface->kind() == SurfaceKind::Plane;
        }
        for (std::uint32_t i = 0; i < mesh.facets.size(); ++i) {
            if (!mesh.facets[FacetId(i)].isAlive()) continue;
            Box3 box;
            for (const NodeId node : mesh.facets[FacetId(i)].node) box.include(mesh.nodes[node].position);
            items_.push_back({box, FacetId(i), asked == nullptr || (*asked)[FacetId(i)] != 0});
        }
        if (!items_.empty()) build(0, items_.size());
    }

    std::vector<FacetIntersection> run()
    {
        if (!nodes_.empty()) findWithin(0);
        std::sort(found_.begin(), found_.end(), [](const FacetIntersection& a, const FacetIntersection& b) {
            return std::pair(a.first, a.second) < std::pair(b.first, b.second);
        });
        return std::move(found_);
    }

private:
    struct Item
    {
        Box3 box;
        FacetId facet;
        bool isAsked = true;
    };
    struct Node
    {
        Box3 box;
        std::size_t first = 0;
        std::size_t last = 0;
        std::array<std::size_t, 2> child{};  ///< both 0 for a leaf
        bool isAsked = false;                ///< whether one of its facets is

        [[nodiscard]] bool isLeaf() const { return child[0] == 0; }
    };

    std::size_t build(std::size_t first, std::size_t last)
    {
        const std::size_t index = nodes_.size();
        Node node;
        node.first = first;
        node.last = last;
        for (std::size_t i = first; i < last; ++i) {
            node.box.include(items_[i].box.low);
            node.box.include(items_[i].box.high);
            node.isAsked = node.isAsked || items_[i].isAsked;
        }
        nodes_.push_back(node);
        if (last - first <= kLeafSize) return index;
        const Vec3 extent = node.box.extent();
        const int axis = extent.x >= extent.y && extent.x >= extent.z ? 0 : (extent.y >= extent.z ? 1 : 2);
        const std::size_t middle = first + (last - first) / 2;
        const auto at = [this](std::size_t i) { return items_.begin() + static_cast<std::ptrdiff_t>(i); };
        std::nth_element(at(first), at(middle), at(last), [axis](const Item& a, const Item& b) {
            const double x = coordinate(a.box.low, axis) + coordinate(a.box.high, axis);
            const double y = coordinate(b.box.low, axis) + coordinate(b.box.high, axis);
            return x != y ? x < y : a.facet < b.facet;
        });
        const std::size_t left = build(first, middle);
        const std::size_t right = build(middle, last);
        nodes_[index].child = {left, right};
        return index;
    }

    void findWithin(std::size_t index)
    {
        const Node& node = nodes_[index];
        if (!node.isAsked || isStopped()) return;
        if (node.isLeaf()) {
            facetsDone_ += node.last - node.first;
            for (std::size_t i = node.first; i < node.last; ++i) {
                for (std::size_t k = i + 1; k < node.last; ++k) testPair(items_[i], items_[k]);
            }
            return;
        }
        findWithin(node.child[0]);
        findWithin(node.child[1]);
        findBetween(node.child[0], node.child[1]);
    }

    bool isStopped()
    {
        constexpr std::size_t kFacetsPerReport = 20'000;
        if (!watch_.mayGoOn()) return true;
        if (facetsDone_ < reportedAt_ + kFacetsPerReport) return false;
        reportedAt_ = facetsDone_;
        const double fraction = static_cast<double>(facetsDone_) / static_cast<double>(items_.size());
        return !context_.reportProgress("intersections", fraction);
    }

    void findBetween(std::size_t i, std::size_t k)
    {
        const Node &a = nodes_[i], &b = nodes_[k];
        if (!(a.isAsked || b.isAsked) || !doBoxesMeet(a.box, b.box) || !watch_.mayGoOn()) return;
        if (a.isLeaf() && b.isLeaf()) {
            for (std::size_t x = a.first; x < a.last; ++x) {
                for (std::size_t y = b.first; y < b.last; ++y) testPair(items_[x], items_[y]);
            }
        } else if (b.isLeaf() || (!a.isLeaf() && a.last - a.first >= b.last - b.first)) {
            for (const std::size_t child : a.child) findBetween(child, k);
        } else {
            for (const std::size_t child : b.child) findBetween(i, child);
        }
    }

    void testPair(const Item& x, const Item& y)
    {
        if (!(x.isAsked || y.isAsked) || !doBoxesMeet(x.box, y.box)) return;
        const Item& a = x.facet < y.facet ? x : y;
        const Item& b = x.facet < y.facet ? y : x;
        const SurfaceFacet& first = mesh_.facets[a.facet];
        const SurfaceFacet& second = mesh_.facets[b.facet];
        if (first.face == second.face && isPlane_[first.face.value]) return;
        if (!doMeet(first, second)) return;
        Box3 common = a.box;
        common.low = {std::max(a.box.low.x, b.box.low.x), std::max(a.box.low.y, b.box.low.y),
                      std::max(a.box.low.z, b.box.low.z)};
        common.high = {std::min(a.box.high.x, b.box.high.x), std::min(a.box.high.y, b.box.high.y),
                       std::min(a.box.high.z, b.box.high.z)};
        found_.push_back({a.facet, b.facet, 0.5 * (common.low + common.high)});
    }

    [[nodiscard]] TrianglePoints points(const std::array<NodeId, 3>& nodes) const
    {
        return {mesh_.nodes[nodes[0]].position, mesh_.nodes[nodes[1]].position,
                mesh_.nodes[nodes[2]].position};
    }

    /// Common nodes come first, in the same order in both.
    [[nodiscard]] bool doMeet(const SurfaceFacet& first, const SurfaceFacet& second) const
    {
        std::array<NodeId, 3> a = first.node, b = second.node;
        std::size_t common = 0;
        for (std::size_t i = 0; i < 3; ++i) {
            const auto same = std::find(b.begin() + static_cast<std::ptrdiff_t>(common), b.end(), a[i]);
            if (same == b.end()) continue;
            std::swap(b[common], *same);
            std::swap(a[common], a[i]);
            ++common;
        }
        switch (common) {
            case 0: return doTrianglesMeet(points(a), points(b));
            case 1: return doTrianglesMeetBeyondCorner(points(a), points(b));
            case 2: return doTrianglesOverlapAtEdge(points(a), points(b));
            default: return true;
        }
    }

    const SurfaceMesh& mesh_;
    RunContext& context_;
    StepWatch watch_;
    std::size_t facetsDone_ = 0;
    std::size_t reportedAt_ = 0;
    std::vector<bool> isPlane_;
    std::vector<Item> items_;
    std::vector<Node> nodes_;
    std::vector<FacetIntersection> found_;
};

}  // namespace

std::vector<FacetIntersection> findFacetIntersections(const BrepModel& model, const SurfaceMesh& mesh,
                                                      RunContext& context)
{
    return FacetTree(model, mesh, nullptr, context).run();
}

std::vector<FacetIntersection> findFacetIntersections(const BrepModel& model, const SurfaceMesh& mesh,
                                                      const FacetMarks& asked, RunContext& context)
{
    MESHER_PRECONDITION(asked.size() == mesh.facets.size());
    return FacetTree(model, mesh, &asked, context).run();
}

}  // namespace mesher
