#include "delaunay/edge_linker.h"

#include "support/triangulations3d.h"

#include <gtest/gtest.h>

#include <map>
#include <set>

namespace mesher::test {
namespace {

using Facet = std::array<VertexId, 3>;

/// The surface of the convex hull of points on a sphere: a closed oriented surface of any number of vertices.
std::vector<Facet> hullOf(const std::vector<Vec3>& points)
{
    Delaunay3d delaunay;
    insertAll(delaunay, points);
    const Triangulation3d& mesh = delaunay.triangulation();
    std::vector<Facet> facets;
    for (const TetId tet : liveTets(mesh)) {
        if (mesh.isGhostTet(tet))
            facets.push_back({mesh.vertex(tet, 0), mesh.vertex(tet, 1), mesh.vertex(tet, 2)});
    }
    return facets;
}

/// Links all edges and compares with a search.
void expectLinks(EdgeLinker<std::uint32_t>& linker, const std::vector<Facet>& facets, std::uint32_t limit)
{
    linker.begin(limit);
    std::vector<std::array<std::uint32_t, 3>> local;
    for (const Facet& f : facets)
        local.push_back({linker.number(f[0]), linker.number(f[1]), linker.number(f[2])});
    linker.prepare();
    std::map<std::pair<VertexId, VertexId>, std::uint32_t> expected;
    for (std::uint32_t i = 0; i < facets.size(); ++i) {
        for (unsigned k = 0; k < 3; ++k) {
            linker.put(local[i][k], local[i][(k + 1) % 3], i);
            expected[{facets[i][k], facets[i][(k + 1) % 3]}] = i;
        }
    }
    for (std::uint32_t i = 0; i < facets.size(); ++i) {
        for (unsigned k = 0; k < 3; ++k) {
            const auto other = expected.find({facets[i][(k + 1) % 3], facets[i][k]});
            ASSERT_TRUE(other != expected.end());
            ASSERT_EQ(linker.get(local[i][(k + 1) % 3], local[i][k]), other->second);
        }
    }
}

TEST(EdgeLinker, LinksSmallAndLargeSurfacesByTurns)
{
    EdgeLinker<std::uint32_t> linker;
    // Beyond 64 vertices the table grows, beyond 1024 the edges are hashed; then small ones again.
    for (const std::size_t count : {4u, 60u, 200u, 1000u, 1024u, 1025u, 3000u, 10u, 1500u, 64u, 65u, 5u}) {
        SCOPED_TRACE(count);
        const std::vector<Facet> facets = hullOf(spherePoints3d(count, count));
        ASSERT_EQ(facets.size(), 2 * count - 4);
        expectLinks(linker, facets, static_cast<std::uint32_t>(count));
    }
    EXPECT_GT(linker.bytes(), 0u);
}

TEST(EdgeLinker, TakesTheGhostForAVertex)
{
    EdgeLinker<std::uint32_t> linker;
    const VertexId a(0u), b(1u), c(2u);
    expectLinks(linker, {{a, b, c}, {b, a, kGhostVertex}, {c, b, kGhostVertex}, {a, c, kGhostVertex}}, 3);
}

/// A far point sees half of a large sphere sample: the cavity has thousands of vertices.
TEST(EdgeLinker, LinksTheCavityOfAFarPoint)
{
    std::vector<Vec3> points = spherePoints3d(6000, 5);
    for (const bool isConstrained : {false, true}) {
        Delaunay3d delaunay;
        insertAll(delaunay, points);
        if (isConstrained) {
            const TetId tet = finiteTets(delaunay.triangulation()).front();
            delaunay.triangulation().setEdgeConstrained(tet, delaunay.triangulation().vertex(tet, 0),
                                                        delaunay.triangulation().vertex(tet, 1), true);
        }
        const Vec3 far{40, 30, 20};
        const Result<Location3d> location = delaunay.locate(far);
        const Cavity3d& cavity = delaunay.findCavity(far, *location, ConstraintPolicy::Refuse);
        std::set<VertexId> vertices;
        for (const CavityFace3d& face : cavity.faces) vertices.insert(face.vertex.begin(), face.vertex.end());
        EXPECT_GT(vertices.size(), 1024u);
        const Insertion3d inserted = delaunay.commit();
        EXPECT_EQ(inserted.status, InsertionStatus::Inserted);
        EXPECT_TRUE(isSoundTopology(delaunay.triangulation()));
        EXPECT_TRUE(isConstrained || isDelaunay(delaunay.triangulation(), DelaunayScope::Local));
        if (isConstrained) continue;
        std::vector<Vec3> all = points;
        all.push_back(far);
        EXPECT_EQ(meshHash3d(delaunay.triangulation()), hashOf(all));
        EXPECT_EQ(delaunay.remove(inserted.vertex), RemovalStatus::Removed);
        EXPECT_EQ(meshHash3d(delaunay.triangulation()), hashOf(points));
    }
}

}  // namespace
}  // namespace mesher::test
