#include "delaunay/triangulation3d.h"

#include "support/triangulations3d.h"

#include <gtest/gtest.h>

#include <bit>
#include <set>

namespace mesher::test {
namespace {

TEST(TetFace, PacksAndOrientsItsFace)
{
    const TetFace face(TetId(123456u), 3);
    EXPECT_EQ(face.tet(), TetId(123456u));
    EXPECT_EQ(face.face(), 3);
    EXPECT_FALSE(TetFace().isValid());
    for (int i = 0; i < 4; ++i) {
        // (f0, f1, f2, i) is an even permutation: an even number of inversions.
        const int order[4] = {kFaceSlots[i][0], kFaceSlots[i][1], kFaceSlots[i][2], i};
        int inversions = 0;
        for (int a = 0; a < 4; ++a) {
            for (int b = a + 1; b < 4; ++b) inversions += order[a] > order[b] ? 1 : 0;
        }
        EXPECT_EQ(inversions % 2, 0);
    }
    for (int e = 0; e < 6; ++e) {
        EXPECT_EQ(kEdgeOfSlots[kEdgeSlots[e][0]][kEdgeSlots[e][1]], e);
        EXPECT_EQ(kEdgeOfSlots[kEdgeSlots[e][1]][kEdgeSlots[e][0]], e);
    }
}

TEST(Triangulation3d, ReusesVerticesLastFirst)
{
    Triangulation3d mesh;
    for (int i = 0; i < 5; ++i) mesh.addVertex({double(i), 0, 0});
    mesh.setLengthScale(VertexId(3), 7.0);
    mesh.removeVertex(VertexId(1));
    mesh.removeVertex(VertexId(3));
    EXPECT_EQ(mesh.vertexCount(), 3u);
    EXPECT_EQ(mesh.vertexLimit(), 5u);
    EXPECT_FALSE(mesh.isVertexAlive(VertexId(1)));
    EXPECT_FALSE(mesh.isVertexAlive(VertexId(5)));
    EXPECT_EQ(mesh.addVertex({9, 9, 9}, {1, 0, 4}), VertexId(3));
    EXPECT_EQ(mesh.lengthScale(VertexId(3)), 0.0);
    EXPECT_FALSE(mesh.incidentTet(VertexId(3)).isValid());
    EXPECT_EQ(mesh.classification(VertexId(3)), (VertexClass{1, 0, 4}));
    EXPECT_EQ(mesh.addVertex({8, 8, 8}), VertexId(1));
    EXPECT_EQ(mesh.addVertex({7, 7, 7}), VertexId(5));
    EXPECT_EQ(mesh.vertexCount(), 6u);
}

TEST(Triangulation3d, TellsStaleEntriesByTheGeneration)
{
    Triangulation3d mesh;
    const TetId tet = mesh.allocateTet();
    EXPECT_TRUE(mesh.isAlive(tet));
    EXPECT_EQ(mesh.region(tet), kExteriorRegion);
    const std::uint16_t first = mesh.generation(tet);
    mesh.state(tet).flags |= tet_flag::face(2);
    mesh.setRegion(tet, RegionId(5u));
    mesh.freeTet(tet);
    EXPECT_FALSE(mesh.isAlive(tet));
    EXPECT_EQ(mesh.tetCount(), 0u);
    EXPECT_EQ(mesh.tetLimit(), 1u);
    const std::uint16_t freed = mesh.generation(tet);
    EXPECT_NE(freed, first);
    ASSERT_EQ(mesh.allocateTet(), tet);
    EXPECT_NE(mesh.generation(tet), first);
    EXPECT_NE(mesh.generation(tet), freed);
    EXPECT_EQ(mesh.flags(tet), 0);
    EXPECT_EQ(mesh.region(tet), kExteriorRegion);
    mesh.state(tet).flags |= tet_flag::edge(4);
    const std::uint16_t used = mesh.generation(tet);
    mesh.renewTet(tet);
    EXPECT_NE(mesh.generation(tet), used);
    EXPECT_EQ(mesh.flags(tet), 0);
}

TEST(Triangulation3d, KeepsGenerationsApartAcrossCompaction)
{
    Triangulation3d mesh;
    std::set<std::pair<std::uint32_t, std::uint16_t>> entries;
    const auto note = [&](TetId tet) {
        EXPECT_TRUE(entries.insert({tet.value, mesh.generation(tet)}).second)
            << "an old queue entry passes for a new one at slot " << tet.value;
    };
    for (int i = 0; i < 20; ++i) note(mesh.allocateTet());
    for (std::uint32_t i = 5; i < 20; ++i) mesh.freeTet(TetId(i));
    for (std::uint32_t i = 0; i < 5; ++i) {
        for (int face = 0; face < 4; ++face)
            mesh.tet(TetId(i)).neighbour[unsigned(face)] = TetFace(TetId(i), face);
    }
    mesh.compact();
    EXPECT_EQ(mesh.tetLimit(), 5u);
    for (std::uint32_t i = 0; i < 5; ++i) note(TetId(i));
    for (int i = 0; i < 20; ++i) note(mesh.allocateTet());
}

class Triangulation3dOfPoints : public testing::Test
{
protected:
    Triangulation3dOfPoints() { insertAll(delaunay_, uniformPoints3d(80, 12)); }

    Triangulation3d& mesh() { return delaunay_.triangulation(); }

    Delaunay3d delaunay_;
};

TEST_F(Triangulation3dOfPoints, FindsEveryEdgeAndFaceAndNoOther)
{
    std::set<std::pair<VertexId, VertexId>> edges;
    for (const TetId tet : liveTets(mesh())) {
        for (int i = 0; i < 4; ++i) {
            const auto [a, b, c] = mesh().faceVertices({tet, i});
            for (const auto& [x, y, z] : {std::tuple{a, b, c}, std::tuple{c, b, a}, std::tuple{b, c, a}}) {
                const TetFace found = mesh().findFace(x, y, z);
                ASSERT_TRUE(found.isValid());
                ASSERT_TRUE(found == TetFace(tet, i) || found == mesh().neighbour(tet, i));
            }
        }
        for (const auto& slots : kEdgeSlots) {
            const VertexId a = mesh().vertex(tet, slots[0]);
            const VertexId b = mesh().vertex(tet, slots[1]);
            edges.insert({std::min(a, b), std::max(a, b)});
        }
    }
    for (const VertexId a : liveVertices(mesh())) {
        for (const VertexId b : liveVertices(mesh())) {
            if (!(a < b)) continue;
            const TetId found = mesh().findEdge(a, b);
            ASSERT_EQ(found.isValid(), edges.count({a, b}) > 0);
            if (!found.isValid()) continue;
            EXPECT_GE(mesh().slotOf(found, a), 0);
            EXPECT_GE(mesh().slotOf(found, b), 0);
        }
        const TetId ghost = mesh().findEdge(kGhostVertex, a);
        EXPECT_EQ(ghost.isValid(), edges.count({a, kGhostVertex}) > 0);
    }
}

TEST_F(Triangulation3dOfPoints, CollectsStarsAndRingsCompletely)
{
    for (const VertexId v : liveVertices(mesh())) {
        std::vector<TetId> star;
        mesh().collectStar(v, star);
        std::vector<TetId> expected = liveTets(mesh());
        std::erase_if(expected, [&](TetId t) { return mesh().slotOf(t, v) < 0; });
        std::sort(star.begin(), star.end());
        EXPECT_EQ(star, expected);
    }
    for (const TetId tet : liveTets(mesh())) {
        for (const auto& slots : kEdgeSlots) {
            const VertexId a = mesh().vertex(tet, slots[0]);
            const VertexId b = mesh().vertex(tet, slots[1]);
            std::vector<TetId> ring;
            mesh().collectEdgeRing(tet, a, b, ring);
            EXPECT_EQ(ring.front(), tet);
            for (std::size_t i = 0; i < ring.size(); ++i) {
                bool isNext = false;
                for (int face = 0; face < 4; ++face) {
                    isNext |= mesh().neighbour(ring[i], face).tet() == ring[(i + 1) % ring.size()];
                }
                EXPECT_TRUE(isNext);
            }
            std::vector<TetId> reversed;
            mesh().collectEdgeRing(tet, b, a, reversed);
            ASSERT_EQ(reversed.size(), ring.size());
            for (std::size_t i = 1; i < ring.size(); ++i) EXPECT_EQ(reversed[i], ring[ring.size() - i]);
            std::vector<TetId> expected = liveTets(mesh());
            std::erase_if(expected,
                          [&](TetId t) { return mesh().slotOf(t, a) < 0 || mesh().slotOf(t, b) < 0; });
            std::sort(ring.begin(), ring.end());
            EXPECT_EQ(ring, expected);
        }
    }
}

TEST_F(Triangulation3dOfPoints, KeepsConstraintFlagsEqualInAllCopies)
{
    EXPECT_FALSE(mesh().wasConstrained());
    const TetId tet = finiteTets(mesh())[10];
    const TetFace face(tet, 2);
    mesh().setFaceConstrained(face, true);
    EXPECT_TRUE(mesh().wasConstrained());
    EXPECT_TRUE(mesh().isFaceConstrained(face));
    EXPECT_TRUE(mesh().isFaceConstrained(mesh().neighbour(face)));
    const VertexId a = mesh().vertex(tet, 1);
    const VertexId b = mesh().vertex(tet, 3);
    mesh().setEdgeConstrained(tet, a, b, true);
    std::vector<TetId> ring;
    mesh().collectEdgeRing(tet, a, b, ring);
    for (const TetId t : ring) {
        EXPECT_TRUE(mesh().isEdgeConstrained(t, kEdgeOfSlots[mesh().slotOf(t, a)][mesh().slotOf(t, b)]));
    }
    EXPECT_TRUE(isSoundTopology(mesh()));
    int flagged = 0;
    for (const TetId t : liveTets(mesh()))
        flagged += std::popcount(unsigned(mesh().flags(t) & tet_flag::kConstraints));
    EXPECT_EQ(flagged, 2 + static_cast<int>(ring.size()));
    mesh().setFaceConstrained(mesh().neighbour(face), false);
    mesh().setEdgeConstrained(ring.back(), b, a, false);
    for (const TetId t : liveTets(mesh())) EXPECT_EQ(mesh().flags(t), 0);
    EXPECT_TRUE(mesh().wasConstrained());
    mesh().clear();
    EXPECT_FALSE(mesh().wasConstrained());
}

TEST_F(Triangulation3dOfPoints, CompactsWithoutGaps)
{
    std::vector<VertexId> vertices = liveVertices(mesh());
    for (std::size_t i = 0; i < vertices.size(); i += 3)
        ASSERT_EQ(delaunay_.remove(vertices[i]), RemovalStatus::Removed);
    const TetId marked = finiteTets(mesh())[3];
    mesh().setFaceConstrained({marked, 1}, true);
    mesh().setRegion(marked, RegionId(9u));
    const auto corners = mesh().tet(marked).vertex;
    const std::uint64_t hash = meshHash3d(mesh());
    std::vector<std::pair<TetId, std::uint16_t>> entries;
    for (const TetId t : liveTets(mesh())) entries.push_back({t, mesh().generation(t)});
    const Renumbering3d map = mesh().compact();
    EXPECT_EQ(mesh().tetLimit(), mesh().tetCount());
    EXPECT_EQ(mesh().vertexLimit(), mesh().vertexCount());
    EXPECT_EQ(meshHash3d(mesh()), hash);
    const TetId moved = map.tet[marked];
    EXPECT_TRUE(mesh().isFaceConstrained({moved, 1}));
    EXPECT_EQ(mesh().region(moved), RegionId(9u));
    for (unsigned slot = 0; slot < 4; ++slot) {
        EXPECT_EQ(mesh().tet(moved).vertex[slot],
                  isGhost(corners[slot]) ? corners[slot] : map.vertex[corners[slot]]);
    }
    for (const auto& [t, generation] : entries) {
        if (t.value >= mesh().tetLimit()) continue;
        EXPECT_NE(mesh().generation(t), generation);
    }
    for (const VertexId v : liveVertices(mesh())) EXPECT_GE(mesh().slotOf(mesh().incidentTet(v), v), 0);
}

TEST_F(Triangulation3dOfPoints, RebuildsIncidentTetrahedra)
{
    for (const VertexId v : liveVertices(mesh())) mesh().setIncidentTet(v, TetId(0u));
    EXPECT_FALSE(checkTopology3d(mesh()).isValid());
    mesh().rebuildIncidentTets();
    EXPECT_TRUE(isSoundTopology(mesh()));
}

TEST_F(Triangulation3dOfPoints, CountsFiniteTetrahedra)
{
    EXPECT_EQ(mesh().finiteTetCount(), finiteTets(mesh()).size());
    EXPECT_EQ(mesh().tetCount(), liveTets(mesh()).size());
    EXPECT_GE(mesh().bytes(), std::size_t{mesh().tetCount()} * 40 + std::size_t{mesh().vertexCount()} * 40);
}

}  // namespace
}  // namespace mesher::test
