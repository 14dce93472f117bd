#include "brep/model_welding.h"

#include "brep/analytic/solids.h"
#include "support/model_union.h"

#include <gtest/gtest.h>

#include <utility>

namespace mesher::test {
namespace {

/// Each parameter curve lies on its edge's curve, end to end, and each loop is closed.
void expectLoopsOnEdges(const BrepModel& model)
{
    constexpr double kClose = 1e-9;
    for (const BrepFace& face : model.faces) {
        for (const BrepLoop& loop : face.loops) {
            for (std::size_t i = 0; i < loop.coedges.size(); ++i) {
                const BrepCoedge& coedge = loop.coedges[i];
                const BrepCoedge& next = loop.coedges[(i + 1) % loop.coedges.size()];
                const BrepEdge &edge = model.edges[coedge.edge], &after = model.edges[next.edge];
                EXPECT_EQ(coedge.isReversed ? edge.first : edge.last,
                          next.isReversed ? after.last : after.first);
                const Vec2 whole = coedge.parameterCurve->position(edge.part.last) -
                                   coedge.parameterCurve->position(edge.part.first);
                for (int k = 0; k <= 32 && !edge.isDegenerate; ++k) {
                    const double t = edge.part.at(k / 32.0);
                    const Vec2 uv = coedge.parameterCurve->position(t);
                    EXPECT_LT(length(face.surface->position(uv) - edge.curve->position(t)), kClose);
                    const Vec2 uvNext = coedge.parameterCurve->position(edge.part.at((k + 1) / 32.0));
                    if (k < 32 && face.surface->kind() == SurfaceKind::Cylinder) {
                        EXPECT_LT(length(uvNext - uv), 0.1 * length(whole)) << "jumps";
                    }
                }
            }
        }
    }
}

TEST(ModelWelding, LetsOneEdgeStandForTwoOfBoxesThatTouchAlongIt)
{
    BrepModel model = together(*makeBox({}, {1.0, 1.0, 1.0}), *makeBox({1.0, 1.0, 0.0}, {2.0, 2.0, 1.0}));
    const WeldedEntities welded = weldCoincidences(model);
    EXPECT_EQ(welded.vertices, 2u);
    EXPECT_EQ(welded.edges, 1u);
    expectLoopsOnEdges(model);
    EXPECT_EQ(weldCoincidences(model).edges, 1u) << "the twin is still there and bounds nothing";
}

TEST(ModelWelding, WeldsAVertexThatTwoBoxesTouchIn)
{
    BrepModel model = together(*makeBox({}, {1.0, 1.0, 1.0}), *makeBox({1.0, 1.0, 1.0}, {2.0, 2.0, 2.0}));
    const WeldedEntities welded = weldCoincidences(model);
    EXPECT_EQ(welded.vertices, 1u);
    EXPECT_EQ(welded.edges, 0u);
    expectLoopsOnEdges(model);
}

TEST(ModelWelding, TurnsClosedEdgesThatRunTheOtherWay)
{
    // Its circles run the other way around.
    const Axes down{{0.0, 0.0, 2.0}, {1.0, 0.0, 0.0}, {0.0, -1.0, 0.0}, {0.0, 0.0, -1.0}};
    BrepModel model = together(*makeCylinder(Axes{}, 1.0, 1.0), *makeCylinder(down, 1.0, 1.0));
    const WeldedEntities welded = weldCoincidences(model);
    EXPECT_EQ(welded.vertices, 1u);
    EXPECT_EQ(welded.edges, 1u) << "the circle between them";
    expectLoopsOnEdges(model);
}

TEST(ModelWelding, KeepsWhatOneEdgeJoinsAndWhatIsApart)
{
    BrepModel thin = *makeBox({}, {1.0, 1.0, 5e-8});
    EXPECT_EQ(weldCoincidences(thin).vertices, 0u) << "its short edges join them";
    BrepModel apart =
        together(*makeBox({}, {1.0, 1.0, 1.0}), *makeBox({1.0 + 1e-5, 1.0, 0.0}, {2.0, 2.0, 1.0}));
    EXPECT_EQ(weldCoincidences(apart).vertices, 0u);
}

}  // namespace
}  // namespace mesher::test
