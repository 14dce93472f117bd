#include "support/face_examples.h"

#include "brep/analytic/bspline_surface.h"
#include "brep/analytic/round_surfaces.h"
#include "quality/triangle_measures.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace mesher::test {
namespace {

constexpr std::uint8_t kOnEdge = 1, kOnFace = 2;

TriangleCorners cornersOf(const FaceMesh& mesh, TriangleId t)
{
    const FaceTriangle& record = mesh.triangle(t);
    return {mesh.position(record.v[0]), mesh.position(record.v[1]), mesh.position(record.v[2])};
}

template <class Visit>
void forEachTriangle(const FaceMesh& mesh, Visit&& visit)
{
    for (std::uint32_t i = 0; i < mesh.triangleSlots(); ++i) {
        if (mesh.triangle(TriangleId(i)).isAlive) visit(cornersOf(mesh, TriangleId(i)));
    }
}

}  // namespace

FaceExample gridFace(std::shared_ptr<const Surface> surface, Interval u, Interval v, std::size_t cellsU,
                     std::size_t cellsV, GridClosure closure)
{
    FaceExample example;
    example.face.surface = std::move(surface);
    example.face.boundsU = u;
    example.face.boundsV = v;
    const std::size_t columns = closure.isClosedU ? cellsU : cellsU + 1;
    const std::size_t rows = closure.isClosedV ? cellsV : cellsV + 1;
    const auto parameters = [&](std::size_t i, std::size_t j) {
        return Vec2{u.at(static_cast<double>(i) / static_cast<double>(cellsU)),
                    v.at(static_cast<double>(j) / static_cast<double>(cellsV))};
    };
    const auto nodeOf = [&](std::size_t i, std::size_t j) {
        return NodeId(static_cast<std::uint32_t>((i % columns) * rows + j % rows));
    };
    for (std::size_t i = 0; i < columns; ++i) {
        for (std::size_t j = 0; j < rows; ++j) {
            const bool isBorder = (!closure.isClosedU && (i == 0 || i == cellsU)) ||
                                  (!closure.isClosedV && (j == 0 || j == cellsV));
            const Vec2 uv = parameters(i, j);
            example.nodes.push_back(
                {example.face.surface->position(uv), {isBorder ? kOnEdge : kOnFace, 0}, uv});
        }
    }
    for (std::size_t i = 0; i < cellsU; ++i) {
        for (std::size_t j = 0; j < cellsV; ++j) {
            const NodeId a = nodeOf(i, j), b = nodeOf(i + 1, j), c = nodeOf(i + 1, j + 1),
                         d = nodeOf(i, j + 1);
            const Vec2 pa = parameters(i, j), pb = parameters(i + 1, j), pc = parameters(i + 1, j + 1),
                       pd = parameters(i, j + 1);
            example.facets.push_back({{a, b, c}, BrepFaceId(0), {pa, pb, pc}});
            example.facets.push_back({{a, c, d}, BrepFaceId(0), {pa, pc, pd}});
        }
    }
    std::uint32_t next = 0;
    const auto addSegment = [&](NodeId a, NodeId b) {
        example.segments.insert(std::pair(std::min(a, b), std::max(a, b)), SegmentId(next++));
    };
    for (std::size_t i = 0; i < cellsU && !closure.isClosedV; ++i) {
        addSegment(nodeOf(i, 0), nodeOf(i + 1, 0));
        addSegment(nodeOf(i, cellsV), nodeOf(i + 1, cellsV));
    }
    for (std::size_t j = 0; j < cellsV && !closure.isClosedU; ++j) {
        addSegment(nodeOf(0, j), nodeOf(0, j + 1));
        addSegment(nodeOf(cellsU, j), nodeOf(cellsU, j + 1));
    }
    return example;
}

FaceExample octahedronOnSphere(double radius)
{
    constexpr double kQuarter = 0.5 * std::numbers::pi;
    FaceExample example;
    example.face.surface = std::make_shared<SphereSurface>(Axes{}, radius);
    example.face.boundsU = {0.0, 4.0 * kQuarter};
    example.face.boundsV = {-kQuarter, kQuarter};
    const auto add = [&](Vec2 uv, std::uint8_t dimension) {
        example.nodes.push_back({example.face.surface->position(uv), {dimension, 0}, uv});
    };
    add({0.0, -kQuarter}, 0);
    add({0.0, kQuarter}, 0);
    for (std::uint32_t i = 0; i < 4; ++i) add({(i + 0.5) * kQuarter, 0.0}, kOnFace);
    for (std::uint32_t i = 0; i < 4; ++i) {
        const NodeId a(2 + i), b(2 + (i + 1) % 4);
        const Vec2 pa{(i + 0.5) * kQuarter, 0.0}, pb{(i + 1.5) * kQuarter, 0.0};
        example.facets.push_back({{a, b, NodeId(1)}, BrepFaceId(0), {pa, pb, Vec2{0.0, kQuarter}}});
        example.facets.push_back({{b, a, NodeId(0)}, BrepFaceId(0), {pb, pa, Vec2{0.0, -kQuarter}}});
    }
    return example;
}

std::shared_ptr<const Surface> wavySpline()
{
    BSplineSurfaceData data;
    data.knotsU = data.knotsV = {0, 0, 0, 0, 1, 2, 3, 4, 4, 4, 4};
    for (int i = 0; i < 7; ++i) {
        for (int j = 0; j < 7; ++j) {
            data.poles.push_back({i * 4.0 / 6.0, j * 4.0 / 6.0, 0.5 * std::sin(1.7 * i) * std::cos(1.3 * j)});
        }
    }
    return std::make_shared<BSplineSurface>(std::move(data), Interval{0.0, 4.0}, Interval{0.0, 4.0});
}

double smallestAngle(const FaceMesh& mesh)
{
    double least = 180.0;
    forEachTriangle(mesh, [&](const TriangleCorners& c) { least = std::min(least, shapeOf(c).minAngle); });
    return least;
}

double longestEdge(const FaceMesh& mesh)
{
    double longest = 0.0;
    forEachTriangle(mesh,
                    [&](const TriangleCorners& c) { longest = std::max(longest, shapeOf(c).longestEdge); });
    return longest;
}

double areaOf(const FaceMesh& mesh)
{
    double area = 0.0;
    forEachTriangle(mesh, [&](const TriangleCorners& c) { area += shapeOf(c).area; });
    return area;
}

}  // namespace mesher::test
