#pragma once

#include "delaunay/delaunay2d.h"
#include "delaunay/delaunay_check2d.h"
#include "delaunay/mesh_hash2d.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <utility>
#include <vector>

namespace mesher::test {

/// Succeeds if the triangulation passes all linear checks; with few vertices and no constraints also the quadratic one.
inline testing::AssertionResult isSound(const Delaunay2d& delaunay)
{
    constexpr std::size_t kFewVertices = 150;
    CheckReport report = checkDelaunay2d(delaunay.mesh());
    bool isConstrained = false;
    for (std::uint32_t i = 0; i < delaunay.mesh().triangleSlots(); ++i) {
        const Triangle2d& record = delaunay.mesh().triangle(TriangleId(i));
        isConstrained |= record.isAlive() && (record.flags & Triangle2d::kConstrainedEdges) != 0;
    }
    if (report.isValid() && !isConstrained && delaunay.mesh().vertexCount() <= kFewVertices) {
        report = checkEmptyCircles2d(delaunay.mesh());
    }
    if (report.isValid()) return testing::AssertionSuccess();
    return testing::AssertionFailure() << report.problem;
}

inline std::uint64_t hashOf(const Delaunay2d& delaunay) { return meshHash2d(delaunay.mesh()); }

/// Inserts one by one, in the given order.
inline Delaunay2d insertedOneByOne(const std::vector<Vec2>& points)
{
    Delaunay2d delaunay;
    for (const Vec2 p : points) EXPECT_TRUE(delaunay.insert(p).hasValue());
    return delaunay;
}

inline Delaunay2d insertedInBulk(const std::vector<Vec2>& points, std::uint64_t seed = 1)
{
    Delaunay2d delaunay(seed);
    EXPECT_TRUE(delaunay.insertPoints(points).hasValue());
    return delaunay;
}

/// The undirected edges of finite triangles, as pairs of positions in the order of the vertex ids.
inline std::vector<std::pair<VertexId, VertexId>> edgesOf(const Triangulation2d& mesh)
{
    std::vector<std::pair<VertexId, VertexId>> edges;
    for (std::uint32_t i = 0; i < mesh.triangleSlots(); ++i) {
        const TriangleId t(i);
        if (!mesh.isAlive(t) || mesh.triangle(t).isGhost()) continue;
        for (unsigned edge = 0; edge < 3; ++edge) {
            const EdgeLink link(t, edge);
            const bool isFirstSide =
                link < mesh.across(link) || mesh.triangle(mesh.across(link).triangle()).isGhost();
            if (isFirstSide) edges.emplace_back(mesh.edgeFrom(link), mesh.edgeTo(link));
        }
    }
    return edges;
}

}  // namespace mesher::test
