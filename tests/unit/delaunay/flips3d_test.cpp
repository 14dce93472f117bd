#include "delaunay/flips3d.h"

#include "support/test_effort.h"
#include "support/triangulations3d.h"

#include <gtest/gtest.h>

namespace mesher::test {
namespace {

double minimumVolume(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d)
{
    return volumeOf(a, b, c, d);
}

double shape(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d)
{
    const double sum = squaredLength(b - a) + squaredLength(c - a) + squaredLength(d - a) +
                       squaredLength(c - b) + squaredLength(d - b) + squaredLength(d - c);
    return volumeOf(a, b, c, d) / (sum * std::sqrt(sum));
}

VertexId vertexAt(const Triangulation3d& mesh, const Vec3& place)
{
    for (const VertexId v : liveVertices(mesh)) {
        if (mesh.position(v) == place) return v;
    }
    return {};
}

struct EdgeOfTet
{
    TetId tet;
    int edge;
};

EdgeOfTet edgeBetween(const Triangulation3d& mesh, const Vec3& a, const Vec3& b)
{
    const VertexId va = vertexAt(mesh, a);
    const VertexId vb = vertexAt(mesh, b);
    const TetId tet = mesh.findEdge(va, vb);
    return {tet, tet.isValid() ? kEdgeOfSlots[mesh.slotOf(tet, va)][mesh.slotOf(tet, vb)] : -1};
}

/// Two points on an axis and `count` around it: one edge with a ring.
struct RingFixture
{
    Vec3 top{0, 0, 0.1};
    Vec3 bottom{0, 0, -0.1};
    std::vector<Vec3> ring;
    Delaunay3d delaunay;

    explicit RingFixture(int count, std::uint64_t seed = 0)
    {
        Random random(seed);
        std::vector<Vec3> points{top, bottom};
        for (int i = 0; i < count; ++i) {
            const double angle = 6.283185307179586 * i / count;
            const double bump = seed == 0 ? 0.0 : random.between(-0.02, 0.02);
            const double radius = seed == 0 ? 1.0 : random.between(0.9, 1.1);
            ring.push_back({radius * std::cos(angle), radius * std::sin(angle), bump});
            points.push_back(ring.back());
        }
        insertAll(delaunay, points);
    }
    Triangulation3d& mesh() { return delaunay.triangulation(); }
    [[nodiscard]] EdgeOfTet axis() const { return edgeBetween(delaunay.triangulation(), top, bottom); }
};

double worstOf(const Triangulation3d& mesh, const std::vector<TetCorners>& tets, const TetMeasure& measure)
{
    double worst = 1e300;
    for (const TetCorners& v : tets) {
        worst = std::min(worst, measure(mesh.position(v[0]), mesh.position(v[1]), mesh.position(v[2]),
                                        mesh.position(v[3])));
    }
    return worst;
}

// --- 2-3 and 3-2

TEST(Flips3d, FlipsAFaceToAnEdgeAndBack)
{
    RingFixture fixture(3);
    Triangulation3d& mesh = fixture.mesh();
    const std::uint64_t original = meshHash3d(mesh);
    TetReplacement3d replacement(mesh);
    const EdgeOfTet axis = fixture.axis();
    ASSERT_TRUE(axis.tet.isValid());
    const std::optional<Flip3d> toFace = evaluateFlip32(mesh, axis.tet, axis.edge);
    ASSERT_TRUE(toFace.has_value());
    EXPECT_EQ(toFace->before.size(), 3u);
    EXPECT_EQ(toFace->after.size(), 2u);
    EXPECT_EQ(meshHash3d(mesh), original) << "evaluation changes nothing";
    applyFlip(replacement, *toFace);
    EXPECT_TRUE(isSoundTopology(mesh));
    EXPECT_EQ(mesh.finiteTetCount(), 2u);
    EXPECT_FALSE(fixture.axis().tet.isValid());
    const TetFace face = mesh.findFace(vertexAt(mesh, fixture.ring[0]), vertexAt(mesh, fixture.ring[1]),
                                       vertexAt(mesh, fixture.ring[2]));
    ASSERT_TRUE(face.isValid());
    const std::optional<Flip3d> toEdge = evaluateFlip23(mesh, face);
    ASSERT_TRUE(toEdge.has_value());
    applyFlip(replacement, *toEdge);
    EXPECT_TRUE(isSoundTopology(mesh));
    EXPECT_EQ(meshHash3d(mesh), original);
}

TEST(Flips3d, FlipAllFacesOfARandomMeshThereAndBack)
{
    Delaunay3d delaunay;
    insertAll(delaunay, uniformPoints3d(60, 9));
    Triangulation3d& mesh = delaunay.triangulation();
    TetReplacement3d replacement(mesh);
    const std::uint64_t original = meshHash3d(mesh);
    int flips = 0;
    for (const TetId tet : finiteTets(mesh)) {
        for (int i = 0; i < 4; ++i) {
            if (!mesh.isAlive(tet) || mesh.isGhostTet(tet)) break;
            const TetFace face(tet, i);
            const VertexId above = mesh.vertex(tet, i);
            const TetFace other = mesh.neighbour(face);
            const VertexId below = mesh.vertex(other.tet(), other.face());
            const std::optional<Flip3d> flip = evaluateFlip23(mesh, face);
            if (!flip) continue;
            applyFlip(replacement, *flip);
            const TetId made = mesh.findEdge(above, below);
            ASSERT_TRUE(made.isValid());
            const std::optional<Flip3d> back =
                evaluateFlip32(mesh, made, kEdgeOfSlots[mesh.slotOf(made, above)][mesh.slotOf(made, below)]);
            ASSERT_TRUE(back.has_value());
            applyFlip(replacement, *back);
            ASSERT_EQ(meshHash3d(mesh), original);
            ++flips;
        }
    }
    EXPECT_GT(flips, 50);
    EXPECT_TRUE(isSoundTopology(mesh));
}

TEST(Flips3d, RefuseWhatWouldInvertOrFlatten)
{
    // The segment between the apexes misses the common face, or meets its border exactly.
    int refused = 0;
    for (const Vec3& apex : {Vec3{3, 3, -1}, Vec3{0, 0, -1}, Vec3{0.5, 0, -1}}) {
        Delaunay3d delaunay;
        insertEach(delaunay, std::vector<Vec3>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {apex.x, apex.y, 1}, apex});
        const Triangulation3d& mesh = delaunay.triangulation();
        const TetFace face =
            mesh.findFace(vertexAt(mesh, {0, 0, 0}), vertexAt(mesh, {1, 0, 0}), vertexAt(mesh, {0, 1, 0}));
        if (!face.isValid()) continue;
        EXPECT_FALSE(evaluateFlip23(mesh, face).has_value());
        ++refused;
    }
    EXPECT_EQ(refused, 3);
    RingFixture fixture(3);
    // A ring whose triangle passes below both ends of the edge.
    for (const Vec3& p : fixture.ring)
        fixture.mesh().setPosition(vertexAt(fixture.mesh(), p), p + Vec3{0, 0, -0.5});
    const EdgeOfTet axis = fixture.axis();
    EXPECT_FALSE(evaluateFlip32(fixture.mesh(), axis.tet, axis.edge).has_value());
    EXPECT_FALSE(evaluateEdgeRemoval(fixture.mesh(), axis.tet, axis.edge, shape).has_value());
}

TEST(Flips3d, RefuseHullFacesAndGhostEdges)
{
    RingFixture fixture(3);
    const Triangulation3d& mesh = fixture.mesh();
    for (const TetId tet : liveTets(mesh)) {
        for (int i = 0; i < 4; ++i) {
            if (!mesh.isGhostTet(tet) && !mesh.isGhostTet(mesh.neighbour(tet, i).tet())) continue;
            EXPECT_FALSE(evaluateFlip23(mesh, {tet, i}).has_value());
        }
        for (int edge = 0; edge < 6; ++edge) {
            if (!isGhost(mesh.vertex(tet, kEdgeSlots[edge][1]))) continue;
            EXPECT_FALSE(evaluateFlip32(mesh, tet, edge).has_value());
            EXPECT_FALSE(evaluateFlip22(mesh, tet, edge).has_value());
            EXPECT_FALSE(evaluateFlip44(mesh, tet, edge, 0).has_value());
            EXPECT_FALSE(evaluateFlip44(mesh, tet, edge, 1).has_value());
            EXPECT_FALSE(evaluateEdgeRemoval(mesh, tet, edge, shape).has_value());
        }
    }
}

// --- 4-4 and 2-2

TEST(Flips3d, ReplaceAnEdgeOfFourByEitherDiagonal)
{
    for (const int diagonal : {0, 1}) {
        RingFixture fixture(4);
        Triangulation3d& mesh = fixture.mesh();
        const EdgeOfTet axis = fixture.axis();
        ASSERT_TRUE(axis.tet.isValid());
        const std::optional<Flip3d> flip = evaluateFlip44(mesh, axis.tet, axis.edge, diagonal);
        ASSERT_TRUE(flip.has_value());
        TetReplacement3d replacement(mesh);
        applyFlip(replacement, *flip);
        EXPECT_TRUE(isSoundTopology(mesh));
        EXPECT_FALSE(fixture.axis().tet.isValid());
        EXPECT_EQ(mesh.finiteTetCount(), 4u);
        int diagonals = 0;
        for (int i = 0; i < 2; ++i) {
            diagonals +=
                edgeBetween(mesh, fixture.ring[unsigned(i)], fixture.ring[unsigned(i + 2)]).tet.isValid() ? 1
                                                                                                          : 0;
        }
        EXPECT_EQ(diagonals, 1);
    }
}

TEST(Flips3d, MoveAConstrainedPairWithinItsPlaneOnly)
{
    for (const double lift : {0.0, 0.01}) {
        Delaunay3d delaunay;
        // The edge (a, b) and the ring c, up, d, down; a, b, c, d in one plane if not lifted.
        const Vec3 a{-0.1, 0, 0}, b{0.1, 0, 0}, c{0, 1, lift}, d{0, -1, 0}, up{0, 0, 1}, down{0, 0, -1};
        insertEach(delaunay, std::vector<Vec3>{a, b, c, d, up, down});
        Triangulation3d& mesh = delaunay.triangulation();
        const VertexId va = vertexAt(mesh, a), vb = vertexAt(mesh, b), vc = vertexAt(mesh, c),
                       vd = vertexAt(mesh, d);
        ASSERT_TRUE(mesh.findEdge(va, vb).isValid());
        mesh.setFaceConstrained(mesh.findFace(va, vb, vc), true);
        mesh.setFaceConstrained(mesh.findFace(va, vb, vd), true);
        for (const TetId t : finiteTets(mesh)) {
            const bool isAbove = mesh.slotOf(t, vertexAt(mesh, up)) >= 0;
            mesh.setRegion(t, RegionId(isAbove ? 1u : 2u));
        }
        const EdgeOfTet edge = edgeBetween(mesh, a, b);
        int possible = 0;
        for (const int diagonal : {0, 1}) {
            const std::optional<Flip3d> flip = evaluateFlip44(mesh, edge.tet, edge.edge, diagonal);
            if (!flip) continue;
            ++possible;
            TetReplacement3d replacement(mesh);
            applyFlip(replacement, *flip);
            EXPECT_TRUE(isSoundTopology(mesh));
            EXPECT_FALSE(mesh.findEdge(va, vb).isValid());
            for (const VertexId end : {va, vb}) {
                const TetFace moved = mesh.findFace(vc, vd, end);
                ASSERT_TRUE(moved.isValid());
                EXPECT_TRUE(mesh.isFaceConstrained(moved));
            }
            int constrained = 0;
            for (const TetId t : liveTets(mesh)) {
                for (int i = 0; i < 4; ++i) constrained += mesh.isFaceConstrained({t, i}) ? 1 : 0;
                if (mesh.isGhostTet(t)) continue;
                EXPECT_EQ(mesh.region(t).value, mesh.slotOf(t, vertexAt(mesh, up)) >= 0 ? 1u : 2u);
            }
            EXPECT_EQ(constrained, 4);
            break;
        }
        EXPECT_EQ(possible, lift == 0.0 ? 1 : 0);
    }
}

TEST(Flips3d, FlipTheDiagonalOfAHullQuadrilateral)
{
    Delaunay3d delaunay;
    // A pyramid: its base has two triangles in one plane.
    insertEach(delaunay, std::vector<Vec3>{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0.5, 0.5, 1}});
    Triangulation3d& mesh = delaunay.triangulation();
    const std::uint64_t original = meshHash3d(mesh);
    TetReplacement3d replacement(mesh);
    const Vec3 diagonals[2][2] = {{{0, 0, 0}, {1, 1, 0}}, {{1, 0, 0}, {0, 1, 0}}};
    const int first = edgeBetween(mesh, diagonals[0][0], diagonals[0][1]).tet.isValid() ? 0 : 1;
    for (const bool isConstrained : {false, true}) {
        const EdgeOfTet edge = edgeBetween(mesh, diagonals[first][0], diagonals[first][1]);
        ASSERT_TRUE(edge.tet.isValid());
        if (isConstrained) {
            const VertexId va = vertexAt(mesh, diagonals[first][0]), vb = vertexAt(mesh, diagonals[first][1]);
            mesh.setFaceConstrained(mesh.findFace(va, vb, vertexAt(mesh, diagonals[1 - first][0])), true);
            EXPECT_FALSE(evaluateFlip22(mesh, edge.tet, edge.edge).has_value())
                << "one face alone cannot move";
            mesh.setFaceConstrained(mesh.findFace(va, vb, vertexAt(mesh, diagonals[1 - first][1])), true);
        }
        const std::optional<Flip3d> flip = evaluateFlip22(mesh, edge.tet, edge.edge);
        ASSERT_TRUE(flip.has_value());
        applyFlip(replacement, *flip);
        EXPECT_TRUE(isSoundTopology(mesh));
        EXPECT_TRUE(edgeBetween(mesh, diagonals[1 - first][0], diagonals[1 - first][1]).tet.isValid());
        const EdgeOfTet back = edgeBetween(mesh, diagonals[1 - first][0], diagonals[1 - first][1]);
        const std::optional<Flip3d> again = evaluateFlip22(mesh, back.tet, back.edge);
        ASSERT_TRUE(again.has_value());
        if (isConstrained) break;
        applyFlip(replacement, *again);
        EXPECT_EQ(meshHash3d(mesh), original);
    }
}

TEST(Flips3d, RefuseTheHullEdgeBetweenFacesOfDifferentPlanes)
{
    Delaunay3d delaunay;
    insertEach(delaunay, std::vector<Vec3>{{0, 0, 0}, {1, 0, 0}, {1, 1, 0.1}, {0, 1, 0}, {0.5, 0.5, 1}});
    const Triangulation3d& mesh = delaunay.triangulation();
    for (const TetId tet : finiteTets(mesh)) {
        for (int edge = 0; edge < 6; ++edge) EXPECT_FALSE(evaluateFlip22(mesh, tet, edge).has_value());
    }
}

// --- edge removal

/// All triangulations of the polygon i … j as lists of triangles.
std::vector<std::vector<std::array<std::size_t, 3>>> triangulations(std::size_t i, std::size_t j)
{
    if (j <= i + 1) return {{}};
    std::vector<std::vector<std::array<std::size_t, 3>>> all;
    for (std::size_t k = i + 1; k < j; ++k) {
        for (const auto& left : triangulations(i, k)) {
            for (const auto& right : triangulations(k, j)) {
                auto one = left;
                one.insert(one.end(), right.begin(), right.end());
                one.push_back({i, k, j});
                all.push_back(one);
            }
        }
    }
    return all;
}

TEST(Flips3d, RemoveAnEdgeByTheBestOfAllTriangulationsOfItsRing)
{
    int removals = 0;
    for (int count = 3; count <= 7; ++count) {
        for (std::uint64_t seed = 0; seed < 20; ++seed) {
            RingFixture fixture(count, seed);
            Triangulation3d& mesh = fixture.mesh();
            const EdgeOfTet axis = fixture.axis();
            if (!axis.tet.isValid()) continue;
            std::vector<TetId> tets;
            mesh.collectEdgeRing(axis.tet, vertexAt(mesh, fixture.top), vertexAt(mesh, fixture.bottom), tets);
            if (tets.size() != static_cast<std::size_t>(count)) continue;
            for (const TetMeasure& measure : {TetMeasure(shape), TetMeasure(minimumVolume)}) {
                double best = -1e300;
                for (const auto& triangles : triangulations(0, fixture.ring.size() - 1)) {
                    double worst = 1e300;
                    for (const auto& t : triangles) {
                        const Vec3 &a = fixture.ring[t[0]], &b = fixture.ring[t[1]], &c = fixture.ring[t[2]];
                        worst = std::min(
                            {worst, measure(a, b, c, fixture.top), measure(b, a, c, fixture.bottom)});
                    }
                    best = std::max(best, worst);
                }
                const std::optional<Flip3d> flip = evaluateEdgeRemoval(mesh, axis.tet, axis.edge, measure);
                ASSERT_EQ(flip.has_value(), best > 0.0);
                if (!flip) continue;
                EXPECT_NEAR(flip->quality, best, 1e-12);
                EXPECT_NEAR(worstOf(mesh, flip->after, measure), best, 1e-12);
            }
            const std::optional<Flip3d> flip = evaluateEdgeRemoval(mesh, axis.tet, axis.edge, shape);
            if (!flip) continue;
            TetReplacement3d replacement(mesh);
            applyFlip(replacement, *flip);
            EXPECT_EQ(replacement.created().size(), static_cast<std::size_t>(2 * count - 4));
            EXPECT_TRUE(isSoundTopology(mesh));
            EXPECT_FALSE(fixture.axis().tet.isValid());
            ++removals;
        }
    }
    EXPECT_GT(removals, 50);
}

TEST(Flips3d, RemoveRingsUpToTheLimitOnly)
{
    for (int count = 3; count <= kMaxEdgeRing + 2; ++count) {
        SCOPED_TRACE(count);
        RingFixture fixture(count);
        const EdgeOfTet axis = fixture.axis();
        ASSERT_TRUE(axis.tet.isValid());
        const std::optional<Flip3d> flip = evaluateEdgeRemoval(fixture.mesh(), axis.tet, axis.edge, shape);
        EXPECT_EQ(flip.has_value(), count <= kMaxEdgeRing);
        if (!flip) continue;
        TetReplacement3d replacement(fixture.mesh());
        applyFlip(replacement, *flip);
        EXPECT_TRUE(isSoundTopology(fixture.mesh()));
        EXPECT_EQ(fixture.mesh().finiteTetCount(), static_cast<std::uint32_t>(2 * count - 4));
    }
}

TEST(Flips3d, RefuseToLoseConstraints)
{
    for (const bool isEdge : {false, true}) {
        for (const int count : {3, 4, 6}) {
            RingFixture fixture(count);
            Triangulation3d& mesh = fixture.mesh();
            const EdgeOfTet axis = fixture.axis();
            const VertexId top = vertexAt(mesh, fixture.top), bottom = vertexAt(mesh, fixture.bottom);
            ASSERT_TRUE(evaluateEdgeRemoval(mesh, axis.tet, axis.edge, shape).has_value());
            if (isEdge) {
                mesh.setEdgeConstrained(axis.tet, top, bottom, true);
            } else {
                mesh.setFaceConstrained(mesh.findFace(top, bottom, vertexAt(mesh, fixture.ring[1])), true);
            }
            EXPECT_FALSE(evaluateEdgeRemoval(mesh, axis.tet, axis.edge, shape).has_value());
            EXPECT_FALSE(evaluateFlip32(mesh, axis.tet, axis.edge).has_value());
            EXPECT_FALSE(evaluateFlip44(mesh, axis.tet, axis.edge, 0).has_value());
            EXPECT_FALSE(evaluateFlip44(mesh, axis.tet, axis.edge, 1).has_value());
        }
    }
    RingFixture fixture(3);
    Triangulation3d& mesh = fixture.mesh();
    TetReplacement3d replacement(mesh);
    const EdgeOfTet axis = fixture.axis();
    applyFlip(replacement, *evaluateFlip32(mesh, axis.tet, axis.edge));
    const TetFace face = mesh.findFace(vertexAt(mesh, fixture.ring[0]), vertexAt(mesh, fixture.ring[1]),
                                       vertexAt(mesh, fixture.ring[2]));
    mesh.setFaceConstrained(face, true);
    EXPECT_FALSE(evaluateFlip23(mesh, face).has_value());
}

TEST(Flips3d, KeepConstraintsAndRegionsAroundThem)
{
    RingFixture fixture(5);
    Triangulation3d& mesh = fixture.mesh();
    const VertexId top = vertexAt(mesh, fixture.top);
    const VertexId v0 = vertexAt(mesh, fixture.ring[0]);
    const VertexId v1 = vertexAt(mesh, fixture.ring[1]);
    mesh.setEdgeConstrained(mesh.findEdge(top, v0), top, v0, true);
    mesh.setEdgeConstrained(mesh.findEdge(v1, v0), v1, v0, true);
    mesh.setFaceConstrained(mesh.findFace(top, v0, v1), true);
    for (const TetId t : finiteTets(mesh)) mesh.setRegion(t, RegionId(7u));
    const EdgeOfTet axis = fixture.axis();
    TetReplacement3d replacement(mesh);
    applyFlip(replacement, *evaluateEdgeRemoval(mesh, axis.tet, axis.edge, shape));
    EXPECT_TRUE(isSoundTopology(mesh));
    EXPECT_TRUE(mesh.isFaceConstrained(mesh.findFace(top, v0, v1)));
    for (const auto& [a, b] : {std::pair{top, v0}, std::pair{v1, v0}}) {
        const TetId t = mesh.findEdge(a, b);
        EXPECT_TRUE(mesh.isEdgeConstrained(t, kEdgeOfSlots[mesh.slotOf(t, a)][mesh.slotOf(t, b)]));
    }
    for (const TetId t : finiteTets(mesh)) EXPECT_EQ(mesh.region(t), RegionId(7u));
}

}  // namespace
}  // namespace mesher::test
