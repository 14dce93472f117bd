#include "surface_sampling/curve_chains.h"

#include "brep/analytic/bspline_curve.h"
#include "brep/analytic/line_curve.h"
#include "brep/analytic/solids.h"
#include "sizing/shape_sizes.h"
#include "sizing/uniform_size.h"
#include "unit/surface_sampling/sampled_model.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace mesher {
namespace {

struct Chained
{
    BrepModel model;
    IdVector<NodeId, MeshNode> nodes;
    CurveChains chains;
};

void chainInto(Chained& chained, const CurveChainOptions& options = {})
{
    auto chains = test::sampledChains(chained.model, options, chained.nodes);
    ASSERT_TRUE(chains) << describe(chains.error());
    chained.chains = std::move(*chains);
}

std::size_t countOf(const Chained& chained, std::uint32_t edge)
{
    return chained.chains.chainOf(BrepEdgeId(edge)).size();
}

double longestOf(const Chained& chained, BrepEdgeId edge)
{
    double longest = 0.0;
    for (const SegmentId s : chained.chains.chainOf(edge)) {
        const auto [a, b] = chained.chains.segments()[s].node;
        longest = std::max(longest, length(chained.nodes[a].position - chained.nodes[b].position));
    }
    return longest;
}

TEST(CurveChains, CutCirclesByTurningAndLeaveLinesWhole)
{
    Chained c{*makeCylinder(Axes{}, 2.0, 5.0), {}, {}};
    chainInto(c);
    EXPECT_EQ(countOf(c, 0), 8u);
    EXPECT_EQ(countOf(c, 1), 1u);
    EXPECT_EQ(countOf(c, 2), 8u);
    EXPECT_EQ(c.chains.aliveCount(), 17u);
    EXPECT_EQ(c.nodes.size(), 2u + 7u + 7u);
}

TEST(CurveChains, HaveANodeForEachVertexOfTheModelFirst)
{
    Chained c{*makeBox({0.0, 0.0, 0.0}, {1.0, 2.0, 3.0}), {}, {}};
    chainInto(c);
    ASSERT_EQ(c.nodes.size(), 8u);
    for (std::uint32_t v = 0; v < 8; ++v) {
        EXPECT_EQ(c.nodes[NodeId(v)].position, c.model.vertices[BrepVertexId(v)].position);
        EXPECT_EQ(c.nodes[NodeId(v)].entity, (EntityRef{0, v}));
    }
}

TEST(CurveChains, GiveAClosedEdgeThreeSegmentsHoweverCoarse)
{
    Chained c{*makeTorus(Axes{}, 3.0, 1.0), {}, {}};
    CurveChainOptions options;
    options.maxVariation = 360.0;
    chainInto(c, options);
    EXPECT_EQ(countOf(c, 0), 3u);
    EXPECT_EQ(countOf(c, 1), 3u);
}

TEST(CurveChains, KeepToSegmentsPerTurnAndSag)
{
    Chained turn{*makeCylinder(Axes{}, 2.0, 5.0), {}, {}};
    CurveChainOptions options;
    options.segmentsPerTurn = 20.0;
    chainInto(turn, options);
    EXPECT_EQ(countOf(turn, 0), 20u);

    Chained sag{*makeCylinder(Axes{}, 2.0, 5.0), {}, {}};
    options = {};
    options.maxSag = 1e-3;
    chainInto(sag, options);
    const double angle = 2.0 * std::acos(1.0 - 1e-3 / 2.0);
    EXPECT_GE(countOf(sag, 0), std::ceil(2.0 * std::acos(-1.0) / angle) - 1.0);
    EXPECT_LE(countOf(sag, 0), 2.0 * std::acos(-1.0) / angle + 8.0);
}

TEST(CurveChains, FollowASizeAlongStraightEdges)
{
    Chained c{*makeBox({0.0, 0.0, 0.0}, {1.0, 2.0, 3.0}), {}, {}};
    const UniformSize size(0.3);
    CurveChainOptions options;
    options.sizes = &size;
    chainInto(c, options);
    for (std::uint32_t e = 0; e < 12; ++e) {
        EXPECT_LE(longestOf(c, BrepEdgeId(e)), 0.3 * 10.0 / 9.0 + 1e-12)
            << "1.0 makes three pieces, not four";
        EXPECT_GE(longestOf(c, BrepEdgeId(e)), 0.28);
    }
}

TEST(CurveChains, FollowAGradedSize)
{
    Chained c{*makeBox({0.0, 0.0, 0.0}, {10.0, 1.0, 1.0}), {}, {}};
    const BallSize size({0.0, 0.0, 0.0}, 0.1, DistanceProfile{0.05, 0.0, 0.2});
    CurveChainOptions options;
    options.sizes = &size;
    chainInto(c, options);
    for (const SegmentId s : c.chains.chainOf(BrepEdgeId(0))) {
        const auto [a, b] = c.chains.segments()[s].node;
        const Vec3 p = c.nodes[a].position, q = c.nodes[b].position;
        const double wanted = size.sizeAt(0.5 * (p + q));
        EXPECT_LE(length(q - p), 1.25 * wanted);
        EXPECT_GE(length(q - p), 0.5 * wanted);
    }
}

TEST(CurveChains, RefuseMoreSegmentsThanAllowed)
{
    const BrepModel model = *makeBox({0.0, 0.0, 0.0}, {1.0, 1.0, 1.0});
    const UniformSize size(1e-4);
    CurveChainOptions options;
    options.sizes = &size;
    options.maxSegments = 1000;
    IdVector<NodeId, MeshNode> nodes;
    const auto chains = test::sampledChains(model, options, nodes);
    ASSERT_FALSE(chains);
    EXPECT_EQ(chains.error().entity, "Edge1");
}

TEST(CurveChains, SplitInTheMiddleOfTheTurningAndKeepIds)
{
    Chained c{*makeCylinder(Axes{}, 2.0, 5.0), {}, {}};
    chainInto(c);
    const std::vector<SegmentId> before = c.chains.chainOf(BrepEdgeId(0));
    const auto split = c.chains.split(before[3], c.nodes);
    ASSERT_TRUE(split);
    std::vector<SegmentId> expected = before;
    expected[3] = split->halves[0];
    expected.insert(expected.begin() + 4, split->halves[1]);
    EXPECT_EQ(c.chains.chainOf(BrepEdgeId(0)), expected);
    EXPECT_FALSE(c.chains.isAlive(before[3]));
    const double quarter = std::acos(-1.0) / 4.0;
    EXPECT_NEAR(c.nodes[split->node].parameters.x, 3.5 * quarter, 1e-12);
    const Vec3 exact = c.model.edges[BrepEdgeId(0)].curve->position(c.nodes[split->node].parameters.x);
    EXPECT_EQ(c.nodes[split->node].position, exact);
    EXPECT_EQ(c.chains.previous(split->halves[1]), split->halves[0]);
    EXPECT_EQ(c.chains.next(split->halves[1]), before[4]);
}

/// One edge: a quarter circle of radius 1 that goes over into a line of length 6.
BrepModel quarterAndLine()
{
    BSplineData data;
    data.degree = 2;
    data.poles = {{1.0, 0.0, 0.0}, {1.0, 1.0, 0.0}, {0.0, 1.0, 0.0}, {-3.0, 1.0, 0.0}, {-6.0, 1.0, 0.0}};
    data.weights = {1.0, std::sqrt(0.5), 1.0, 1.0, 1.0};
    data.knots = {0.0, 0.0, 0.0, 1.0, 1.0, 2.0, 2.0, 2.0};
    BrepModel model;
    model.vertices.push_back({data.poles.front(), 1e-7});
    model.vertices.push_back({data.poles.back(), 1e-7});
    BrepEdge edge;
    edge.curve = BSplineCurve::make(std::move(data)).value();
    edge.part = {0.0, 2.0};
    edge.first = BrepVertexId(0);
    edge.last = BrepVertexId(1);
    edge.tolerance = 1e-7;
    model.edges.push_back(edge);
    return model;
}

TEST(CurveChains, SplitPastTheEndOfATurn)
{
    Chained c{quarterAndLine(), {}, {}};
    chainInto(c);
    const auto lengthOf = [&](SegmentId s) {
        const auto [a, b] = c.chains.segments()[s].node;
        return length(c.nodes[a].position - c.nodes[b].position);
    };
    const auto isShorter = [&](SegmentId a, SegmentId b) { return lengthOf(a) < lengthOf(b); };
    const auto chain = [&] { return c.chains.chainOf(BrepEdgeId(0)); };
    for (int i = 0; i < 30 && longestOf(c, BrepEdgeId(0)) > 1.0; ++i) {
        const std::vector<SegmentId> now = chain();
        ASSERT_TRUE(c.chains.split(*std::max_element(now.begin(), now.end(), isShorter), c.nodes));
    }
    EXPECT_LE(longestOf(c, BrepEdgeId(0)), 1.0);
    const std::vector<SegmentId> last = chain();
    EXPECT_GT(lengthOf(*std::min_element(last.begin(), last.end(), isShorter)), 0.02);
}

TEST(CurveChains, SplitTheFirstSegmentOfAnEdge)
{
    Chained c{*makeBox({0.0, 0.0, 0.0}, {1.0, 2.0, 3.0}), {}, {}};
    chainInto(c);
    const SegmentId first = c.chains.firstOf(BrepEdgeId(4));
    const auto split = c.chains.split(first, c.nodes);
    ASSERT_TRUE(split);
    EXPECT_EQ(c.chains.firstOf(BrepEdgeId(4)), split->halves[0]);
    EXPECT_EQ(c.chains.aliveCount(), 13u);
}

TEST(CurveChains, DoNotSplitBelowTheFloor)
{
    Chained c{*makeBox({0.0, 0.0, 0.0}, {1.0, 1.0, 1.0}), {}, {}};
    c.model.edges[BrepEdgeId(0)].tolerance = 0.03;
    for (BrepFace& face : c.model.faces) {
        for (BrepCoedge& coedge : face.loops[0].coedges)
            coedge.gap = coedge.edge == BrepEdgeId(0) ? 0.02 : 0.0;
    }
    chainInto(c);
    EXPECT_DOUBLE_EQ(c.chains.floorOf(c.chains.firstOf(BrepEdgeId(0))), 0.2);
    const auto halves = c.chains.split(c.chains.firstOf(BrepEdgeId(0)), c.nodes);
    ASSERT_TRUE(halves);
    const auto quarters = c.chains.split(halves->halves[0], c.nodes);
    ASSERT_TRUE(quarters);
    EXPECT_FALSE(c.chains.split(quarters->halves[0], c.nodes));
    EXPECT_TRUE(c.chains.isAlive(quarters->halves[0]));
}

TEST(CurveChains, TakeMeasuredGapsForToleranceThatIsTooLarge)
{
    Chained c{*makeCylinder(Axes{}, 1.0, 1.0), {}, {}};
    c.model.edges[BrepEdgeId(0)].tolerance = 5.0;
    chainInto(c);
    EXPECT_EQ(countOf(c, 0), 8u);
}

TEST(CurveChains, KeepAwayFromAVertexOffItsCurves)
{
    Chained c{*makeBox({0.0, 0.0, 0.0}, {1.0, 1.0, 1.0}), {}, {}};
    c.model.vertices[BrepVertexId(0)].tolerance = 0.05;
    c.model.vertices[BrepVertexId(0)].position = {0.0, 0.0, -0.03};
    chainInto(c);
    const auto halves = c.chains.split(c.chains.firstOf(BrepEdgeId(0)), c.nodes);
    ASSERT_TRUE(halves);
    EXPECT_FALSE(c.chains.split(halves->halves[0], c.nodes));
    EXPECT_TRUE(c.chains.split(halves->halves[1], c.nodes));
}

TEST(CurveChains, LeaveRightAnglesUnprotected)
{
    Chained c{*makeBox({0.0, 0.0, 0.0}, {1.0, 1.0, 1.0}), {}, {}};
    chainInto(c);
    EXPECT_EQ(c.chains.smallAngles().size(), 0u);
    EXPECT_EQ(c.chains.aliveCount(), 12u);
}

/// A box whose corner at the origin is drawn out, so that three edges of different lengths leave it at small angles.
BrepModel spike()
{
    BrepModel model;
    const std::array<Vec3, 4> tips{Vec3{0.0, 0.0, 0.0}, Vec3{4.0, 0.2, 0.0}, Vec3{6.0, -0.3, 0.1},
                                   Vec3{3.0, 0.1, 0.4}};
    for (const Vec3& p : tips) model.vertices.push_back({p, 1e-7});
    for (std::uint32_t i = 1; i < 4; ++i) {
        auto line = std::make_shared<LineCurve>(LineCurve::between(tips[0], tips[i]));
        // One runs towards the apex.
        if (i == 2) line = std::make_shared<LineCurve>(LineCurve::between(tips[i], tips[0]));
        const Interval part = line->range();
        const BrepVertexId apex(0), tip(i);
        model.edges.push_back({line, part, i == 2 ? tip : apex, i == 2 ? apex : tip, 1e-7, false});
    }
    return model;
}

TEST(CurveChains, CutSmallAnglesAtOneShell)
{
    Chained c{spike(), {}, {}};
    chainInto(c);
    ASSERT_EQ(c.chains.smallAngles().size(), 1u);
    const SmallAngleAtVertex& complex = c.chains.smallAngles()[AngleComplexId(0)];
    EXPECT_EQ(complex.apex, BrepVertexId(0));
    EXPECT_EQ(complex.edges.size(), 3u);
    EXPECT_EQ(complex.firstShell, 1);  // two thirds of about 3
    EXPECT_EQ(c.chains.unprotectedCount(), 0u);
    std::vector<NodeId> onShell;
    for (std::uint32_t e = 0; e < 3; ++e) {
        const std::vector<SegmentId> chain = c.chains.chainOf(BrepEdgeId(e));
        ASSERT_EQ(chain.size(), 2u);
        const NodeId middle = c.chains.segments()[chain[0]].node[1];
        EXPECT_NEAR(length(c.nodes[middle].position), 2.0, 1e-12);
        onShell.push_back(middle);
    }
    EXPECT_TRUE(c.chains.spansSmallAngle(onShell[0], onShell[2]));
    EXPECT_FALSE(c.chains.spansSmallAngle(onShell[0], NodeId(1)));
}

TEST(CurveChains, SplitBesideAnApexOnTheNextSmallerShell)
{
    Chained c{spike(), {}, {}};
    chainInto(c);
    const SegmentId atApex = c.chains.chainOf(BrepEdgeId(1)).back();
    ASSERT_TRUE(c.chains.complexOf(atApex).isValid());
    const auto split = c.chains.split(atApex, c.nodes);
    ASSERT_TRUE(split);
    EXPECT_NEAR(length(c.nodes[split->node].position), 1.0, 1e-12);
    // Between the shells of its ends the outer half is split halfway.
    const auto outer = c.chains.split(split->halves[0], c.nodes);
    ASSERT_TRUE(outer);
    EXPECT_NEAR(length(c.nodes[outer->node].position), 1.5, 1e-12);
}

}  // namespace
}  // namespace mesher
