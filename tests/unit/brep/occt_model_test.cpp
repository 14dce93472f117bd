#include "brep/model_inspection.h"
#include "brep/occt/read_model.h"
#include "occt_models.h"
#include "support/model_contract.h"

#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRep_Tool.hxx>
#include <Geom_BSplineSurface.hxx>
#include <TColStd_Array1OfInteger.hxx>
#include <TColStd_Array1OfReal.hxx>
#include <TColgp_Array2OfPnt.hxx>
#include <TopExp.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Vertex.hxx>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

namespace mesher {

TEST(OcctModel, KeepsTheContract)
{
    for (const auto& [name, shape] : test::kernelModels()) {
        SCOPED_TRACE(name);
        const Result<ReadModel> read = readModelFromShape(shape);
        ASSERT_TRUE(read) << describe(read.error());
        const test::ContractReport report = test::checkModelContract(read->model, {12, true});
        EXPECT_GT(report.faces, 0u);
        EXPECT_LT(report.largestGap, 1e-6);
        for (const std::string& line : report.broken) ADD_FAILURE() << line;
        for (const std::string& note : read->model.notes) ADD_FAILURE() << note;
    }
}

TEST(OcctModel, HasABoxThatTouchesItsFaces)
{
    constexpr int kSteps = 60;
    constexpr double kBetweenSamples = 0.03;
    for (const auto& [name, shape] : test::kernelModels()) {
        SCOPED_TRACE(name);
        const BrepModel model = readModelFromShape(shape).value().model;
        Box3 sampled;
        for (const BrepFace& face : model.faces) {
            for (int i = 0; i <= kSteps * kSteps; ++i) {
                const Vec2 uv{face.boundsU.at(static_cast<double>(i / kSteps) / kSteps),
                              face.boundsV.at(static_cast<double>(i % kSteps) / kSteps)};
                if (face.trim->classify(uv) == TrimSide::Inside) sampled.include(face.surface->position(uv));
            }
        }
        const double allowed = kBetweenSamples * length(model.box.extent());
        EXPECT_LT(length(sampled.low - model.box.low), allowed);
        EXPECT_LT(length(sampled.high - model.box.high), allowed);
        const Vec3 rounding = {1e-9, 1e-9, 1e-9};
        const Box3 grown = {model.box.low - rounding, model.box.high + rounding};
        EXPECT_TRUE(grown.contains(sampled.low) && grown.contains(sampled.high));
    }
}

TEST(OcctModel, NumbersEntitiesAsMapShapes)
{
    for (const auto& [name, shape] : test::kernelModels()) {
        SCOPED_TRACE(name);
        const BrepModel model = readModelFromShape(shape).value().model;
        TopTools_IndexedMapOfShape vertices, edges, faces;
        TopExp::MapShapes(shape, TopAbs_VERTEX, vertices);
        TopExp::MapShapes(shape, TopAbs_EDGE, edges);
        TopExp::MapShapes(shape, TopAbs_FACE, faces);
        ASSERT_EQ(model.vertices.size(), static_cast<std::size_t>(vertices.Extent()));
        ASSERT_EQ(model.edges.size(), static_cast<std::size_t>(edges.Extent()));
        ASSERT_EQ(model.faces.size(), static_cast<std::size_t>(faces.Extent()));
        for (std::uint32_t i = 0; i < model.vertices.size(); ++i) {
            const gp_Pnt p = BRep_Tool::Pnt(TopoDS::Vertex(vertices(static_cast<int>(i) + 1)));
            EXPECT_EQ(model.vertices[BrepVertexId(i)].position, (Vec3{p.X(), p.Y(), p.Z()}));
        }
    }
}

TEST(OcctModel, UsesClosedFormsWhereThereAreAny)
{
    const auto kindsOf = [](const std::string& wanted) {
        std::set<SurfaceKind> kinds;
        for (const auto& [name, shape] : test::kernelModels()) {
            if (name != wanted) continue;
            const BrepModel model = readModelFromShape(shape).value().model;
            for (const BrepFace& face : model.faces) kinds.insert(face.surface->kind());
        }
        return kinds;
    };
    EXPECT_EQ(kindsOf("pointed cone"), (std::set{SurfaceKind::Plane, SurfaceKind::Cone}));
    EXPECT_EQ(kindsOf("placed torus"), (std::set{SurfaceKind::Torus}));
    EXPECT_EQ(kindsOf("mirrored filleted box"),
              (std::set{SurfaceKind::Plane, SurfaceKind::Cylinder, SurfaceKind::Sphere}));
    EXPECT_EQ(kindsOf("offset face"), (std::set{SurfaceKind::Offset}));
    EXPECT_EQ(kindsOf("revolved spline"), (std::set{SurfaceKind::Revolution}));
    EXPECT_EQ(kindsOf("extruded spline"), (std::set{SurfaceKind::Extrusion}));
}

TEST(OcctModel, SharedFaceBelongsToBothSolidsWithOppositeSides)
{
    const BrepModel model = readModelFromShape(test::gluedBoxes()).value().model;
    ASSERT_EQ(model.solids.size(), 2u);
    EXPECT_EQ(model.faces.size(), 11u);
    EXPECT_EQ(model.edges.size(), 20u);
    std::map<std::uint32_t, std::vector<bool>> uses;
    for (const BrepSolid& solid : model.solids) {
        ASSERT_EQ(solid.shells.size(), 1u);
        EXPECT_TRUE(solid.shells[0].isClosed);
        for (const BrepShellFace& use : solid.shells[0].faces) uses[use.face.value].push_back(use.isReversed);
    }
    const auto isShared = [](const auto& entry) { return entry.second.size() == 2; };
    ASSERT_EQ(std::count_if(uses.begin(), uses.end(), isShared), 1);
    const auto shared = std::find_if(uses.begin(), uses.end(), isShared);
    EXPECT_NE(shared->second[0], shared->second[1]);
}

TEST(OcctModel, SeamIsUsedTwiceWithTwoParameterCurves)
{
    for (const auto& [name, shape] : test::kernelModels()) {
        if (name != "cylinder") continue;
        const BrepModel model = readModelFromShape(shape).value().model;
        for (const BrepFace& face : model.faces) {
            if (face.surface->kind() != SurfaceKind::Cylinder) continue;
            ASSERT_EQ(face.loops.size(), 1u);
            ASSERT_EQ(face.loops[0].coedges.size(), 4u);
            std::vector<double> seamU;
            for (const BrepCoedge& coedge : face.loops[0].coedges) {
                if (!model.edges[coedge.edge].isClosed())
                    seamU.push_back(coedge.parameterCurve->position(1.0).x);
            }
            ASSERT_EQ(seamU.size(), 2u);
            EXPECT_NEAR(std::abs(seamU[0] - seamU[1]), face.surface->periodU(), 1e-12);
        }
    }
}

TEST(OcctModel, PolesThatRunAlongAnEdgeAreLeftOut)
{
    const BrepModel model = readModelFromShape(test::cylinderWithFalsePole()).value().model;
    ASSERT_EQ(model.edges.size(), 4u);
    ASSERT_EQ(model.notes.size(), 1u);
    EXPECT_EQ(model.notes.front(),
              "Edge4 is marked as a pole of Face1 and runs along another edge, left out");
    for (const BrepFace& face : model.faces) {
        for (const BrepLoop& loop : face.loops) {
            for (const BrepCoedge& coedge : loop.coedges) EXPECT_FALSE(model.edges[coedge.edge].isDegenerate);
        }
    }
}

TEST(OcctModel, NullAndFacelessShapesAreRefused)
{
    EXPECT_FALSE(readModelFromShape(TopoDS_Shape()));
    const Result<ReadModel> wire = readModelFromShape(test::polygon({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}));
    ASSERT_FALSE(wire);
    EXPECT_EQ(wire.error().message, "the model has no face");
}

TEST(OcctModel, MeasuresSheetsOfManyFolds)
{
    constexpr int kFolds = 40;
    TColgp_Array2OfPnt poles(1, kFolds + 1, 1, 2);
    TColStd_Array1OfReal knots(1, kFolds + 1);
    TColStd_Array1OfInteger multiplicities(1, kFolds + 1);
    for (int i = 0; i <= kFolds; ++i) {
        poles.SetValue(i + 1, 1, gp_Pnt(i, 0.0, i % 2));
        poles.SetValue(i + 1, 2, gp_Pnt(i, 3.0, i % 2));
        knots.SetValue(i + 1, i);
        multiplicities.SetValue(i + 1, i == 0 || i == kFolds ? 2 : 1);
    }
    TColStd_Array1OfReal across(1, 2);
    across.SetValue(1, 0.0);
    across.SetValue(2, 1.0);
    TColStd_Array1OfInteger twice(1, 2);
    twice.Init(2);
    const Handle(Geom_Surface) sheet =
        new Geom_BSplineSurface(poles, knots, across, multiplicities, twice, 1, 1);
    const auto read = readModelFromShape(BRepBuilderAPI_MakeFace(sheet, 1e-7).Face());
    ASSERT_TRUE(read) << describe(read.error());
    EXPECT_NEAR(inspectModel(read->model).area, 3.0 * kFolds * std::sqrt(2.0), 1e-6);
}

namespace {

/// A round wall of splines that are periodic along u.
TopoDS_Shape periodicWall()
{
    constexpr int kPoles = 8;
    TColgp_Array2OfPnt poles(1, kPoles, 1, 2);
    TColStd_Array1OfReal knots(1, kPoles + 1), across(1, 2);
    TColStd_Array1OfInteger multiplicities(1, kPoles + 1), twice(1, 2);
    for (int i = 0; i < kPoles; ++i) {
        const double angle = 2.0 * M_PI * i / kPoles;
        poles.SetValue(i + 1, 1, gp_Pnt(std::cos(angle), std::sin(angle), 0.0));
        poles.SetValue(i + 1, 2, gp_Pnt(std::cos(angle), std::sin(angle), 1.0));
    }
    for (int i = 0; i <= kPoles; ++i) knots.SetValue(i + 1, i);
    multiplicities.Init(1);
    across.SetValue(1, 0.0);
    across.SetValue(2, 1.0);
    twice.Init(2);
    const Handle(Geom_Surface) wall =
        new Geom_BSplineSurface(poles, knots, across, multiplicities, twice, 3, 1, true, false);
    return BRepBuilderAPI_MakeFace(wall, 1e-7).Face();
}

}  // namespace

TEST(OcctModel, AnswersAtParametersManyPeriodsAway)
{
    const BrepModel model = readModelFromShape(periodicWall()).value().model;
    const BrepFace& face = model.faces[BrepFaceId(0)];
    const double period = face.surface->periodU();
    ASSERT_EQ(period, 8.0);
    const Vec3 near = face.surface->position({1.25, 0.5});
    for (const double turns : {3.0, -70.0, 1e9, -1e12}) {
        EXPECT_LT(length(face.surface->position({1.25 + turns * period, 0.5}) - near), 1e-3) << turns;
        EXPECT_TRUE(isFinite(face.surface->evaluate({1.25 + turns * period, 0.5}).du)) << turns;
        EXPECT_EQ(face.trim->classify({1.25 + turns * period, 0.5}), TrimSide::Inside) << turns;
    }
    for (const double far : {1e30, -1e300}) {
        EXPECT_TRUE(isFinite(face.surface->position({far, far}))) << far;
        EXPECT_EQ(face.trim->classify({1.0, far}), TrimSide::Outside) << far;
    }
    EXPECT_FALSE(isFinite(face.surface->position({std::nan(""), 0.5})));
    EXPECT_EQ(face.trim->classify({std::nan(""), 0.5}), TrimSide::Outside);
    for (const BrepEdge& edge : model.edges) {
        EXPECT_TRUE(isFinite(edge.curve->position(edge.part.first + 1e14)));
        EXPECT_FALSE(isFinite(edge.curve->position(std::nan(""))));
    }
}

}  // namespace mesher
