#include "delaunay/delaunay3d.h"

#include "delaunay/flips3d.h"
#include "support/test_effort.h"
#include "support/triangulations3d.h"

#include <gtest/gtest.h>

#include <limits>

namespace mesher::test {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
const Vec3 kCorners[4] = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};

// --- below dimension 3

TEST(Delaunay3d, CountsTheDimensionAsPointsCome)
{
    Delaunay3d delaunay;
    EXPECT_EQ(delaunay.dimension(), -1);
    for (int i = 0; i < 4; ++i) {
        const Result<Insertion3d> result = delaunay.insert(kCorners[i]);
        ASSERT_TRUE(result.hasValue());
        EXPECT_EQ(result->status, InsertionStatus::Inserted);
        EXPECT_EQ(result->tet.isValid(), i == 3);
        EXPECT_EQ(delaunay.dimension(), i);
        EXPECT_EQ(delaunay.triangulation().finiteTetCount(), i == 3 ? 1u : 0u);
        EXPECT_TRUE(isSoundTopology(delaunay.triangulation()));
    }
    EXPECT_EQ(delaunay.triangulation().tetCount(), 5u);
}

TEST(Delaunay3d, KeepsFlatSetsWithoutTetrahedra)
{
    const std::pair<std::vector<Vec3>, int> cases[] = {{equalPoints3d(70), 0},
                                                       {collinearPoints3d(70, 3), 1},
                                                       {coplanarPoints3d(70, 3), 2},
                                                       {coplanarGridPoints3d(70), 2},
                                                       {{}, -1}};
    for (const auto& [points, dimension] : cases) {
        Delaunay3d bulk;
        const BulkInsertion3d result = insertAll(bulk, points);
        Delaunay3d single;
        insertEach(single, points);
        for (const Delaunay3d* delaunay : {&bulk, &single}) {
            EXPECT_EQ(delaunay->dimension(), dimension);
            EXPECT_EQ(delaunay->triangulation().tetCount(), 0u);
            EXPECT_EQ(delaunay->triangulation().vertexCount() + result.duplicates, points.size());
        }
        if (!points.empty()) {
            EXPECT_EQ(single.locate(points[0]).error().code, ErrorCode::DegenerateInput);
        }
    }
}

TEST(Delaunay3d, LeavesAndEntersSpaceWithTheOnePointOffThePlane)
{
    for (const auto& flat : {coplanarGridPoints3d(60), coplanarPoints3d(60, 5), collinearPoints3d(20, 5)}) {
        Delaunay3d delaunay;
        insertEach(delaunay, flat);
        const int flatDimension = delaunay.dimension();
        const Vec3 off[2] = {{0.5, 0.25, 7.0}, {0.25, 9.0, -3.0}};
        for (int round = 0; round < 3; ++round) {
            SCOPED_TRACE(round);
            VertexId apex[2];
            for (int i = 0; i < 2; ++i) {
                const Result<Insertion3d> result = delaunay.insert(off[i]);
                ASSERT_EQ(result->status, InsertionStatus::Inserted);
                apex[i] = result->vertex;
            }
            ASSERT_EQ(delaunay.dimension(), 3);
            EXPECT_TRUE(isSoundTopology(delaunay.triangulation()));
            EXPECT_TRUE(isDelaunay(delaunay.triangulation(), DelaunayScope::Global));
            std::vector<Vec3> all = flat;
            all.insert(all.end(), {off[0], off[1]});
            EXPECT_EQ(meshHash3d(delaunay.triangulation()), hashOf(all));
            EXPECT_EQ(delaunay.remove(apex[round % 2]), RemovalStatus::Removed);
            EXPECT_EQ(delaunay.remove(apex[1 - round % 2]), RemovalStatus::Removed);
            EXPECT_EQ(delaunay.dimension(), flatDimension);
            EXPECT_EQ(delaunay.triangulation().tetCount(), 0u);
            EXPECT_EQ(delaunay.triangulation().vertexCount(), flat.size());
        }
    }
}

TEST(Delaunay3d, RemovesAllPointsAndStartsAgain)
{
    Delaunay3d delaunay;
    const std::vector<Vec3> points = gridPoints3d(60);
    for (int round = 0; round < 2; ++round) {
        insertEach(delaunay, points);
        EXPECT_EQ(meshHash3d(delaunay.triangulation()), hashOf(points));
        for (const VertexId v : liveVertices(delaunay.triangulation())) {
            ASSERT_EQ(delaunay.remove(v), RemovalStatus::Removed);
        }
        EXPECT_EQ(delaunay.dimension(), -1);
        EXPECT_EQ(delaunay.triangulation().vertexCount(), 0u);
    }
}

// --- input

TEST(Delaunay3d, NamesThePointThatCannotBeUsedAndInsertsNothing)
{
    const std::pair<Vec3, ErrorCode> cases[] = {
        {{0, std::nan(""), 0}, ErrorCode::NonFinitePoint}, {{kInfinity, 0, 0}, ErrorCode::NonFinitePoint},
        {{0, 0, -kInfinity}, ErrorCode::NonFinitePoint},   {{0, 0x1p201, 0}, ErrorCode::OutOfRange},
        {{0, 0, 0x1p-201}, ErrorCode::OutOfRange},         {{5e-324, 0, 0}, ErrorCode::OutOfRange}};
    for (const auto& [bad, code] : cases) {
        std::vector<Vec3> points = uniformPoints3d(50, 1);
        Delaunay3d delaunay;
        insertAll(delaunay, points);
        const std::uint64_t before = stateHash(delaunay.triangulation());
        points[17] = bad;
        RunContext context;
        const Result<BulkInsertion3d> bulk = delaunay.insertPoints(points, {}, context);
        ASSERT_FALSE(bulk.hasValue());
        EXPECT_EQ(bulk.error().code, code);
        EXPECT_EQ(bulk.error().entity, "point 17");
        EXPECT_FALSE(bulk.error().remedy.empty());
        const Result<Insertion3d> single = delaunay.insert(bad);
        ASSERT_FALSE(single.hasValue());
        EXPECT_EQ(single.error().code, code);
        const Result<Location3d> located = delaunay.locate(bad);
        ASSERT_FALSE(located.hasValue());
        EXPECT_EQ(located.error().code, code);
        EXPECT_EQ(stateHash(delaunay.triangulation()), before);
    }
}

TEST(Delaunay3d, RefusesBulkInsertionBesideConstraints)
{
    Delaunay3d delaunay;
    insertAll(delaunay, uniformPoints3d(20, 1));
    delaunay.triangulation().setFaceConstrained({finiteTets(delaunay.triangulation()).front(), 0}, true);
    RunContext context;
    const Result<BulkInsertion3d> result = delaunay.insertPoints(uniformPoints3d(20, 2), {}, context);
    ASSERT_FALSE(result.hasValue());
    EXPECT_EQ(result.error().code, ErrorCode::InvalidArgument);
}

TEST(Delaunay3d, GivesDuplicatesTheVertexOfTheFirst)
{
    const std::vector<Vec3> points = duplicatedPoints3d(400, 9);
    Delaunay3d delaunay;
    const BulkInsertion3d result = insertAll(delaunay, points);
    ASSERT_EQ(result.vertex.size(), points.size());
    EXPECT_EQ(result.duplicates, points.size() - delaunay.triangulation().vertexCount());
    for (std::size_t i = 0; i < points.size(); ++i) {
        ASSERT_TRUE(result.vertex[i].isValid());
        EXPECT_TRUE(delaunay.triangulation().position(result.vertex[i]) == points[i]);
        const Result<Insertion3d> again = delaunay.insert(points[i]);
        EXPECT_EQ(again->status, InsertionStatus::Duplicate);
        EXPECT_EQ(again->vertex, result.vertex[i]);
    }
}

TEST(Delaunay3d, TakesNegativeZeroForZero)
{
    std::vector<Vec3> points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 1, 0}, {0.5, 0.0, 2.0}};
    const std::uint64_t expected = hashOf(points);
    for (Vec3& p : points) {
        for (double* x : {&p.x, &p.y, &p.z}) {
            if (*x == 0.0) *x = -0.0;
        }
    }
    EXPECT_EQ(hashOf(points), expected);
    Delaunay3d single;
    insertEach(single, points);
    EXPECT_EQ(meshHash3d(single.triangulation()), expected);
    EXPECT_EQ(single.insert({-0.0, -0.0, 0.0})->status, InsertionStatus::Duplicate);
}

// --- uniqueness

class PointFamilies3d : public testing::TestWithParam<std::size_t>
{
protected:
    [[nodiscard]] static std::vector<Vec3> make(std::size_t count, std::uint64_t seed)
    {
        return pointFamilies3d()[GetParam()].make(count, seed);
    }
};

TEST_P(PointFamilies3d, AreGloballyDelaunayAndTheSameInEveryOrder)
{
    for (std::uint64_t seed = 1; seed <= 3; ++seed) {
        std::vector<Vec3> points = make(120, seed);
        Delaunay3d bulk;
        insertAll(bulk, points);
        EXPECT_TRUE(isSoundTopology(bulk.triangulation()));
        EXPECT_TRUE(isDelaunay(bulk.triangulation(), DelaunayScope::Global));
        Random random(seed);
        for (int order = 0; order < 3; ++order) {
            shuffle(points, random);
            Delaunay3d single(random());
            insertEach(single, points);
            EXPECT_EQ(meshHash3d(single.triangulation()), meshHash3d(bulk.triangulation()));
            Delaunay3d permuted(random());
            insertAll(permuted, points);
            EXPECT_EQ(meshHash3d(permuted.triangulation()), meshHash3d(bulk.triangulation()));
            EXPECT_TRUE(isSoundTopology(single.triangulation()));
        }
    }
}

TEST_P(PointFamilies3d, AreLocallyDelaunayWhenLarge)
{
    const std::vector<Vec3> points = make(static_cast<std::size_t>(repetitions(8000)), 4);
    Delaunay3d delaunay;
    insertAll(delaunay, points);
    EXPECT_TRUE(isSoundTopology(delaunay.triangulation()));
    EXPECT_TRUE(isDelaunay(delaunay.triangulation(), DelaunayScope::Local));
}

TEST_P(PointFamilies3d, AreInsertedBelowAndAboveInTwoHalves)
{
    const std::vector<Vec3> points = make(300, 8);
    const std::span<const Vec3> all(points);
    Delaunay3d delaunay;
    insertAll(delaunay, all.first(100));
    insertAll(delaunay, all.subspan(100));
    EXPECT_EQ(meshHash3d(delaunay.triangulation()), hashOf(points));
}

INSTANTIATE_TEST_SUITE_P(Families, PointFamilies3d, testing::Range<std::size_t>(0, pointFamilies3d().size()),
                         [](const auto& parameter) { return pointFamilies3d()[parameter.param].name; });

TEST(Delaunay3d, IsTheSameAfterScalingByPowersOfTwo)
{
    for (const auto& points : {uniformPoints3d(200, 6), gridPoints3d(125), cosphericalPoints3d(150, 6)}) {
        Delaunay3d original;
        insertAll(original, points);
        for (const double scale : {0x1p180, 0x1p-120}) {
            std::vector<Vec3> scaled = points;
            for (Vec3& p : scaled) p = scale * p;
            Delaunay3d delaunay;
            insertAll(delaunay, scaled);
            Triangulation3d& mesh = delaunay.triangulation();
            EXPECT_TRUE(isDelaunay(mesh, DelaunayScope::Global));
            for (const VertexId v : liveVertices(mesh)) mesh.setPosition(v, (1.0 / scale) * mesh.position(v));
            EXPECT_EQ(meshHash3d(mesh), meshHash3d(original.triangulation()));
        }
    }
}

/// The same constants in every build type and on every machine: what filters, exact arithmetic and hashes do may not
/// depend on either. They change with the perturbation, the generators or the hash only.
TEST(Delaunay3d, HasThePinnedHashes)
{
    EXPECT_EQ(hashOf(uniformPoints3d(1000, 1)), 10984471323091739819u);
    EXPECT_EQ(hashOf(gridPoints3d(1000)), 9998554231865055771u);
    EXPECT_EQ(hashOf(cosphericalPoints3d(1000, 1)), 109671549316657591u);
    EXPECT_EQ(hashOf(ulpPoints3d(1000, 1)), 10253062962072327646u);
    EXPECT_EQ(hashOf(clusteredPoints3d(1000, 1)), 13742198516278932301u);
    EXPECT_EQ(hashOf(farOffsetGridPoints3d(1000)), 507520039523852685u);
}

TEST(Delaunay3d, NumbersEverythingAlikeInTwoRuns)
{
    const std::vector<Vec3> points = clusteredPoints3d(2000, 2);
    Delaunay3d first;
    Delaunay3d second;
    EXPECT_EQ(insertAll(first, points).vertex, insertAll(second, points).vertex);
    ASSERT_EQ(first.triangulation().tetLimit(), second.triangulation().tetLimit());
    for (std::uint32_t i = 0; i < first.triangulation().tetLimit(); ++i) {
        ASSERT_EQ(first.triangulation().tet(TetId(i)).vertex, second.triangulation().tet(TetId(i)).vertex);
        ASSERT_EQ(first.triangulation().tet(TetId(i)).neighbour,
                  second.triangulation().tet(TetId(i)).neighbour);
    }
}

// --- location

TEST(Delaunay3d, TellsHowAPointLiesInATetrahedron)
{
    Delaunay3d delaunay;
    insertEach(delaunay, kCorners);
    const Triangulation3d& mesh = delaunay.triangulation();
    const auto at = [&](Vec3 p) { return *delaunay.locate(p); };
    EXPECT_EQ(at({0.25, 0.25, 0.25}).kind, Location3d::Kind::Tet);
    EXPECT_EQ(at({0.5, 0.5, 0.5}).kind, Location3d::Kind::Outside);
    EXPECT_TRUE(mesh.isGhostTet(at({0.5, 0.5, 0.5}).tet));
    EXPECT_EQ(at({2, 0, 0}).kind, Location3d::Kind::Outside);     // on the line of an edge
    EXPECT_EQ(at({-1, 0.5, 0}).kind, Location3d::Kind::Outside);  // in the plane of a face
    for (int i = 0; i < 4; ++i) {
        const Location3d location = at(kCorners[i]);
        ASSERT_EQ(location.kind, Location3d::Kind::Vertex);
        EXPECT_TRUE(mesh.position(mesh.vertex(location.tet, location.index)) == kCorners[i]);
    }
    const Location3d onFace = at({0.25, 0.25, 0});
    ASSERT_EQ(onFace.kind, Location3d::Kind::Face);
    for (const VertexId v : mesh.faceVertices({onFace.tet, onFace.index})) EXPECT_EQ(mesh.position(v).z, 0.0);
    for (const auto& [p, a, b] : {std::tuple{Vec3{0.5, 0, 0}, kCorners[0], kCorners[1]},
                                  std::tuple{Vec3{0.5, 0.5, 0}, kCorners[1], kCorners[2]},
                                  std::tuple{Vec3{0, 0.25, 0.75}, kCorners[2], kCorners[3]}}) {
        const Location3d onEdge = at(p);
        ASSERT_EQ(onEdge.kind, Location3d::Kind::Edge);
        const Vec3 from = mesh.position(mesh.vertex(onEdge.tet, kEdgeSlots[onEdge.index][0]));
        const Vec3 to = mesh.position(mesh.vertex(onEdge.tet, kEdgeSlots[onEdge.index][1]));
        EXPECT_TRUE((from == a && to == b) || (from == b && to == a));
    }
}

TEST(Delaunay3d, FindsTheSameKindOfPlaceFromEveryHint)
{
    Delaunay3d delaunay;
    insertAll(delaunay, gridPoints3d(64));
    const std::vector<TetId> tets = liveTets(delaunay.triangulation());
    for (const Vec3& p : {Vec3{1, 1, 1}, Vec3{1.5, 1.5, 1.5}, Vec3{1.5, 1, 1}, Vec3{-1, 0, 0},
                          Vec3{3, 3, 3.5}, Vec3{0.25, 0.5, 0.125}}) {
        const Location3d expected = *delaunay.locate(p);
        for (const TetId hint : tets) EXPECT_EQ(delaunay.locate(p, hint)->kind, expected.kind);
        EXPECT_EQ(delaunay.locate(p, TetId(1u << 29))->kind, expected.kind)
            << "a hint out of range is ignored";
    }
}

TEST(Delaunay3d, InsertsWhereverTheHintIs)
{
    const std::vector<Vec3> points = uniformPoints3d(60, 3);
    const std::uint64_t expected = hashOf(points);
    Random random(5);
    Delaunay3d delaunay;
    insertEach(delaunay, std::span(points).first(10));
    for (std::size_t i = 10; i < points.size(); ++i) {
        const TetId hint(random.below(delaunay.triangulation().tetLimit() + 5));
        ASSERT_EQ(delaunay.insert(points[i], hint)->status, InsertionStatus::Inserted);
    }
    EXPECT_EQ(meshHash3d(delaunay.triangulation()), expected);
}

TEST(Delaunay3d, FindsAStartAfterAFlipFreedTheLastTetrahedron)
{
    Delaunay3d delaunay;
    insertAll(delaunay, uniformPoints3d(60, 3));
    Triangulation3d& mesh = delaunay.triangulation();
    TetReplacement3d replacement(mesh);
    Random random(8);
    int freed = 0;
    for (int i = 0; i < 40; ++i) {
        const TetId recent = delaunay.insert({random.unit(), random.unit(), random.unit()})->tet;
        for (const TetId tet : finiteTets(mesh)) {
            for (int edge = 0; edge < 6 && mesh.isAlive(recent) && mesh.isAlive(tet); ++edge) {
                const std::optional<Flip3d> flip = evaluateFlip32(mesh, tet, edge);
                if (flip && flip->before.back() == recent) applyFlip(replacement, *flip);
            }
        }
        if (mesh.isAlive(recent)) continue;
        ++freed;
        EXPECT_EQ(delaunay.locate({-3, -3, -3})->kind, Location3d::Kind::Outside);
        EXPECT_EQ(delaunay.locate(mesh.position(VertexId(7)))->kind, Location3d::Kind::Vertex);
    }
    EXPECT_GT(freed, 3);
}

// --- running

TEST(Delaunay3d, StopsWhenCancelledAndLeavesAValidTriangulation)
{
    const std::vector<Vec3> points = uniformPoints3d(3000, 1);
    for (const double limit : {0.0, 0.3, 0.9}) {
        RunSettings settings;
        settings.progress = [&](std::string_view, double fraction) { return fraction < limit; };
        RunContext context(settings);
        Delaunay3d delaunay;
        const Result<BulkInsertion3d> result = delaunay.insertPoints(points, {}, context);
        ASSERT_TRUE(result.hasValue());
        EXPECT_EQ(result->stopReason, StopReason::Cancelled);
        std::vector<Vec3> reached;
        for (std::size_t i = 0; i < points.size(); ++i) {
            if (result->vertex[i].isValid()) reached.push_back(points[i]);
        }
        EXPECT_EQ(reached.size(), delaunay.triangulation().vertexCount());
        EXPECT_LT(reached.size(), points.size());
        EXPECT_TRUE(isSoundTopology(delaunay.triangulation()));
        EXPECT_EQ(meshHash3d(delaunay.triangulation()), hashOf(reached));
        RunContext freshContext;
        ASSERT_TRUE(delaunay.insertPoints(points, {}, freshContext).hasValue());
        EXPECT_EQ(meshHash3d(delaunay.triangulation()), hashOf(points)) << "goes on where it stopped";
    }
}

TEST(Delaunay3d, ClassifiesWhatItInserts)
{
    BulkInsertionOptions3d options;
    options.classification = {2, 0, 77};
    options.scaffold = ScaffoldPolicy::Always;
    const std::vector<Vec3> points = torusPoints3d(2000, 1);
    Delaunay3d delaunay;
    const BulkInsertion3d result = insertAll(delaunay, points, options);
    EXPECT_GT(result.scaffoldPoints, 0u);
    const Triangulation3d& mesh = delaunay.triangulation();
    EXPECT_EQ(mesh.vertexCount(), points.size() + result.scaffoldPoints - result.duplicates);
    std::uint32_t scaffold = 0;
    for (const VertexId v : liveVertices(mesh)) scaffold += mesh.classification(v).scaffold;
    EXPECT_EQ(scaffold, result.scaffoldPoints);
    for (const VertexId v : result.vertex) EXPECT_EQ(mesh.classification(v), options.classification);
    std::vector<Vec3> own;
    for (const VertexId v : liveVertices(mesh)) {
        if (mesh.classification(v).scaffold == 0) continue;
        own.push_back(mesh.position(v));
    }
    insertAll(delaunay, own, {options.classification, ScaffoldPolicy::None});
    for (const VertexId v : liveVertices(mesh)) EXPECT_EQ(mesh.classification(v).scaffold, 0u);
}

TEST(Delaunay3d, TakesNoScaffoldForAVolume)
{
    BulkInsertionOptions3d options;
    options.scaffold = ScaffoldPolicy::Automatic;
    Delaunay3d delaunay;
    EXPECT_EQ(insertAll(delaunay, uniformPoints3d(5000, 1), options).scaffoldPoints, 0u);
    delaunay.clear();
    EXPECT_GT(insertAll(delaunay, torusPoints3d(5000, 1), options).scaffoldPoints, 0u);
}

TEST(Delaunay3d, ClearsCompactsAndGoesOn)
{
    const std::vector<Vec3> points = uniformPoints3d(300, 2);
    Delaunay3d delaunay;
    const BulkInsertion3d result = insertAll(delaunay, points);
    for (std::size_t i = 0; i < 100; ++i)
        ASSERT_EQ(delaunay.remove(result.vertex[i]), RemovalStatus::Removed);
    const std::uint64_t before = meshHash3d(delaunay.triangulation());
    const Renumbering3d map = delaunay.compact();
    EXPECT_EQ(delaunay.triangulation().vertexLimit(), 200u);
    EXPECT_EQ(delaunay.triangulation().tetLimit(), delaunay.triangulation().tetCount());
    EXPECT_EQ(meshHash3d(delaunay.triangulation()), before);
    EXPECT_TRUE(isSoundTopology(delaunay.triangulation()));
    for (std::size_t i = 0; i < points.size(); ++i) {
        const VertexId v = map.vertex[result.vertex[i]];
        ASSERT_EQ(v.isValid(), i >= 100);
        if (!v.isValid()) continue;
        EXPECT_TRUE(delaunay.triangulation().position(v) == points[i]);
    }
    insertEach(delaunay, std::span(points).first(100));
    EXPECT_EQ(meshHash3d(delaunay.triangulation()), hashOf(points));
    delaunay.clear();
    EXPECT_EQ(delaunay.dimension(), -1);
    insertEach(delaunay, points);
    EXPECT_EQ(meshHash3d(delaunay.triangulation()), hashOf(points));
    EXPECT_GT(delaunay.bytes(), delaunay.triangulation().bytes());
}

TEST(Delaunay3d, CompactsBelowDimensionThree)
{
    Delaunay3d delaunay;
    std::vector<VertexId> vertices;
    const std::vector<Vec3> flat = coplanarGridPoints3d(30);
    for (const Vec3& p : flat) vertices.push_back(delaunay.insert(p)->vertex);
    for (std::size_t i = 0; i < 10; ++i) delaunay.remove(vertices[i]);
    delaunay.compact();
    std::vector<Vec3> rest(flat.begin() + 10, flat.end());
    for (const Vec3& p : rest) EXPECT_EQ(delaunay.insert(p)->status, InsertionStatus::Duplicate);
    rest.push_back({0.5, 0.5, 5.0});
    EXPECT_EQ(delaunay.insert(rest.back())->status, InsertionStatus::Inserted);
    EXPECT_EQ(meshHash3d(delaunay.triangulation()), hashOf(rest));
}

TEST(Delaunay3d, CutsASearchForConflictsAtTheMostThatIsWanted)
{
    // On a sphere nearly all tetrahedra are in conflict with its centre.
    Delaunay3d delaunay;
    Random random(5);
    while (delaunay.triangulation().vertexCount() < 200) {
        const Vec3 p{random.between(-1, 1), random.between(-1, 1), random.between(-1, 1)};
        if (length(p) < 0.1) continue;
        ASSERT_TRUE(delaunay.insert((1.0 / length(p)) * p).hasValue());
    }
    const Vec3 centre{0.001, 0.002, 0.003};
    const TetId at = delaunay.locate(centre)->tet;
    const std::size_t all = delaunay.findConflicts(centre, at).tets.size();
    EXPECT_FALSE(delaunay.findConflicts(centre, at).isCut);
    ASSERT_GT(all, 100u);
    const std::uint64_t work = delaunay.cavityWork();
    const Cavity3d& cut = delaunay.findConflicts(centre, at, 40);
    EXPECT_TRUE(cut.isCut);
    EXPECT_EQ(cut.tets.size(), 40u);
    EXPECT_EQ(delaunay.cavityWork(), work + 40);
    EXPECT_FALSE(delaunay.findConflicts(centre, at, all).isCut);
    EXPECT_TRUE(isSoundTopology(delaunay.triangulation()));
    EXPECT_EQ(delaunay.insert(centre)->status, InsertionStatus::Inserted);
}

TEST(Delaunay3d, CountsRepairs)
{
    Delaunay3d delaunay;
    insertAll(delaunay, gridPoints3d(27));
    Triangulation3d& mesh = delaunay.triangulation();
    EXPECT_EQ(delaunay.counters().cavityRepairs, 0u);
    for (const TetId tet : finiteTets(mesh)) mesh.setFaceConstrained({tet, 0}, true);
    Random random(3);
    for (int i = 0; i < 20; ++i) {
        const Vec3 point{random.between(0, 2), random.between(0, 2), random.between(0, 2)};
        ASSERT_EQ(delaunay.insert(point)->status, InsertionStatus::Inserted);
    }
    EXPECT_GT(delaunay.counters().cavityRepairs, 0u);
    EXPECT_TRUE(isSoundTopology(mesh));
}

}  // namespace
}  // namespace mesher::test
