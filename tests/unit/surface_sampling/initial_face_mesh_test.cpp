#include "surface_sampling/initial_face_mesh.h"

#include "brep/analytic/line_curve.h"
#include "brep/analytic/parameter_curves.h"
#include "brep/analytic/plane_surface.h"
#include "brep/analytic/solids.h"
#include "surface_sampling/face_triangulation.h"
#include "unit/surface_sampling/sampled_model.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>
#include <utility>
#include <vector>

namespace mesher {
namespace {

using test::SampledModel;

constexpr double kPi = std::numbers::pi;

void expectSound(const SampledModel& sampled)
{
    EXPECT_EQ(checkSurfaceMesh(sampled.model, sampled.mesh).problem(), "");
}

double volumeOf(const SampledModel& sampled)
{
    return checkSurfaceMesh(sampled.model, sampled.mesh).volumes[BrepSolidId(0)];
}

Axes tilted()
{
    const double c = std::cos(0.4), s = std::sin(0.4);
    return {{1.0, -2.0, 3.0}, {c, s, 0.0}, {-s * 0.6, c * 0.6, 0.8}, {s * 0.8, -c * 0.8, 0.6}};
}

TEST(InitialSurfaceMesh, CutsTheSidesOfABoxInTwo)
{
    SampledModel s;
    test::sampleInto(s, *makeBox({-1.0, 0.0, 2.0}, {1.0, 3.0, 5.0}));
    expectSound(s);
    EXPECT_EQ(s.mesh.facets.size(), 12u);
    EXPECT_NEAR(volumeOf(s), 18.0, 1e-12);
}

TEST(InitialSurfaceMesh, ClosesACylinderAtItsSeam)
{
    SampledModel s;
    test::sampleInto(s, *makeCylinder(tilted(), 1.0, 2.0));
    expectSound(s);
    const double octagon = 2.0 * std::sqrt(2.0);
    EXPECT_NEAR(volumeOf(s), 2.0 * octagon, 1e-9);
    // No points inside are needed.
    EXPECT_EQ(s.initial.faces[BrepFaceId(0)].interiorNodes.size(), 0u);
    EXPECT_EQ(s.initial.faces[BrepFaceId(0)].boundary.size(), 18u);
}

TEST(InitialSurfaceMesh, ClosesConesAroundTheirTip)
{
    for (const double top : {0.0, 0.5}) {
        for (const double height : {0.1, 2.0, 40.0}) {
            SampledModel s;
            test::sampleInto(s, *makeCone(tilted(), 1.0, top, height));
            expectSound(s);
            const double exact = kPi * height / 3.0 * (1.0 + top + top * top);
            EXPECT_GT(volumeOf(s), 0.85 * exact);
            EXPECT_LT(volumeOf(s), exact);
        }
    }
}

TEST(InitialSurfaceMesh, GluesThePolesOfASphere)
{
    SampledModel s;
    test::sampleInto(s, *makeSphere(tilted(), 2.0));
    expectSound(s);
    EXPECT_GT(volumeOf(s), 0.7 * 32.0 / 3.0 * kPi);
    // The pole is one node, its longitude that of its neighbours.
    std::size_t atPole = 0;
    for (const SurfaceFacet& facet : s.mesh.facets) {
        for (std::size_t i = 0; i < 3; ++i) {
            if (facet.node[i] != NodeId(0)) continue;
            ++atPole;
            EXPECT_NEAR(facet.parameters[i].x,
                        0.5 * (facet.parameters[(i + 1) % 3].x + facet.parameters[(i + 2) % 3].x), 1e-12);
        }
    }
    EXPECT_GE(atPole, 5u);
}

TEST(InitialSurfaceMesh, GluesBothSeamsOfATorus)
{
    SampledModel s;
    test::sampleInto(s, *makeTorus(tilted(), 3.0, 1.0));
    expectSound(s);
    EXPECT_GT(volumeOf(s), 0.7 * 6.0 * kPi * kPi);
    EXPECT_LT(volumeOf(s), 6.0 * kPi * kPi);
}

TEST(InitialSurfaceMesh, KeepsFacetsWithinTheDeviation)
{
    SampledModel s;
    InitialFaceMeshOptions options;
    options.maxNormalDeviation = 20.0;
    test::sampleInto(s, *makeTorus(Axes{}, 3.0, 1.0), {}, options);
    expectSound(s);
    const SurfaceCheck check = checkSurfaceMesh(s.model, s.mesh);
    EXPECT_LE(check.faces[BrepFaceId(0)].worstCornerAngle, 20.0 + 1e-9);
    EXPECT_GT(s.initial.segmentSplits, 0u);
}

TEST(InitialSurfaceMesh, IsTheSameTwice)
{
    SampledModel a, b;
    test::sampleInto(a, *makeTorus(Axes{}, 3.0, 1.0));
    test::sampleInto(b, *makeTorus(Axes{}, 3.0, 1.0));
    ASSERT_EQ(a.mesh.facets.size(), b.mesh.facets.size());
    for (std::uint32_t i = 0; i < a.mesh.facets.size(); ++i) {
        EXPECT_EQ(a.mesh.facets[FacetId(i)].node, b.mesh.facets[FacetId(i)].node);
        EXPECT_EQ(a.mesh.facets[FacetId(i)].parameters, b.mesh.facets[FacetId(i)].parameters);
    }
}

/// A face of the plane z = 0 with straight edges along closed polygons; each corner is a vertex.
BrepModel planarFace(const std::vector<std::vector<Vec2>>& polygons)
{
    BrepModel model;
    BrepFace face;
    face.surface = std::make_shared<PlaneSurface>(PlaneFrame{});
    face.boundsU = face.boundsV = {-10.0, 10.0};
    for (const auto& polygon : polygons) {
        BrepLoop loop;
        const auto first = static_cast<std::uint32_t>(model.vertices.size());
        const auto count = static_cast<std::uint32_t>(polygon.size());
        for (const Vec2 p : polygon) {
            model.vertices.push_back({{p.x, p.y, 0.0}, 1e-7});
            model.box.include(Vec3{p.x, p.y, 0.0});
        }
        for (std::uint32_t i = 0; i < count; ++i) {
            const BrepVertexId a(first + i), b(first + (i + 1) % count);
            auto line = std::make_shared<LineCurve>(
                LineCurve::between(model.vertices[a].position, model.vertices[b].position));
            const BrepEdgeId edge = model.edges.push_back({line, line->range(), a, b, 1e-7, false});
            loop.coedges.push_back(
                {edge, false, std::make_shared<PlanarParameterCurve>(line->clone(), PlaneFrame{}), 0.0});
        }
        face.loops.push_back(std::move(loop));
    }
    model.faces.push_back(std::move(face));
    return model;
}

TEST(InitialSurfaceMesh, LeavesHolesOpenAndFillsIslands)
{
    SampledModel s;
    test::sampleInto(s, planarFace({{{0.0, 0.0}, {6.0, 0.0}, {6.0, 6.0}, {0.0, 6.0}},
                                    {{1.0, 1.0}, {1.0, 5.0}, {5.0, 5.0}, {5.0, 1.0}},
                                    {{2.0, 2.0}, {4.0, 2.0}, {4.0, 4.0}, {2.0, 4.0}}}));
    expectSound(s);
    const FaceCheck check = checkSurfaceMesh(s.model, s.mesh).faces[BrepFaceId(0)];
    EXPECT_NEAR(check.area, 36.0 - 16.0 + 4.0, 1e-12);
    EXPECT_EQ(check.components, 2);
}

TEST(InitialSurfaceMesh, NamesTheFaceWhoseStraightEdgesCross)
{
    const BrepModel model = planarFace({{{0.0, 0.0}, {2.0, 2.0}, {2.0, 0.0}, {0.0, 2.0}}});
    IdVector<NodeId, MeshNode> nodes;
    auto chains = test::sampledChains(model, {}, nodes);
    ASSERT_TRUE(chains);
    const auto mesh = initialFaceMesh(model, BrepFaceId(0), *chains, nodes, {});
    ASSERT_FALSE(mesh);
    EXPECT_EQ(mesh.error().entity, "Face1");
    EXPECT_TRUE(mesh.error().point.has_value());
    EXPECT_FALSE(mesh.error().remedy.empty());
}

TEST(InitialSurfaceMesh, NamesTheFaceWhoseLoopsOverlap)
{
    const BrepModel model = planarFace({{{0.0, 0.0}, {1.0, 0.0}, {1.0, 1.0}, {0.0, 1.0}},
                                        {{-1.0, -1.0}, {2.0, -1.0}, {2.0, 2.0}, {-1.0, 2.0}}});
    IdVector<NodeId, MeshNode> nodes;
    auto chains = test::sampledChains(model, {}, nodes);
    ASSERT_TRUE(chains);
    const auto mesh = initialFaceMesh(model, BrepFaceId(0), *chains, nodes, {});
    ASSERT_FALSE(mesh);
    EXPECT_EQ(mesh.error().entity, "Face1");
}

TEST(FaceOutline, CorrectsParameterCurvesThatRunBesideTheEdge)
{
    BrepModel model = *makeCylinder(Axes{}, 1.0, 2.0);
    BrepCoedge& bottom = model.faces[BrepFaceId(0)].loops[0].coedges[0];
    bottom.parameterCurve = std::make_shared<LineParameterCurve>(Vec2{0.0, 1e-5}, Vec2{1.0, 0.0});
    bottom.gap = model.edges[bottom.edge].tolerance = 1e-5;
    IdVector<NodeId, MeshNode> nodes;
    const auto chains = test::sampledChains(model, {}, nodes);
    ASSERT_TRUE(chains);
    const auto outline = outlineOf(model, BrepFaceId(0), *chains, nodes);
    ASSERT_TRUE(outline);
    std::size_t checked = 0;
    for (const OutlinePoint& point : outline->points) {
        if (nodes[point.node].entity != EntityRef{1, bottom.edge.value}) continue;
        EXPECT_NEAR(point.uv.y, 0.0, 1e-9);
        ++checked;
    }
    EXPECT_EQ(checked, 7u);
}

TEST(FaceTriangulation, TellsWhereAFaceIsNarrowBesideACurve)
{
    OutlinePiece piece;
    piece.sag = {0.0, 0.1, 0.0};
    const auto isNarrowUpTo = [&](const Vec3& p) {
        return FaceTriangulation::isNarrowBeside(piece, {0.0, 0.0, 0.0}, {1.0, 0.0, 0.0}, p);
    };
    // The width counts from the curve, on either side of it and across the surface's normal.
    EXPECT_TRUE(isNarrowUpTo({0.5, 0.29, 0.0}));
    EXPECT_FALSE(isNarrowUpTo({0.5, 0.31, 0.0}));
    EXPECT_TRUE(isNarrowUpTo({0.5, -0.09, 0.0}));
    EXPECT_FALSE(isNarrowUpTo({0.5, -0.11, 0.0}));
    EXPECT_TRUE(isNarrowUpTo({0.5, 0.0, 0.17}));
    EXPECT_FALSE(isNarrowUpTo({0.5, 0.0, 0.18}));
    // Towards its ends the segment nears the curve; beyond them it has no face beside it.
    EXPECT_FALSE(isNarrowUpTo({0.01, 0.05, 0.0}));
    EXPECT_FALSE(isNarrowUpTo({1.1, 0.0, 0.0}));
}

TEST(InitialFaceMesh, MeshesOneFaceAndAppendsItsNodes)
{
    const BrepModel model = *makeSphere(Axes{}, 1.0);
    IdVector<NodeId, MeshNode> nodes;
    auto chains = test::sampledChains(model, {}, nodes);
    ASSERT_TRUE(chains);
    const std::size_t onCurves = nodes.size();
    const auto facets = initialFaceMesh(model, BrepFaceId(0), *chains, nodes, {});
    ASSERT_TRUE(facets) << describe(facets.error());
    EXPECT_GT(nodes.size(), onCurves);
    std::vector<bool> isUsed(nodes.size(), false);
    for (const SurfaceFacet& facet : *facets) {
        for (const NodeId node : facet.node) isUsed[node.value] = true;
    }
    EXPECT_TRUE(std::all_of(isUsed.begin(), isUsed.end(), [](bool used) { return used; }));
}

}  // namespace
}  // namespace mesher
