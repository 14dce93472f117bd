#include "delaunay/replay_log.h"

#include "base/reduce_sequence.h"
#include "delaunay/replay2d.h"
#include "support/degenerate_points.h"
#include "unit/delaunay/delaunay2d_test_support.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <numeric>

namespace mesher::test {
namespace {

TEST(ReplayLog, WritesOneReadableLinePerOperation)
{
    ReplayLog log;
    log.add(ReplayOperation::insert(7, Vec2{1.0, -0.375}));
    log.add(ReplayOperation::insert(8, Vec3{0.0, 2.0, 1024.0}));
    log.add(ReplayOperation::on(ReplayKind::Constrain, {7, 8}));
    log.add(ReplayOperation::on(ReplayKind::RemoveFromChain, {7}));
    EXPECT_EQ(log.toText(), "insert 7 1p+0 -1.8p-2\n"
                            "insert 8 0p+0 1p+1 1p+10\n"
                            "constrain 7 8\n"
                            "remove_from_chain 7\n");
}

TEST(ReplayLog, SurvivesWritingAndReadingBitForBit)
{
    ReplayLog log;
    std::uint32_t label = 0;
    for (const PointFamily<Vec2>& family : pointFamilies2d()) {
        for (const Vec2 p : family.make(50, 1)) log.add(ReplayOperation::insert(label++, p));
    }
    log.add(ReplayOperation::insert(1, Vec3{-0.0, std::numeric_limits<double>::denorm_min(), 0.1}));
    log.add(ReplayOperation::on(ReplayKind::Unconstrain, {1, 2, 3}));
    const auto read = ReplayLog::fromText(log.toText());
    ASSERT_TRUE(read.hasValue());
    EXPECT_EQ(read->operations(), log.operations());
}

TEST(ReplayLog, NamesTheLineItCannotRead)
{
    for (const char* bad :
         {"insert 1\n", "insert x 1p+0 1p+0\n", "insert 1 1p+0 1p+0 1p+0 1p+0\n", "remove\n", "constrain 1\n",
          "fly 1\n", "remove 1 junk\n", "\n", "insert 1 1p+0 1z\n"}) {
        const auto read = ReplayLog::fromText(std::string("remove 1\n") + bad);
        ASSERT_FALSE(read.hasValue()) << bad;
        EXPECT_EQ(read.error().code, ErrorCode::Unreadable);
        EXPECT_EQ(read.error().entity, "line 2");
    }
}

TEST(Replay2d, RepeatsWhatWasRecorded)
{
    ReplayLog log;
    Delaunay2d delaunay;
    delaunay.recordTo(&log);
    ASSERT_TRUE(delaunay.insertPoints(uniformPoints2d(300, 1)).hasValue());
    ASSERT_TRUE(delaunay.recoverSegment(VertexId(3), VertexId(200)).hasValue());
    for (std::uint32_t i = 0; i < 300; i += 3) delaunay.remove(VertexId(i), RemovalPolicy::StraightChainsToo);
    Cavity2d cavity;
    delaunay.findCavity({0.5, 0.5}, delaunay.locate({0.5, 0.5}), cavity);
    const VertexId centre = delaunay.commit(cavity);
    ASSERT_TRUE(delaunay.insert({0.25, 0.5}).hasValue());
    const VertexId right = delaunay.mesh().edgeFrom(cavity.boundary[0].outer);
    const VertexId left = delaunay.mesh().edgeTo(cavity.boundary[0].outer);
    delaunay.constrainEdge(delaunay.mesh().findEdge(centre, right));
    delaunay.constrainEdge(delaunay.mesh().findEdge(centre, left));
    delaunay.unconstrainEdge(delaunay.mesh().findEdge(right, centre));

    const auto read = ReplayLog::fromText(log.toText());
    ASSERT_TRUE(read.hasValue());
    Replayer2d replayer;
    for (const ReplayOperation& operation : read->operations()) replayer.apply(operation);
    EXPECT_EQ(hashOf(replayer.delaunay()), hashOf(delaunay));
    EXPECT_TRUE(replay2d(log, 50).report.isValid());
    EXPECT_EQ(replay2d(log, 50).operationsDone, log.operations().size());
}

TEST(Replay2d, PassesOverUnknownLabels)
{
    const auto log = ReplayLog::fromText("remove 4\nconstrain 1 2\ninsert 1 0p+0 0p+0\nremove 1\nremove 1\n");
    EXPECT_TRUE(replay2d(*log, 1).report.isValid());
}

TEST(ReduceSequence, FindsTheCulpritsAmongMany)
{
    std::vector<int> items(1000);
    std::iota(items.begin(), items.end(), 0);
    std::size_t asked = 0;
    const auto fails = [&](const std::vector<int>& rest) {
        ++asked;
        const auto has = [&](int x) { return std::find(rest.begin(), rest.end(), x) != rest.end(); };
        return has(17) && has(512) && has(999);
    };
    EXPECT_EQ(reduceSequence(items, fails), (std::vector<int>{17, 512, 999}));
    EXPECT_LT(asked, 200u);
}

TEST(ReduceSequence, LeavesWhatDoesNotFailAlone)
{
    const std::vector<int> items{1, 2, 3};
    EXPECT_EQ(reduceSequence(items, [](const std::vector<int>&) { return false; }), items);
    EXPECT_TRUE(reduceSequence(items, [](const std::vector<int>&) { return true; }).empty());
}

TEST(ReduceSequence, KeepsWhatOnlyFailsTogether)
{
    std::vector<int> items(64, 1);
    const auto fails = [](const std::vector<int>& rest) { return rest.size() >= 10; };
    EXPECT_EQ(reduceSequence(items, fails).size(), 10u);
}

/// A property that is deliberately broken: "no vertex has more than six neighbours".
TEST(ReduceSequence, ShrinksAReplayLog)
{
    std::vector<ReplayOperation> operations;
    std::uint32_t label = 0;
    for (const Vec2 p : uniformPoints2d(60, 3)) operations.push_back(ReplayOperation::insert(label++, p));
    const auto hasHub = [](const std::vector<ReplayOperation>& some) {
        Replayer2d replayer;
        for (const ReplayOperation& operation : some) replayer.apply(operation);
        const Triangulation2d& mesh = replayer.delaunay().mesh();
        for (std::uint32_t i = 0; i < mesh.vertexSlots() && mesh.triangleCount() > 0; ++i) {
            int degree = 0;
            mesh.forEachTriangleAround(VertexId(i), [&](EdgeLink) { return ++degree > 0; });
            if (degree > 7) return true;
        }
        return false;
    };
    const auto reduced = reduceSequence(operations, hasHub);
    EXPECT_TRUE(hasHub(reduced));
    EXPECT_LT(reduced.size(), 10u);
}

}  // namespace
}  // namespace mesher::test
