#include "improvement/edge_removal.h"

#include "improvement/dihedral_score.h"

#include <algorithm>
#include <limits>

namespace mesher {

namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// The tetrahedra around an edge (a, b): tets[i] is (a, b, from[i], to[i]), positive.
struct EdgeTets
{
    static constexpr std::size_t kMost = 2 * kMostAroundEdge;

    std::size_t count = 0;
    std::array<TetId, kMost> tet;
    std::array<NodeId, kMost> from;
    std::array<NodeId, kMost> to;
    double score = kInfinity;

    /// False if there are too many.
    bool collect(const TetComplex& complex, NodeId a, NodeId b)
    {
        for (const TetId t : complex.star(a)) {
            if (!complex.hasNode(t, b)) continue;
            if (count == kMost) return false;
            tet[count] = t;
            setOpposite(complex.nodes(t), a, b);
            score = std::min(score, complex.score(t));
            ++count;
        }
        return count > 0;
    }

    [[nodiscard]] std::size_t startingWith(NodeId n) const
    {
        return static_cast<std::size_t>(std::find(from.begin(), from.begin() + count, n) - from.begin());
    }

private:
    void setOpposite(const TetNodes& v, NodeId a, NodeId b)
    {
        const auto i = static_cast<std::size_t>(std::find(v.begin(), v.end(), a) - v.begin());
        const auto j = static_cast<std::size_t>(std::find(v.begin(), v.end(), b) - v.begin());
        std::array<std::size_t, 2> rest{};
        std::size_t filled = 0;
        for (std::size_t k = 0; k < 4; ++k) {
            if (k != i && k != j) rest[filled++] = k;
        }
        // (i, j, rest) is even where the number of slots between i and j and the order of the two agree.
        const bool isEven = ((i + j) % 2 == 1) == (i < j);
        from[count] = v[rest[isEven ? 0 : 1]];
        to[count] = v[rest[isEven ? 1 : 0]];
    }
};

/// The nodes around an edge on one side of the boundary, or all around, and its tetrahedra in their order.
struct Polygon
{
    std::size_t size = 0;
    std::array<NodeId, kMostAroundEdge + 1> node;
    std::size_t tetCount = 0;
    std::array<TetId, kMostAroundEdge + 1> tet;
};

/// From `first` to `last`, which is the same all around. False if it does not get there, or is too large; no tetrahedron at
/// `first` makes an empty polygon.
bool follow(const EdgeTets& ring, NodeId first, NodeId last, Polygon& polygon)
{
    NodeId at = first;
    do {
        const std::size_t i = ring.startingWith(at);
        if (i == ring.count) return polygon.tetCount == 0;
        if (polygon.tetCount == kMostAroundEdge) return false;
        polygon.node[polygon.size++] = at;
        polygon.tet[polygon.tetCount++] = ring.tet[i];
        at = ring.to[i];
    } while (at != last);
    if (first != last) polygon.node[polygon.size++] = last;
    return true;
}

/// best[i][j] is the best least score of a triangulation of the nodes i to j, apex[i][j] the node on edge (i, j) that gives it.
class PolygonTriangulation
{
public:
    /// Values up to `floor` do not count.
    PolygonTriangulation(const TetComplex& complex, const Polygon& polygon, NodeId a, NodeId b, double floor)
        : complex_(complex), polygon_(polygon), a_(a), b_(b), floor_(floor)
    {
        const std::size_t n = polygon.size;
        for (std::size_t step = 2; step < n; ++step) {
            for (std::size_t i = 0; i + step < n; ++i) solve(i, i + step);
        }
    }

    [[nodiscard]] double score() const { return side(0, polygon_.size - 1); }
    void append(std::vector<TetNodes>& tets) const { append(0, polygon_.size - 1, tets); }

private:
    using Table = std::array<std::array<double, kMostAroundEdge + 1>, kMostAroundEdge + 1>;
    using Apexes = std::array<std::array<std::uint8_t, kMostAroundEdge + 1>, kMostAroundEdge + 1>;

    [[nodiscard]] std::array<TetNodes, 2> tetsOn(std::size_t i, std::size_t j, std::size_t k) const
    {
        const auto& p = polygon_.node;
        return {TetNodes{p[i], p[j], p[k], b_}, TetNodes{p[j], p[i], p[k], a_}};
    }
    [[nodiscard]] double side(std::size_t i, std::size_t j) const
    {
        return j == i + 1 ? kInfinity : best_[i][j];
    }
    void solve(std::size_t i, std::size_t j)
    {
        double best = floor_;
        best_[i][j] = 0.0;
        for (std::size_t k = i + 1; k < j; ++k) {
            double value = std::min(side(i, k), side(k, j));
            for (const TetNodes& tet : tetsOn(i, k, j)) {
                if (value <= best) break;
                value = std::min(value, dihedralScore(complex_.corners(tet)));
            }
            if (value <= best) continue;
            best = best_[i][j] = value;
            apex_[i][j] = static_cast<std::uint8_t>(k);
        }
    }
    void append(std::size_t i, std::size_t j, std::vector<TetNodes>& tets) const
    {
        if (j == i + 1) return;
        const std::size_t k = apex_[i][j];
        for (const TetNodes& tet : tetsOn(i, k, j)) tets.push_back(tet);
        append(i, k, tets);
        append(k, j, tets);
    }

    const TetComplex& complex_;
    const Polygon& polygon_;
    NodeId a_;
    NodeId b_;
    double floor_;
    Table best_;
    Apexes apex_;
};

NodeId apexOf(const FacetNodes& v, NodeId a, NodeId b)
{
    return *std::find_if(v.begin(), v.end(), [&](NodeId n) { return n != a && n != b; });
}

FacetNodes withInstead(FacetNodes v, NodeId old, NodeId other)
{
    *std::find(v.begin(), v.end(), old) = other;
    return v;
}

/// Triangulates one polygon into list `s` of the change; false if that is not better.
bool triangulate(const TetComplex& complex, const Polygon& polygon, NodeId a, NodeId b, double floor,
                 std::size_t s, LocalChange& change)
{
    if (polygon.tetCount == 0) return true;
    change.removed[s].assign(polygon.tet.begin(), polygon.tet.begin() + polygon.tetCount);
    if (polygon.size == 2) return true;
    const PolygonTriangulation best(complex, polygon, a, b, floor);
    if (best.score() <= floor) return false;
    change.score = std::min(change.score, best.score());
    best.append(change.added[s]);
    return std::all_of(change.added[s].begin(), change.added[s].end(),
                       [&](const TetNodes& tet) { return complex.isPositive(tet); });
}

bool evaluateInside(const TetComplex& complex, NodeId a, NodeId b, const EdgeTets& ring, double floor,
                    LocalChange& change)
{
    Polygon polygon;
    if (ring.count < 3 || !follow(ring, ring.from[0], ring.from[0], polygon)) return false;
    if (polygon.tetCount != ring.count) return false;
    return triangulate(complex, polygon, a, b, floor, 0, change);
}

bool evaluateSwap(const TetComplex& complex, BoundaryGeometry& geometry, NodeId a, NodeId b,
                  const EdgeTets& ring, double floor, LocalChange& change)
{
    const auto& [f, g] = change.facets;
    if (complex.face(f) != complex.face(g) || complex.isLine(a, b)) return false;
    const NodeId left = apexOf(complex.nodes(f), a, b);
    const NodeId right = apexOf(complex.nodes(g), a, b);
    std::array<Polygon, 2> polygon;
    if (!follow(ring, left, right, polygon[0]) || !follow(ring, right, left, polygon[1])) return false;
    if (polygon[0].tetCount + polygon[1].tetCount != ring.count) return false;
    const bool takesOff = polygon[0].tetCount == 1 || polygon[1].tetCount == 1;
    if (takesOff ? complex.isOnSurface(left, right) : complex.isEdge(left, right)) return false;
    for (std::size_t s = 0; s < 2; ++s) {
        if (!triangulate(complex, polygon[s], a, b, floor, s, change)) return false;
    }
    change.swapsFacets = true;
    change.facetNodes = {withInstead(complex.nodes(f), b, right), withInstead(complex.nodes(g), a, left)};
    return geometry.allowsSwap(change.facets, change.facetNodes);
}

}  // namespace

bool evaluateEdgeRemoval(const TetComplex& complex, BoundaryGeometry& geometry, NodeId a, NodeId b,
                         const EdgeRemovalLimits& limits, LocalChange& change)
{
    change.clear();
    const int facets = complex.facetsAt(a, b, change.facets);
    if (facets > 0 && (limits.boundary == BoundaryChanges::None || facets != 2)) return false;
    EdgeTets ring;
    if (!ring.collect(complex, a, b)) return false;
    change.before = ring.score;
    change.score = kInfinity;
    const double floor = std::max(limits.floor, leastBetter(change.before));
    return facets == 0 ? evaluateInside(complex, a, b, ring, floor, change)
                       : evaluateSwap(complex, geometry, a, b, ring, floor, change);
}

}  // namespace mesher
