#include "support/sample_surfaces.h"

#include "base/indexed_map.h"
#include "delaunay/delaunay3d.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <utility>

namespace mesher::test {

namespace {

constexpr RegionId kOutside{0u};
constexpr RegionId kSolid{1u};

Vec3 unit(const Vec3& v) { return (1.0 / length(v)) * v; }

/// Ears of a polygon without regard to shape, the first that has no other corner in it.
std::vector<std::array<std::size_t, 3>> clipEars(const std::vector<Vec2>& polygon)
{
    std::vector<std::size_t> left(polygon.size());
    for (std::size_t i = 0; i < left.size(); ++i) left[i] = i;
    const auto turn = [&](std::size_t a, std::size_t b, std::size_t c) {
        return cross(polygon[b] - polygon[a], polygon[c] - polygon[a]);
    };
    std::vector<std::array<std::size_t, 3>> triangles;
    while (left.size() > 3) {
        for (std::size_t i = 0; i < left.size(); ++i) {
            const std::size_t a = left[(i + left.size() - 1) % left.size()];
            const std::size_t b = left[i];
            const std::size_t c = left[(i + 1) % left.size()];
            if (turn(a, b, c) <= 0.0) continue;
            const bool isEar = std::none_of(left.begin(), left.end(), [&](std::size_t p) {
                return p != a && p != b && p != c && turn(a, b, p) >= 0.0 && turn(b, c, p) >= 0.0 &&
                       turn(c, a, p) >= 0.0;
            });
            if (!isEar) continue;
            triangles.push_back({a, b, c});
            left.erase(left.begin() + static_cast<std::ptrdiff_t>(i));
            break;
        }
    }
    triangles.push_back({left[0], left[1], left[2]});
    return triangles;
}

void addQuad(SurfaceBuilder& builder, BrepFaceId face, const std::array<NodeId, 4>& q, bool isOther)
{
    if (isOther) {
        builder.addFacet(face, q[1], q[2], q[3]);
        builder.addFacet(face, q[1], q[3], q[0]);
    } else {
        builder.addFacet(face, q[0], q[1], q[2]);
        builder.addFacet(face, q[0], q[2], q[3]);
    }
}

/// Two polygons joined by walls; the upper one may be the lower one turned.
SampleSurface joinPolygons(const std::vector<Vec2>& low, const std::vector<Vec2>& high, double height,
                           const std::vector<char>& diagonal)
{
    SurfaceBuilder builder;
    std::vector<NodeId> bottom;
    std::vector<NodeId> top;
    for (const Vec2& p : low) bottom.push_back(builder.addNode({p.x, p.y, 0.0}));
    for (const Vec2& p : high) top.push_back(builder.addNode({p.x, p.y, height}));
    const BrepFaceId floor = builder.addFace(kOutside, kSolid);
    for (const auto& [a, b, c] : clipEars(low)) builder.addFacet(floor, bottom[a], bottom[c], bottom[b]);
    const BrepFaceId ceiling = builder.addFace(kOutside, kSolid);
    for (const auto& [a, b, c] : clipEars(high)) builder.addFacet(ceiling, top[a], top[b], top[c]);
    for (std::size_t i = 0; i < low.size(); ++i) {
        const std::size_t j = (i + 1) % low.size();
        addQuad(builder, builder.addFace(kOutside, kSolid), {bottom[i], bottom[j], top[j], top[i]},
                diagonal[i] != 0);
    }
    return builder.finish();
}

}  // namespace

NodeId SurfaceBuilder::addNode(const Vec3& position)
{
    const auto index = static_cast<std::uint32_t>(surface_.mesh.nodes.size());
    return surface_.mesh.nodes.push_back({position, {0, index}, {}});
}

BrepFaceId SurfaceBuilder::addFace(RegionId front, RegionId behind)
{
    return surface_.sides.push_back({front, behind});
}

void SurfaceBuilder::addFacet(BrepFaceId face, NodeId a, NodeId b, NodeId c)
{
    surface_.mesh.facets.push_back({{a, b, c}, face, {}});
}

SampleSurface SurfaceBuilder::finish()
{
    struct Use
    {
        BrepFaceId face;
        int count = 0;
        bool isFeature = false;
    };
    IndexedMap<std::pair<NodeId, NodeId>, Use> uses;
    for (const SurfaceFacet& facet : surface_.mesh.facets) {
        for (unsigned k = 0; k < 3; ++k) {
            Use& use = uses[unorderedPair(facet.node[k], facet.node[(k + 1) % 3])];
            use.isFeature |= use.count > 0 && use.face != facet.face;
            use.face = facet.face;
            ++use.count;
        }
    }
    std::uint32_t edges = 0;
    for (const auto& [key, use] : uses) {
        if (use.count == 2 && !use.isFeature) continue;
        surface_.mesh.segments.push_back({{key.first, key.second}, BrepEdgeId(edges++), {0.0, 1.0}});
    }
    return std::move(surface_);
}

SampleSurface convexHullSurface(std::size_t points, std::uint64_t seed)
{
    Random random(seed);
    Delaunay3d delaunay(seed);
    for (std::size_t i = 0; i < points; ++i) {
        const auto inserted = delaunay.insert(
            {random.between(-1.0, 1.0), random.between(-1.0, 1.0), random.between(-1.0, 1.0)});
        static_cast<void>(inserted);
    }
    const Triangulation3d& mesh = delaunay.triangulation();
    SurfaceBuilder builder;
    std::map<VertexId, NodeId> nodes;
    const auto nodeAt = [&](VertexId v) {
        const auto found = nodes.find(v);
        if (found != nodes.end()) return found->second;
        return nodes.emplace(v, builder.addNode(mesh.position(v))).first->second;
    };
    for (std::uint32_t i = 0; i < mesh.tetLimit(); ++i) {
        if (!mesh.isAlive(TetId(i)) || !mesh.isGhostTet(TetId(i))) continue;
        const auto& v = mesh.tet(TetId(i)).vertex;
        builder.addFacet(builder.addFace(kOutside, kSolid), nodeAt(v[0]), nodeAt(v[1]), nodeAt(v[2]));
    }
    return builder.finish();
}

SampleSurface prismSurface(std::size_t corners, double twist, std::uint64_t seed)
{
    Random random(seed);
    std::vector<Vec2> low;
    std::vector<Vec2> high;
    std::vector<char> diagonal;
    const double step = 2.0 * std::numbers::pi / static_cast<double>(corners);
    for (std::size_t i = 0; i < corners; ++i) {
        const double angle = step * (static_cast<double>(i) + random.between(-0.3, 0.3));
        const double radius = random.between(0.3, 1.5);
        low.push_back({radius * std::cos(angle), radius * std::sin(angle)});
        high.push_back({radius * std::cos(angle + twist), radius * std::sin(angle + twist)});
        diagonal.push_back(static_cast<char>(random.below(2)));
    }
    return joinPolygons(low, high, random.between(0.05, 3.0), diagonal);
}

SampleSurface schoenhardtSurface(double twist)
{
    std::vector<Vec2> low;
    std::vector<Vec2> high;
    for (int i = 0; i < 3; ++i) {
        const double angle = 2.0 * std::numbers::pi * i / 3.0;
        low.push_back({std::cos(angle), std::sin(angle)});
        high.push_back({std::cos(angle + twist), std::sin(angle + twist)});
    }
    // The diagonals on which the walls bend inward.
    return joinPolygons(low, high, 1.0, {0, 0, 0});
}

SampleSurface chazelleSurface(int notches, double gap)
{
    // The lower wedges run along x with their ridges on z = x y - gap, the upper ones along y on z = x y + gap.
    SurfaceBuilder builder;
    const int n = notches;
    const double size = n + 1.0;
    const double reach = size * size + 2.0;
    const auto ridge = [&](double x, double y, double side) { return x * y + side * gap; };
    const double slit = 0.05;
    // Outlines of the front (x = 0), back (x = size), left (y = 0) and right (y = size) walls share the corner posts.
    std::array<std::array<NodeId, 2>, 4> post;
    const std::array<Vec2, 4> corner{Vec2{0, 0}, Vec2{size, 0}, Vec2{size, size}, Vec2{0, size}};
    for (unsigned i = 0; i < 4; ++i) {
        post[i][0] = builder.addNode({corner[i].x, corner[i].y, -reach});
        post[i][1] = builder.addNode({corner[i].x, corner[i].y, reach});
    }
    struct Notch
    {
        std::array<std::array<NodeId, 3>, 2> end;  ///< one foot, ridge, other foot; at both walls
    };
    std::vector<Notch> lower;
    std::vector<Notch> upper;
    for (int i = 1; i <= n; ++i) {
        Notch low;
        Notch high;
        for (unsigned e = 0; e < 2; ++e) {
            const double at = e == 0 ? 0.0 : size;
            low.end[e] = {builder.addNode({at, i - slit, -reach}),
                          builder.addNode({at, double(i), ridge(at, i, -1.0)}),
                          builder.addNode({at, i + slit, -reach})};
            high.end[e] = {builder.addNode({i - slit, at, reach}),
                           builder.addNode({double(i), at, ridge(i, at, 1.0)}),
                           builder.addNode({i + slit, at, reach})};
        }
        lower.push_back(low);
        upper.push_back(high);
    }
    const auto addPolygon = [&](const std::vector<NodeId>& loop, auto&& project) {
        const BrepFaceId face = builder.addFace(kOutside, kSolid);
        std::vector<Vec2> flat;
        for (const NodeId node : loop) flat.push_back(project(builder.position(node)));
        for (const auto& [a, b, c] : clipEars(flat)) builder.addFacet(face, loop[a], loop[b], loop[c]);
    };
    // Walls, counter-clockwise from outside.
    for (unsigned e = 0; e < 2; ++e) {
        std::vector<NodeId> loop;
        const unsigned from = e == 0 ? 0 : 1;
        const unsigned to = e == 0 ? 3 : 2;
        loop.push_back(post[from][0]);
        for (const Notch& notch : lower) loop.insert(loop.end(), notch.end[e].begin(), notch.end[e].end());
        loop.push_back(post[to][0]);
        loop.push_back(post[to][1]);
        loop.push_back(post[from][1]);
        if (e == 0) std::reverse(loop.begin(), loop.end());
        addPolygon(loop, [&](const Vec3& p) { return e == 0 ? Vec2{-p.y, p.z} : Vec2{p.y, p.z}; });
    }
    for (unsigned e = 0; e < 2; ++e) {
        std::vector<NodeId> loop;
        const unsigned from = e == 0 ? 0 : 3;
        const unsigned to = e == 0 ? 1 : 2;
        loop.push_back(post[from][1]);
        for (const Notch& notch : upper) loop.insert(loop.end(), notch.end[e].begin(), notch.end[e].end());
        loop.push_back(post[to][1]);
        loop.push_back(post[to][0]);
        loop.push_back(post[from][0]);
        if (e == 0) std::reverse(loop.begin(), loop.end());
        addPolygon(loop, [&](const Vec3& p) { return e == 0 ? Vec2{p.x, p.z} : Vec2{-p.x, p.z}; });
    }
    // The floor and the ceiling between the wedges, and the flanks of these.
    const auto addStrip = [&](NodeId a, NodeId b, NodeId c, NodeId d) {
        addQuad(builder, builder.addFace(kOutside, kSolid), {a, b, c, d}, false);
    };
    std::array<NodeId, 2> last{post[0][0], post[1][0]};
    for (const Notch& notch : lower) {
        addStrip(last[0], notch.end[0][0], notch.end[1][0], last[1]);
        addStrip(notch.end[0][0], notch.end[0][1], notch.end[1][1], notch.end[1][0]);
        addStrip(notch.end[0][1], notch.end[0][2], notch.end[1][2], notch.end[1][1]);
        last = {notch.end[0][2], notch.end[1][2]};
    }
    addStrip(last[0], post[3][0], post[2][0], last[1]);
    last = {post[0][1], post[3][1]};
    for (const Notch& notch : upper) {
        addStrip(last[0], notch.end[0][0], notch.end[1][0], last[1]);
        addStrip(notch.end[0][0], notch.end[0][1], notch.end[1][1], notch.end[1][0]);
        addStrip(notch.end[0][1], notch.end[0][2], notch.end[1][2], notch.end[1][1]);
        last = {notch.end[0][2], notch.end[1][2]};
    }
    addStrip(last[0], post[1][1], post[2][1], last[1]);
    return builder.finish();
}

SampleSurface sphereSurface(int levels, double noise, std::uint64_t seed)
{
    Random random(seed);
    SurfaceBuilder builder;
    std::vector<NodeId> node;
    const auto addPoint = [&](const Vec3& p) {
        return builder.addNode((1.0 + noise * random.between(-1.0, 1.0)) * unit(p));
    };
    for (const double z : {1.0, -1.0}) node.push_back(addPoint({0, 0, z}));
    for (const Vec2 p : {Vec2{1, 0}, Vec2{0, 1}, Vec2{-1, 0}, Vec2{0, -1}})
        node.push_back(addPoint({p.x, p.y, 0}));
    std::vector<std::array<NodeId, 3>> triangles;
    for (unsigned i = 0; i < 4; ++i) {
        const NodeId a = node[2 + i];
        const NodeId b = node[2 + (i + 1) % 4];
        triangles.push_back({node[0], a, b});
        triangles.push_back({node[1], b, a});
    }
    for (int level = 0; level < levels; ++level) {
        IndexedMap<std::pair<NodeId, NodeId>, NodeId> middles;
        const auto middle = [&](NodeId a, NodeId b) {
            NodeId& m = middles[unorderedPair(a, b)];
            if (!m.isValid()) m = addPoint(unit(builder.position(a)) + unit(builder.position(b)));
            return m;
        };
        std::vector<std::array<NodeId, 3>> finer;
        for (const auto& [a, b, c] : triangles) {
            const NodeId ab = middle(a, b);
            const NodeId bc = middle(b, c);
            const NodeId ca = middle(c, a);
            for (const auto& t : {std::array{a, ab, ca}, {b, bc, ab}, {c, ca, bc}, {ab, bc, ca}})
                finer.push_back(t);
        }
        triangles = finer;
    }
    const BrepFaceId face = builder.addFace(kOutside, kSolid);
    for (const auto& [a, b, c] : triangles) builder.addFacet(face, a, b, c);
    return builder.finish();
}

SampleSurface torusSurface(int around, int across, double noise, std::uint64_t seed)
{
    Random random(seed);
    SurfaceBuilder builder;
    std::vector<NodeId> node;
    for (int i = 0; i < around; ++i) {
        for (int j = 0; j < across; ++j) {
            const double u = 2.0 * std::numbers::pi * (i + noise * random.between(-1.0, 1.0)) / around;
            const double v = 2.0 * std::numbers::pi * (j + noise * random.between(-1.0, 1.0)) / across;
            const double r = 0.4 * (1.0 + 0.1 * noise * random.between(-1.0, 1.0));
            node.push_back(builder.addNode({(1.0 + r * std::cos(v)) * std::cos(u),
                                            (1.0 + r * std::cos(v)) * std::sin(u), r * std::sin(v)}));
        }
    }
    const auto at = [&](int i, int j) {
        return node[static_cast<std::size_t>((i % around) * across + j % across)];
    };
    const BrepFaceId face = builder.addFace(kOutside, kSolid);
    for (int i = 0; i < around; ++i) {
        for (int j = 0; j < across; ++j) {
            addQuad(builder, face, {at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)},
                    random.below(2) == 1);
        }
    }
    return builder.finish();
}

SampleSurface cellSurface(std::array<int, 3> cells, std::uint32_t regions, double thinnest,
                          std::uint64_t seed)
{
    Random random(seed);
    std::array<std::vector<double>, 3> plane;
    for (unsigned axis = 0; axis < 3; ++axis) {
        double at = 0.0;
        for (int i = 0; i <= cells[axis]; ++i) {
            plane[axis].push_back(at);
            at += std::pow(thinnest, random.unit());
        }
    }
    std::map<std::array<int, 3>, std::uint32_t> regionOf;
    std::array<int, 3> at{};
    for (at[0] = 0; at[0] < cells[0]; ++at[0])
        for (at[1] = 0; at[1] < cells[1]; ++at[1])
            for (at[2] = 0; at[2] < cells[2]; ++at[2]) regionOf[at] = random.below(regions + 1);
    const auto region = [&](const std::array<int, 3>& cell) {
        const auto found = regionOf.find(cell);
        return found == regionOf.end() ? kOutside : RegionId(found->second);
    };
    SurfaceBuilder builder;
    std::map<std::array<int, 3>, NodeId> nodes;
    const auto nodeAt = [&](const std::array<int, 3>& p) {
        const auto found = nodes.find(p);
        if (found != nodes.end()) return found->second;
        const NodeId node = builder.addNode({plane[0][static_cast<std::size_t>(p[0])],
                                             plane[1][static_cast<std::size_t>(p[1])],
                                             plane[2][static_cast<std::size_t>(p[2])]});
        nodes.emplace(p, node);
        return node;
    };
    std::map<std::array<std::uint32_t, 4>, BrepFaceId> faces;
    for (unsigned axis = 0; axis < 3; ++axis) {
        const unsigned u = (axis + 1) % 3;
        const unsigned v = (axis + 2) % 3;
        std::array<int, 3> p{};
        for (p[axis] = 0; p[axis] <= cells[axis]; ++p[axis])
            for (p[u] = 0; p[u] < cells[u]; ++p[u])
                for (p[v] = 0; p[v] < cells[v]; ++p[v]) {
                    std::array<int, 3> before = p;
                    --before[axis];
                    const RegionId front = region(p);
                    const RegionId behind = region(before);
                    if (front == behind) continue;
                    BrepFaceId& face =
                        faces[{axis, static_cast<std::uint32_t>(p[axis]), front.value, behind.value}];
                    if (!face.isValid()) face = builder.addFace(front, behind);
                    std::array<NodeId, 4> corner;
                    for (unsigned k = 0; k < 4; ++k) {
                        std::array<int, 3> q = p;
                        q[u] += k == 1 || k == 2 ? 1 : 0;
                        q[v] += k >= 2 ? 1 : 0;
                        corner[k] = nodeAt(q);
                    }
                    addQuad(builder, face, corner, random.below(2) == 1);
                }
    }
    return builder.finish();
}

SampleSurface flippedBoxSurface(int squares, int flips, const Vec3& size, std::uint64_t seed)
{
    Random random(seed);
    SurfaceBuilder builder;
    std::map<std::array<int, 3>, NodeId> nodes;
    const auto nodeAt = [&](const std::array<int, 3>& p) {
        const auto found = nodes.find(p);
        if (found != nodes.end()) return found->second;
        const NodeId node =
            builder.addNode({size.x * p[0] / squares, size.y * p[1] / squares, size.z * p[2] / squares});
        nodes.emplace(p, node);
        return node;
    };
    for (unsigned axis = 0; axis < 3; ++axis) {
        for (const int level : {0, squares}) {
            const BrepFaceId face =
                builder.addFace(level == 0 ? kSolid : kOutside, level == 0 ? kOutside : kSolid);
            // In the plane: points by index, triangles, and random flips of strictly convex pairs.
            std::vector<std::array<int, 3>> triangles;
            const auto index = [&](int i, int j) { return i * (squares + 1) + j; };
            for (int i = 0; i < squares; ++i)
                for (int j = 0; j < squares; ++j) {
                    triangles.push_back({index(i, j), index(i + 1, j), index(i + 1, j + 1)});
                    triangles.push_back({index(i, j), index(i + 1, j + 1), index(i, j + 1)});
                }
            const auto turn = [&](int a, int b, int c) {
                const auto point = [&](int p) {
                    return Vec2{double(p / (squares + 1)), double(p % (squares + 1))};
                };
                return cross(point(b) - point(a), point(c) - point(a));
            };
            for (int flip = 0; flip < flips; ++flip) {
                const std::size_t t = random.below(static_cast<std::uint32_t>(triangles.size()));
                const unsigned k = random.below(3);
                const auto one = triangles[t];
                const int a = one[k];
                const int b = one[(k + 1) % 3];
                const int c = one[(k + 2) % 3];
                for (std::size_t s = 0; s < triangles.size(); ++s) {
                    const auto other = triangles[s];
                    for (unsigned m = 0; m < 3; ++m) {
                        if (other[m] != b || other[(m + 1) % 3] != a) continue;
                        const int d = other[(m + 2) % 3];
                        if (turn(c, a, d) <= 0.0 || turn(d, b, c) <= 0.0) continue;
                        triangles[t] = {c, a, d};
                        triangles[s] = {d, b, c};
                    }
                }
            }
            for (const auto& triangle : triangles) {
                std::array<NodeId, 3> corner;
                for (unsigned m = 0; m < 3; ++m) {
                    std::array<int, 3> p{};
                    p[axis] = level;
                    p[(axis + 1) % 3] = triangle[m] / (squares + 1);
                    p[(axis + 2) % 3] = triangle[m] % (squares + 1);
                    corner[m] = nodeAt(p);
                }
                builder.addFacet(face, corner[0], corner[1], corner[2]);
            }
        }
    }
    return builder.finish();
}

void rotateRandomly(SampleSurface& surface, std::uint64_t seed)
{
    Random random(seed);
    const Vec3 x = unit({random.between(-1, 1), random.between(-1, 1), random.between(0.1, 1)});
    const Vec3 y = unit(cross(x, {random.between(-1, 1), random.between(0.1, 1), random.between(-1, 1)}));
    const Vec3 z = cross(x, y);
    for (MeshNode& node : surface.mesh.nodes) {
        node.position = node.position.x * x + node.position.y * y + node.position.z * z;
    }
}

SampleSurface randomSurface(std::uint64_t seed, std::string& name)
{
    Random random(seed);
    const auto count = [&](int low, int high) {
        return low + static_cast<int>(random.below(static_cast<std::uint32_t>(high - low + 1)));
    };
    SampleSurface surface;
    switch (seed % 8) {
        case 0:
            name = "convex hull";
            surface = convexHullSurface(static_cast<std::size_t>(count(4, 200)), random());
            break;
        case 1:
            name = "prism";
            surface = prismSurface(static_cast<std::size_t>(count(3, 60)), 0.0, random());
            break;
        case 2:
            name = "twisted prism";
            surface = schoenhardtSurface(random.between(0.05, 0.9));
            break;
        case 3:
            name = "saddle";
            surface = chazelleSurface(count(1, 4), random.between(0.05, 0.5));
            break;
        case 4:
            name = "star";
            surface = sphereSurface(count(0, 4), random.between(0.0, 0.8), random());
            break;
        case 5:
            name = "torus";
            surface = torusSurface(count(8, 40), count(7, 20), random.between(0.0, 0.2), random());
            break;
        case 6:
            name = "cells";
            surface = cellSurface({count(1, 6), count(1, 6), count(1, 6)}, random.below(4) + 1,
                                  std::pow(10.0, -3.0 * random.unit()), random());
            break;
        default:
            name = "flipped box";
            surface = flippedBoxSurface(
                count(1, 12), count(0, 2000),
                {1.0, std::pow(10.0, random.between(-2.0, 1.0)), std::pow(10.0, random.between(-2.0, 1.0))},
                random());
            break;
    }
    if (random.below(2) == 1) {
        rotateRandomly(surface, random());
        name += ", turned";
    }
    return surface;
}

}  // namespace mesher::test
