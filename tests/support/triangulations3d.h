#pragma once

#include "base/random.h"
#include "delaunay/delaunay3d.h"
#include "delaunay/delaunay_check3d.h"
#include "delaunay/mesh_hash.h"
#include "support/degenerate_points.h"

#include <gtest/gtest.h>

#include <cmath>
#include <span>
#include <vector>

namespace mesher::test {

/// Inserts all points at once; a refusal fails the test.
inline BulkInsertion3d insertAll(Delaunay3d& delaunay, std::span<const Vec3> points,
                                 const BulkInsertionOptions3d& options = {})
{
    RunContext context;
    Result<BulkInsertion3d> result = delaunay.insertPoints(points, options, context);
    EXPECT_TRUE(result.hasValue()) << (result.hasValue() ? std::string() : describe(result.error()));
    return result.hasValue() ? result.value() : BulkInsertion3d{};
}

/// Inserts the points one by one; a refusal fails the test.
inline void insertEach(Delaunay3d& delaunay, std::span<const Vec3> points)
{
    for (const Vec3& p : points) {
        const Result<Insertion3d> result = delaunay.insert(p);
        ASSERT_TRUE(result.hasValue());
        ASSERT_TRUE(result->status == InsertionStatus::Inserted ||
                    result->status == InsertionStatus::Duplicate);
    }
}

inline std::uint64_t hashOf(std::span<const Vec3> points)
{
    Delaunay3d delaunay;
    insertAll(delaunay, points);
    return meshHash3d(delaunay.triangulation());
}

inline std::vector<VertexId> liveVertices(const Triangulation3d& mesh)
{
    std::vector<VertexId> vertices;
    for (std::uint32_t i = 0; i < mesh.vertexLimit(); ++i) {
        if (mesh.isVertexAlive(VertexId(i))) vertices.push_back(VertexId(i));
    }
    return vertices;
}

inline std::vector<TetId> liveTets(const Triangulation3d& mesh)
{
    std::vector<TetId> tets;
    for (std::uint32_t i = 0; i < mesh.tetLimit(); ++i) {
        if (mesh.isAlive(TetId(i))) tets.push_back(TetId(i));
    }
    return tets;
}

inline std::vector<TetId> finiteTets(const Triangulation3d& mesh)
{
    std::vector<TetId> tets = liveTets(mesh);
    std::erase_if(tets, [&](TetId t) { return mesh.isGhostTet(t); });
    return tets;
}

inline double volumeOf(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d)
{
    return dot(b - a, cross(c - a, d - a)) / 6.0;
}

inline double volumeOf(const Triangulation3d& mesh, TetId tet)
{
    const auto& v = mesh.tet(tet).vertex;
    return volumeOf(mesh.position(v[0]), mesh.position(v[1]), mesh.position(v[2]), mesh.position(v[3]));
}

inline testing::AssertionResult isSoundTopology(const Triangulation3d& mesh)
{
    const CheckReport report = checkTopology3d(mesh);
    if (report.isValid()) return testing::AssertionSuccess();
    return testing::AssertionFailure() << report.violations << " violations, first: " << report.problem;
}

inline testing::AssertionResult isDelaunay(const Triangulation3d& mesh, DelaunayScope scope)
{
    const CheckReport report = checkDelaunay3d(mesh, scope);
    if (report.isValid()) return testing::AssertionSuccess();
    return testing::AssertionFailure() << report.violations << " violations, first: " << report.problem;
}

/// The state of a mesh as far as an operation that only looks must leave it alone: tetrahedra, flags and generations.
inline std::uint64_t stateHash(const Triangulation3d& mesh)
{
    std::uint64_t h = meshHash3d(mesh);
    for (std::uint32_t i = 0; i < mesh.tetLimit(); ++i) {
        h = mixBits(h * 3 + mesh.flags(TetId(i)));
        h = mixBits(h * 3 + mesh.generation(TetId(i)));
        h = mixBits(h * 3 + mesh.region(TetId(i)).value);
    }
    return mixBits(h + mesh.vertexCount());
}

}  // namespace mesher::test
