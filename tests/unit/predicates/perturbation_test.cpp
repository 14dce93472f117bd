#include "base/random.h"
#include "predicates/incircle.h"
#include "predicates/insphere.h"
#include "predicates/orient2d.h"
#include "predicates/orient3d.h"
#include "support/predicate_points.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <map>
#include <numeric>
#include <set>
#include <string>
#include <vector>

namespace mesher {
namespace {

using test::makePointSets;
using test::PointKind;

Sign perturbed(const std::vector<Vec2>& p) { return incirclePerturbed(p[0], p[1], p[2], p[3]); }
Sign perturbed(const std::vector<Vec3>& p) { return inspherePerturbed(p[0], p[1], p[2], p[3], p[4]); }

/// Even permutations must keep the sign and odd ones flip it.
template <class Point>
void expectAntisymmetry(const std::vector<Point>& points)
{
    const Sign sign = perturbed(points);
    std::vector<std::size_t> order(points.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    do {
        std::vector<Point> permuted;
        int inversions = 0;
        for (std::size_t i = 0; i < order.size(); ++i) {
            permuted.push_back(points[order[i]]);
            for (std::size_t j = 0; j < i; ++j) inversions += order[j] > order[i] ? 1 : 0;
        }
        ASSERT_EQ(perturbed(permuted), inversions % 2 == 0 ? sign : -sign);
    } while (std::next_permutation(order.begin(), order.end()));
}

bool haveDuplicates(const std::vector<Vec2>& p)
{
    std::set<std::array<double, 2>> seen;
    for (const Vec2& q : p) seen.insert({q.x, q.y});
    return seen.size() < p.size();
}
bool haveDuplicates(const std::vector<Vec3>& p)
{
    std::set<std::array<double, 3>> seen;
    for (const Vec3& q : p) seen.insert({q.x, q.y, q.z});
    return seen.size() < p.size();
}

bool areFlat(const std::vector<Vec2>& p)
{
    return orient2d(p[0], p[1], p[2]) == Sign::Zero && orient2d(p[0], p[1], p[3]) == Sign::Zero &&
           orient2d(p[0], p[2], p[3]) == Sign::Zero && orient2d(p[1], p[2], p[3]) == Sign::Zero;
}
bool areFlat(const std::vector<Vec3>& p)
{
    for (std::size_t left = 0; left < 5; ++left) {
        std::vector<Vec3> q = p;
        q.erase(q.begin() + static_cast<std::ptrdiff_t>(left));
        if (orient3d(q[0], q[1], q[2], q[3]) != Sign::Zero) return false;
    }
    return true;
}

TEST(Perturbation, IsAntisymmetric)
{
    for (const PointKind kind :
         {PointKind::Grid, PointKind::Cospherical, PointKind::Coplanar, PointKind::Ulp}) {
        for (std::uint64_t i = 0; i < 500; ++i) {
            SCOPED_TRACE(std::string(test::kPointKindNames[static_cast<std::size_t>(kind)]) +
                         std::to_string(i));
            const auto sets = makePointSets(kind, 5, i);
            expectAntisymmetry(sets.plane);
            expectAntisymmetry(sets.space);
        }
    }
}

TEST(Perturbation, IsZeroExactlyForFlatOrCoincidingPoints)
{
    int zeros = 0;
    for (const PointKind kind : {PointKind::Grid, PointKind::Cospherical, PointKind::Coplanar}) {
        for (std::uint64_t i = 0; i < 5000; ++i) {
            const auto sets = makePointSets(kind, 6, i);
            const bool isZero2 = haveDuplicates(sets.plane) || areFlat(sets.plane);
            const bool isZero3 = haveDuplicates(sets.space) || areFlat(sets.space);
            zeros += isZero2 + isZero3;
            ASSERT_EQ(perturbed(sets.plane) == Sign::Zero, isZero2);
            ASSERT_EQ(perturbed(sets.space) == Sign::Zero, isZero3);
        }
    }
    EXPECT_GT(zeros, 1000);
}

TEST(Perturbation, KeepsTheSignOfAnUndegenerateSphere)
{
    for (std::uint64_t i = 0; i < 5000; ++i) {
        const auto sets = makePointSets(PointKind::Ulp, 7, i);
        const auto& q = sets.space;
        const Sign sign = insphere(q[0], q[1], q[2], q[3], q[4]);
        if (sign == Sign::Zero) continue;
        ASSERT_EQ(perturbed(q), sign);
    }
}

TEST(Perturbation, PutsTheLargestPointOutside)
{
    // Its lift is raised most, as if it lay a little outside of the circle or sphere.
    EXPECT_EQ(incirclePerturbed({0, 0}, {1, 0}, {0, 1}, {1, 1}), Sign::Negative);
    EXPECT_EQ(inspherePerturbed({0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 1, 1}), Sign::Negative);
}

// Brute-force Delaunay triangulations: all simplices that are empty under a test. Indices ascend within each,
// up to one swap that makes the orientation positive.

using Triangle = std::array<std::size_t, 3>;
using Tet = std::array<std::size_t, 4>;

template <class IsInside>
std::vector<Tet> emptyTets(const std::vector<Vec3>& p, IsInside isInside)
{
    std::vector<Tet> tets;
    const std::size_t n = p.size();
    for (std::size_t a = 0; a < n; ++a)
        for (std::size_t b = a + 1; b < n; ++b)
            for (std::size_t c = b + 1; c < n; ++c)
                for (std::size_t d = c + 1; d < n; ++d) {
                    const Sign orientation = orient3d(p[a], p[b], p[c], p[d]);
                    if (orientation == Sign::Zero) continue;
                    const Tet tet = orientation == Sign::Positive ? Tet{a, b, c, d} : Tet{b, a, c, d};
                    bool isEmpty = true;
                    for (std::size_t e = 0; e < n && isEmpty; ++e) {
                        const bool isOwn = std::find(tet.begin(), tet.end(), e) != tet.end();
                        isEmpty = isOwn || !isInside(tet, e);
                    }
                    if (isEmpty) tets.push_back(tet);
                }
    return tets;
}

template <class IsInside>
std::vector<Triangle> emptyTriangles(const std::vector<Vec2>& p, IsInside isInside)
{
    std::vector<Triangle> triangles;
    const std::size_t n = p.size();
    for (std::size_t a = 0; a < n; ++a)
        for (std::size_t b = a + 1; b < n; ++b)
            for (std::size_t c = b + 1; c < n; ++c) {
                const Sign orientation = orient2d(p[a], p[b], p[c]);
                if (orientation == Sign::Zero) continue;
                const Triangle triangle =
                    orientation == Sign::Positive ? Triangle{a, b, c} : Triangle{b, a, c};
                bool isEmpty = true;
                for (std::size_t d = 0; d < n && isEmpty; ++d) {
                    const bool isOwn = std::find(triangle.begin(), triangle.end(), d) != triangle.end();
                    isEmpty = isOwn || !isInside(triangle, d);
                }
                if (isEmpty) triangles.push_back(triangle);
            }
    return triangles;
}

std::vector<Tet> perturbedDelaunay(const std::vector<Vec3>& p)
{
    return emptyTets(p, [&p](const Tet& t, std::size_t e) {
        return inspherePerturbed(p[t[0]], p[t[1]], p[t[2]], p[t[3]], p[e]) == Sign::Positive;
    });
}
std::vector<Triangle> perturbedDelaunay(const std::vector<Vec2>& p)
{
    return emptyTriangles(p, [&p](const Triangle& t, std::size_t d) {
        return incirclePerturbed(p[t[0]], p[t[1]], p[t[2]], p[d]) == Sign::Positive;
    });
}

// Volumes in sixths and areas in halves; small integers, hence exact.
double volumeOf(const std::vector<Vec3>& p, const Tet& t)
{
    return dot(p[t[1]] - p[t[0]], cross(p[t[2]] - p[t[0]], p[t[3]] - p[t[0]]));
}
double areaOf(const std::vector<Vec2>& p, const Triangle& t)
{
    return cross(p[t[1]] - p[t[0]], p[t[2]] - p[t[0]]);
}
template <class Simplices, class Points, class Measure>
double total(const Simplices& simplices, const Points& points, Measure measure)
{
    double sum = 0.0;
    for (const auto& simplex : simplices) sum += measure(points, simplex);
    return sum;
}

/// The hull's volume from a triangulation of another kind: the regular one of heights so random that no five
/// lifted points lie in one hyperplane. All numbers are integers below 2^53.
double hullVolume(const std::vector<Vec3>& p, Random& random)
{
    std::vector<double> height;
    for (std::size_t i = 0; i < p.size(); ++i) height.push_back(double(random.below(1u << 30)));
    const auto tets = emptyTets(p, [&](const Tet& t, std::size_t e) {
        const Vec3 u = p[t[1]] - p[t[0]], v = p[t[2]] - p[t[0]], w = p[t[3]] - p[t[0]], s = p[e] - p[t[0]];
        const double atE = (height[t[1]] - height[t[0]]) * dot(s, cross(v, w)) +
                           (height[t[2]] - height[t[0]]) * dot(s, cross(w, u)) +
                           (height[t[3]] - height[t[0]]) * dot(s, cross(u, v));
        return (height[e] - height[t[0]]) * dot(u, cross(v, w)) < atE;
    });
    return total(tets, p, volumeOf);
}
double hullArea(const std::vector<Vec2>& p, Random& random)
{
    std::vector<double> height;
    for (std::size_t i = 0; i < p.size(); ++i) height.push_back(double(random.below(1u << 30)));
    const auto triangles = emptyTriangles(p, [&](const Triangle& t, std::size_t d) {
        const Vec2 u = p[t[1]] - p[t[0]], v = p[t[2]] - p[t[0]], s = p[d] - p[t[0]];
        const double atD =
            (height[t[1]] - height[t[0]]) * cross(s, v) + (height[t[2]] - height[t[0]]) * cross(u, s);
        return (height[d] - height[t[0]]) * cross(u, v) < atD;
    });
    return total(triangles, p, areaOf);
}

/// A tiling has no facet twice on the same side.
void expectFacetsOnce(const std::vector<Vec3>& p, const std::vector<Tet>& tets)
{
    std::map<std::array<std::size_t, 4>, int> uses;
    for (const Tet& tet : tets) {
        for (std::size_t apex = 0; apex < 4; ++apex) {
            Triangle facet{tet[(apex + 1) % 4], tet[(apex + 2) % 4], tet[(apex + 3) % 4]};
            std::sort(facet.begin(), facet.end());
            const Sign side = orient3d(p[facet[0]], p[facet[1]], p[facet[2]], p[tet[apex]]);
            const std::size_t isAbove = side == Sign::Positive ? 1 : 0;
            const std::array<std::size_t, 4> key{facet[0], facet[1], facet[2], isAbove};
            ASSERT_EQ(++uses[key], 1);
        }
    }
}

template <class Point, std::size_t N>
std::set<std::vector<std::array<double, 3>>>
asPointSets(const std::vector<Point>& p, const std::vector<std::array<std::size_t, N>>& simplices)
{
    std::set<std::vector<std::array<double, 3>>> result;
    for (const auto& simplex : simplices) {
        std::vector<std::array<double, 3>> corners;
        for (const std::size_t i : simplex) {
            if constexpr (requires { p[i].z; })
                corners.push_back({p[i].x, p[i].y, p[i].z});
            else
                corners.push_back({p[i].x, p[i].y, 0.0});
        }
        std::sort(corners.begin(), corners.end());
        result.insert(corners);
    }
    return result;
}

template <class Point>
void shuffle(std::vector<Point>& points, Random& random)
{
    for (std::size_t i = points.size(); i > 1; --i) {
        std::swap(points[i - 1], points[random.below(static_cast<std::uint32_t>(i))]);
    }
}

void expectUniqueTiling(std::vector<Vec3> points, Random& random)
{
    const auto tets = perturbedDelaunay(points);
    ASSERT_EQ(total(tets, points, volumeOf), hullVolume(points, random));
    expectFacetsOnce(points, tets);
    const auto before = asPointSets(points, tets);
    shuffle(points, random);
    ASSERT_EQ(asPointSets(points, perturbedDelaunay(points)), before);
}

TEST(Perturbation, CubeIsTiledUniquely)
{
    std::vector<Vec3> cube;
    for (unsigned i = 0; i < 8; ++i) cube.push_back({double(i & 1), double((i >> 1) & 1), double(i >> 2)});
    Random random(8);
    for (int i = 0; i < 50; ++i) {
        shuffle(cube, random);
        ASSERT_EQ(total(perturbedDelaunay(cube), cube, volumeOf), 6.0);
        expectUniqueTiling(cube, random);
    }
}

TEST(Perturbation, GridSubsetsAreTiledUniquely)
{
    std::vector<Vec3> grid;
    for (unsigned i = 0; i < 27; ++i) grid.push_back({double(i % 3), double(i / 3 % 3), double(i / 9)});
    Random random(9);
    for (int i = 0; i < 3000; ++i) {
        SCOPED_TRACE(i);
        shuffle(grid, random);
        expectUniqueTiling({grid.begin(), grid.begin() + 5 + random.below(4)}, random);
        if (HasFatalFailure()) return;
    }
}

TEST(Perturbation, PlanarGridSubsetsAreTiledUniquely)
{
    std::vector<Vec2> grid;
    for (unsigned i = 0; i < 16; ++i) grid.push_back({double(i % 4), double(i / 4)});
    Random random(10);
    for (int i = 0; i < 5000; ++i) {
        SCOPED_TRACE(i);
        shuffle(grid, random);
        std::vector<Vec2> points(grid.begin(), grid.begin() + 4 + random.below(6));
        const auto triangles = perturbedDelaunay(points);
        ASSERT_EQ(total(triangles, points, areaOf), hullArea(points, random));
        const auto before = asPointSets(points, triangles);
        shuffle(points, random);
        ASSERT_EQ(asPointSets(points, perturbedDelaunay(points)), before);
    }
}

}  // namespace
}  // namespace mesher
