#include "brep/occt/read_model.h"
#include "sizing/uniform_size.h"
#include "surface_sampling/sample_surface.h"
#include "unit/brep/occt_models.h"
#include "unit/surface_sampling/sampled_model.h"

#include <BRepAdaptor_Curve.hxx>
#include <BRepAlgoAPI_Common.hxx>
#include <BRepAlgoAPI_Cut.hxx>
#include <BRepAlgoAPI_Fuse.hxx>
#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakeWire.hxx>
#include <BRepBuilderAPI_NurbsConvert.hxx>
#include <BRepFilletAPI_MakeFillet.hxx>
#include <BRepOffsetAPI_ThruSections.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCone.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRepPrimAPI_MakePrism.hxx>
#include <BRepPrimAPI_MakeRevol.hxx>
#include <BRepPrimAPI_MakeSphere.hxx>
#include <BRepPrimAPI_MakeTorus.hxx>
#include <GeomAPI_PointsToBSpline.hxx>
#include <Geom_BSplineCurve.hxx>
#include <Geom_BSplineSurface.hxx>
#include <TColStd_Array1OfInteger.hxx>
#include <TColStd_Array1OfReal.hxx>
#include <TColgp_Array1OfPnt.hxx>
#include <TColgp_Array2OfPnt.hxx>
#include <TopExp.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Edge.hxx>
#include <gp_Ax1.hxx>
#include <gp_Ax2.hxx>
#include <gp_Circ.hxx>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

namespace mesher {
namespace {

using test::SampledModel;
using NamedShape = std::pair<std::string, TopoDS_Shape>;

constexpr double kPi = std::numbers::pi;

TopoDS_Wire circleAt(double x, double z, double radius)
{
    const gp_Circ circle(gp_Ax2(gp_Pnt(x, 0.0, z), gp_Dir(0.0, 0.0, 1.0)), radius);
    return BRepBuilderAPI_MakeWire(BRepBuilderAPI_MakeEdge(circle).Edge());
}

TopoDS_Shape loft()
{
    BRepOffsetAPI_ThruSections sections(true, false);
    sections.AddWire(circleAt(0.0, 0.0, 1.0));
    sections.AddWire(circleAt(0.5, 1.0, 0.4));
    sections.AddWire(circleAt(-0.5, 2.0, 1.2));
    sections.AddWire(circleAt(0.0, 3.0, 0.6));
    return sections.Shape();
}

/// A thin ring whose radii differ by much less than the sag of eight segments, which begin elsewhere inside than outside.
TopoDS_Shape thinRing()
{
    const double angle = kPi / 8.0;
    const gp_Ax2 turned(gp_Pnt(0.0, 0.0, 0.0), gp_Dir(0.0, 0.0, 1.0),
                        gp_Dir(std::cos(angle), std::sin(angle), 0.0));
    return BRepAlgoAPI_Cut(BRepPrimAPI_MakeCylinder(10.0, 0.2).Shape(),
                           BRepPrimAPI_MakeCylinder(turned, 9.8, 0.2).Shape());
}

/// A hole so near to the rim that it lies outside of the rim's first segments.
TopoDS_Shape diskWithHoleAtRim()
{
    const double angle = kPi / 8.0;
    const gp_Ax2 axis(gp_Pnt(9.7 * std::cos(angle), 9.7 * std::sin(angle), -1.0), gp_Dir(0.0, 0.0, 1.0));
    return BRepAlgoAPI_Cut(BRepPrimAPI_MakeCylinder(10.0, 1.0).Shape(),
                           BRepPrimAPI_MakeCylinder(axis, 0.2, 3.0).Shape());
}

TopoDS_Shape roundedCylinder()
{
    const TopoDS_Shape cylinder = BRepPrimAPI_MakeCylinder(2.0, 1.0).Shape();
    TopTools_IndexedMapOfShape edges;
    TopExp::MapShapes(cylinder, TopAbs_EDGE, edges);
    BRepFilletAPI_MakeFillet fillet(cylinder);
    for (int i = 1; i <= edges.Extent(); ++i) {
        const TopoDS_Edge& edge = TopoDS::Edge(edges(i));
        if (BRepAdaptor_Curve(edge).GetType() == GeomAbs_Circle) fillet.Add(0.05, edge);
    }
    return fillet.Shape();
}

/// Two flat caps on one circle, without a seam or pole in either.
TopoDS_Shape lens()
{
    const gp_Pnt left(-1.379, -1.379, 0.0), right(1.379, 1.379, 0.0);
    return BRepAlgoAPI_Common(BRepPrimAPI_MakeSphere(left, 2.0).Shape(),
                              BRepPrimAPI_MakeSphere(right, 2.0).Shape());
}

TopoDS_Shape wedge(double degrees)
{
    const double angle = degrees * kPi / 180.0;
    const TopoDS_Wire outline = test::polygon({gp_Pnt(0.0, 0.0, 0.0), gp_Pnt(5.0, 0.0, 0.0),
                                               gp_Pnt(5.0 * std::cos(angle), 5.0 * std::sin(angle), 0.0)});
    return BRepPrimAPI_MakePrism(BRepBuilderAPI_MakeFace(outline).Face(), gp_Vec(0.0, 0.0, 2.0));
}

double angleInDegrees(const Vec3& a, const Vec3& b)
{
    return std::atan2(length(cross(a, b)), dot(a, b)) * 180.0 / kPi;
}

/// A ball with a pocket that has a corner beside one of the sphere's grid of first points.
TopoDS_Shape ballWithPocket(double beside)
{
    return BRepAlgoAPI_Cut(BRepPrimAPI_MakeSphere(10.0).Shape(),
                           BRepPrimAPI_MakeBox(gp_Pnt(beside, 5.0, -beside), 6.0, 10.0, 6.0).Shape());
}

/// A fan whose apex is a line of 2e-4 that runs the other way than its rim, as fillets of files have them.
TopoDS_Shape fanFromAnInvertedPole()
{
    constexpr double kExtent = 1e-4;
    TColgp_Array2OfPnt poles(1, 3, 1, 2);
    for (int i = -1; i <= 1; ++i) {
        poles.SetValue(i + 2, 1, gp_Pnt(-kExtent * i, 0.0, 0.0));
        poles.SetValue(i + 2, 2, gp_Pnt(i, 2.0, i == 0 ? 0.5 : 0.0));
    }
    TColStd_Array1OfReal knotsU(1, 2), knotsV(1, 2);
    TColStd_Array1OfInteger timesU(1, 2), timesV(1, 2);
    for (int i = 1; i <= 2; ++i) {
        knotsU.SetValue(i, i - 1.0);
        knotsV.SetValue(i, i - 1.0);
        timesU.SetValue(i, 3);
        timesV.SetValue(i, 2);
    }
    const Handle(Geom_BSplineSurface) surface =
        new Geom_BSplineSurface(poles, knotsU, knotsV, timesU, timesV, 2, 1);
    return BRepBuilderAPI_MakeFace(surface, 1e-3);
}

/// A box with another in its side, rounded below and along the concave edge between them, as far as the corner where the rounding
/// would go on upwards: there the patch that joins both runs out to nothing, in the plane of the side.
TopoDS_Shape roundedShelf()
{
    constexpr double kRadius = 0.5633494;
    const TopoDS_Shape shape =
        BRepAlgoAPI_Fuse(BRepPrimAPI_MakeBox(8.5, 8.0, 5.5).Shape(),
                         BRepPrimAPI_MakeBox(gp_Pnt(5.5, 1.5, 4.0), gp_Pnt(10.0, 5.5, 8.5)).Shape());
    const std::array<gp_Pnt, 3> middles = {gp_Pnt(9.25, 1.5, 4.0), gp_Pnt(8.5, 3.5, 4.0),
                                           gp_Pnt(9.25, 5.5, 4.0)};
    TopTools_IndexedMapOfShape edges;
    TopExp::MapShapes(shape, TopAbs_EDGE, edges);
    BRepFilletAPI_MakeFillet fillet(shape);
    for (int i = 1; i <= edges.Extent(); ++i) {
        const BRepAdaptor_Curve curve(TopoDS::Edge(edges(i)));
        const gp_Pnt middle = curve.Value(0.5 * (curve.FirstParameter() + curve.LastParameter()));
        const bool isRounded = std::any_of(middles.begin(), middles.end(), [&](const gp_Pnt& place) {
            return place.Distance(middle) < 1e-6;
        });
        if (isRounded) fillet.Add(kRadius, TopoDS::Edge(edges(i)));
    }
    return fillet.Shape();
}

std::vector<NamedShape> hardModels()
{
    const TopoDS_Shape box = BRepPrimAPI_MakeBox(gp_Pnt(-1.0, -1.0, -1.0), 2.0, 2.0, 2.0).Shape();
    const gp_Ax2 oblique(gp_Pnt(0.0, 0.0, -3.0), gp_Dir(0.3, 0.2, 1.0));
    return {{"loft", loft()},
            {"thin ring", thinRing()},
            {"lens", lens()},
            {"hole at the rim", diskWithHoleAtRim()},
            {"wedge of 3 degrees", wedge(3.0)},
            {"wedge of 40 degrees", wedge(40.0)},
            {"ball in a box", BRepAlgoAPI_Common(box, BRepPrimAPI_MakeSphere(1.2).Shape())},
            {"box less a ball", BRepAlgoAPI_Cut(box, BRepPrimAPI_MakeSphere(1.2).Shape())},
            {"box drilled askew", BRepAlgoAPI_Cut(box, BRepPrimAPI_MakeCylinder(oblique, 0.5, 6.0).Shape())},
            {"two cylinders",
             BRepAlgoAPI_Common(
                 BRepPrimAPI_MakeCylinder(1.0, 3.0).Shape(),
                 BRepPrimAPI_MakeCylinder(gp_Ax2(gp_Pnt(-2.0, 0.0, 1.5), gp_Dir(1.0, 0.0, 0.0)), 0.8, 4.0)
                     .Shape())},
            {"torus less a box", BRepAlgoAPI_Cut(BRepPrimAPI_MakeTorus(3.0, 1.0).Shape(), box)},
            {"cone less a cylinder",
             BRepAlgoAPI_Cut(
                 BRepPrimAPI_MakeCone(2.0, 0.0, 4.0).Shape(),
                 BRepPrimAPI_MakeCylinder(gp_Ax2(gp_Pnt(1.0, 0.0, 0.0), gp_Dir(0.0, 0.0, 1.0)), 0.3, 5.0)
                     .Shape())}};
}

std::vector<NamedShape> splineModels()
{
    std::vector<NamedShape> models;
    for (const NamedShape& named : test::kernelModels()) {
        models.emplace_back("splines of " + named.first, BRepBuilderAPI_NurbsConvert(named.second).Shape());
    }
    return models;
}

void expectSound(const NamedShape& named, const CurveChainOptions& options)
{
    SCOPED_TRACE(named.first);
    auto read = readModelFromShape(named.second);
    ASSERT_TRUE(read) << describe(read.error());
    SampledModel sampled;
    test::sampleInto(sampled, std::move(read->model), options);
    EXPECT_EQ(checkSurfaceMesh(sampled.model, sampled.mesh).problem(), "");
}

TEST(OcctSurfaces, AreMeshedSoundly)
{
    for (const NamedShape& named : test::kernelModels()) expectSound(named, {});
    for (const NamedShape& named : hardModels()) expectSound(named, {});
}

TEST(OcctSurfaces, AreMeshedSoundlyAsSplines)
{
    for (const NamedShape& named : splineModels()) expectSound(named, {});
}

TEST(OcctSurfaces, AreMeshedSoundlyBetweenFineCurves)
{
    const UniformSize size(0.07);
    CurveChainOptions options;
    options.sizes = &size;
    for (const NamedShape& named : test::kernelModels()) expectSound(named, options);
    for (const NamedShape& named : hardModels()) expectSound(named, options);
}

TEST(OcctSurfaces, PutNoPointBesideACornerOfTheOutline)
{
    const UniformSize size(1.0);
    CurveChainOptions options;
    options.sizes = &size;
    for (const double beside : {0.0, 1e-15, 3e-15, 1e-14})
        expectSound({"pocket", ballWithPocket(beside)}, options);
}

TEST(OcctSurfaces, TakeNoNormalFromAPoleOfSomeExtent)
{
    auto read = readModelFromShape(fanFromAnInvertedPole());
    ASSERT_TRUE(read) << describe(read.error());
    const UniformSize size(0.1);
    SurfaceSamplingOptions options;
    options.curves.sizes = options.facets.sizes = &size;
    RunContext context;
    const auto sample = sampleSurface(read->model, options, context);
    ASSERT_TRUE(sample) << describe(sample.error());
    EXPECT_TRUE(sample->failures.empty());
    EXPECT_EQ(sample->counts.refinement.leftForResolution, 0u);
    double least = 180.0;
    for (const SurfaceFacet& facet : sample->surface->mesh().facets) {
        if (!facet.isAlive()) continue;
        const auto at = [&](std::size_t i) {
            return sample->surface->mesh().nodes[facet.node[i % 3]].position;
        };
        for (std::size_t i = 0; i < 3; ++i)
            least = std::min(least, angleInDegrees(at(i + 1) - at(i), at(i + 2) - at(i)));
    }
    EXPECT_GT(least, 20.0);
}

/// Facets at the tip.
struct TipFacts
{
    int facets = 0;
    double unevenness = 0.0;  ///< of the distances of the ring's points, relative
};

TipFacts factsAtTip(const SurfaceMesh& mesh, const Vec3& tip)
{
    TipFacts facts;
    double least = std::numeric_limits<double>::infinity(), most = 0.0;
    for (const SurfaceFacet& facet : mesh.facets) {
        if (!facet.isAlive()) continue;
        const auto at = [&](std::size_t i) { return mesh.nodes[facet.node[i % 3]].position; };
        for (std::size_t i = 0; i < 3; ++i) {
            if (length(at(i) - tip) > 1e-9) continue;
            ++facts.facets;
            for (const std::size_t k : {i + 1, i + 2}) {
                least = std::min(least, length(at(k) - tip));
                most = std::max(most, length(at(k) - tip));
            }
        }
    }
    facts.unevenness = most / least - 1.0;
    return facts;
}

TEST(OcctSurfaces, HaveOneFanAtATip)
{
    const UniformSize size(0.6);
    SurfaceSamplingOptions options;
    options.curves.sizes = options.facets.sizes = &size;
    options.curves.segmentsPerTurn = options.facets.elementsPerTurn = 12.0;
    for (const double halfAngle : {10.0, 30.0, 60.0}) {
        const double height = 3.0 / std::tan(halfAngle * kPi / 180.0);
        for (const TopoDS_Shape& shape :
             {TopoDS_Shape(BRepPrimAPI_MakeCone(3.0, 0.0, height).Shape()),
              TopoDS_Shape(
                  BRepBuilderAPI_NurbsConvert(BRepPrimAPI_MakeCone(3.0, 0.0, height).Shape()).Shape())}) {
            SCOPED_TRACE(halfAngle);
            auto read = readModelFromShape(shape);
            ASSERT_TRUE(read) << describe(read.error());
            RunContext context;
            const auto sample = sampleSurface(read->model, options, context);
            ASSERT_TRUE(sample) << describe(sample.error());
            EXPECT_TRUE(sample->failures.empty());
            EXPECT_EQ(checkSurfaceMesh(read->model, sample->surface->mesh()).problem(), "");
            const TipFacts facts = factsAtTip(sample->surface->mesh(), {0.0, 0.0, height});
            EXPECT_GE(facts.facets, 4);
            EXPECT_LE(facts.facets, 9);
            EXPECT_LT(facts.unevenness, 1e-9);
            EXPECT_EQ(sample->counts.openTips, 0u);
        }
    }
}

TEST(OcctSurfaces, CountTheTipsWithoutRoomForARing)
{
    const TopoDS_Shape hole =
        BRepPrimAPI_MakeCylinder(gp_Ax2(gp_Pnt(0.53, 0.0, -1.0), gp_Dir(0.0, 0.0, 1.0)), 0.5, 10.0).Shape();
    auto read =
        readModelFromShape(BRepAlgoAPI_Cut(BRepPrimAPI_MakeCone(5.0, 0.0, 2.0).Shape(), hole).Shape());
    ASSERT_TRUE(read) << describe(read.error());
    RunContext context;
    const auto sample = sampleSurface(read->model, {}, context);
    ASSERT_TRUE(sample) << describe(sample.error());
    EXPECT_TRUE(sample->failures.empty());
    EXPECT_EQ(sample->counts.openTips, 1u);
}

TEST(OcctSurfaces, StepOverWhatIsNarrowerThanTheTolerance)
{
    auto read = readModelFromShape(roundedShelf());
    ASSERT_TRUE(read) << describe(read.error());
    const UniformSize size(1.0);
    SurfaceSamplingOptions options;
    options.curves.sizes = options.facets.sizes = &size;
    RunContext context;
    const auto sample = sampleSurface(read->model, options, context);
    ASSERT_TRUE(sample) << describe(sample.error());
    for (const auto& [face, error] : sample->failures) ADD_FAILURE() << describe(error);
    for (const FaceCheck& face : checkSurfaceMesh(read->model, sample->surface->mesh()).faces)
        EXPECT_NEAR(face.area, face.exactArea, 0.05 * face.exactArea);
}

TEST(OcctSurfaces, SplitCurvesThatAreCoarseBesideAThinFace)
{
    auto read = readModelFromShape(thinRing());
    ASSERT_TRUE(read);
    SampledModel sampled;
    test::sampleInto(sampled, std::move(read->model));
    EXPECT_GT(sampled.initial.segmentSplits, 16u);
    const double exact = kPi * (100.0 - 96.04) * 0.2;
    EXPECT_NEAR(checkSurfaceMesh(sampled.model, sampled.mesh).volumes[BrepSolidId(0)], exact, 0.4 * exact);
}

TEST(OcctSurfaces, HaveTheAreaOfNarrowFillets)
{
    // Eight segments of the rim have a sag of three widths of the fillet.
    auto read = readModelFromShape(roundedCylinder());
    ASSERT_TRUE(read);
    SampledModel sampled;
    test::sampleInto(sampled, std::move(read->model));
    for (const FaceCheck& face : checkSurfaceMesh(sampled.model, sampled.mesh).faces) {
        EXPECT_NEAR(face.area, face.exactArea, 0.2 * face.exactArea);
    }
}

TEST(OcctSurfaces, DoNotShareEdgesInsideOfFaces)
{
    auto read = readModelFromShape(lens());
    ASSERT_TRUE(read);
    SampledModel sampled;
    test::sampleInto(sampled, std::move(read->model));
    ASSERT_EQ(sampled.model.faces.size(), 2u);
    const double height = 2.0 - std::hypot(1.379, 1.379);
    const double exact = 2.0 * kPi * height * height * (6.0 - height) / 3.0;
    // Both caps on the same triangles would enclose nothing.
    EXPECT_GT(checkSurfaceMesh(sampled.model, sampled.mesh).volumes[BrepSolidId(0)], 0.1 * exact);
}

TEST(OcctSurfaces, EndFineCurvesInAPole)
{
    const TopoDS_Shape cap = BRepPrimAPI_MakeSphere(300.0, 0.474 * kPi, 0.5 * kPi).Shape();
    for (const double size : {3.0, 0.7}) {
        const UniformSize field(size);
        CurveChainOptions options;
        options.sizes = &field;
        expectSound({"flat cap", cap}, options);
        expectSound({"flat cap of splines", BRepBuilderAPI_NurbsConvert(cap).Shape()}, options);
    }
}

TEST(OcctSurfaces, KeepsAHoleInsideOfTheRim)
{
    auto read = readModelFromShape(diskWithHoleAtRim());
    ASSERT_TRUE(read);
    SampledModel sampled;
    test::sampleInto(sampled, std::move(read->model));
    EXPECT_GT(sampled.initial.segmentSplits, 0u);
    const double exact = kPi * (100.0 - 0.04);
    EXPECT_NEAR(checkSurfaceMesh(sampled.model, sampled.mesh).volumes[BrepSolidId(0)], exact, 0.12 * exact);
}

/// A tapered wing with a round nose a hundred times narrower than it is long, and a sharp trailing edge.
TopoDS_Shape wing()
{
    const auto section = [](double chord, double x, double y) {
        constexpr int kPoints = 16;
        TColgp_Array1OfPnt upper(1, kPoints), lower(1, kPoints);
        for (int i = 0; i < kPoints; ++i) {
            const double s = 0.5 * (1.0 - std::cos(kPi * i / (kPoints - 1.0)));
            const double height = 0.13 * (std::sqrt(s) - s) * chord;
            upper.SetValue(i + 1, gp_Pnt(x + s * chord, y, height));
            lower.SetValue(i + 1, gp_Pnt(x + s * chord, y, -height));
        }
        BRepBuilderAPI_MakeWire wire(
            BRepBuilderAPI_MakeEdge(Handle(Geom_Curve)(GeomAPI_PointsToBSpline(upper).Curve())).Edge());
        const TopoDS_Edge above = wire.Edge();
        wire.Add(BRepBuilderAPI_MakeEdge(Handle(Geom_Curve)(GeomAPI_PointsToBSpline(lower).Curve()),
                                         TopExp::FirstVertex(above), TopExp::LastVertex(above))
                     .Edge());
        return wire.Wire();
    };
    BRepOffsetAPI_ThruSections sections(true, true);
    sections.AddWire(section(300.0, 0.0, 0.0));
    sections.AddWire(section(150.0, 200.0, 500.0));
    sections.CheckCompatibility(false);
    return sections.Shape();
}

TEST(OcctSurfaces, AreRefinedWithoutFoldsAlongASharpNose)
{
    const auto read = readModelFromShape(wing());
    ASSERT_TRUE(read) << describe(read.error());
    SurfaceSamplingOptions options;
    options.facets.maxSize = 80.0;
    options.facets.elementsPerTurn = 12.0;
    options.curves.segmentsPerTurn = 12.0;
    RunContext context;
    const auto sample = sampleSurface(read->model, options, context);
    ASSERT_TRUE(sample) << describe(sample.error());
    EXPECT_EQ(sample->stopReason, StopReason::Done);
    EXPECT_EQ(sample->counts.certificate.found, 0u);
    EXPECT_EQ(checkSurfaceMesh(read->model, sample->surface->mesh()).problem(), "");
}

TEST(OcctSurfaces, AreMeshedSoundlyOnNarrowFillets)
{
    expectSound({"rounded cylinder", roundedCylinder()}, {});
}

/// Half a turn of a disk of radius 1 about an axis at this distance from its centre.
TopoDS_Shape revolvedDisk(double distance)
{
    const gp_Circ circle(gp_Ax2(gp_Pnt(distance, 0.0, 0.0), gp_Dir(0.0, 1.0, 0.0), gp_Dir(1.0, 0.0, 0.0)),
                         1.0);
    const TopoDS_Wire wire = BRepBuilderAPI_MakeWire(BRepBuilderAPI_MakeEdge(circle).Edge());
    const gp_Ax1 axis(gp_Pnt(0.0, 0.0, 0.0), gp_Dir(0.0, 0.0, 1.0));
    return BRepPrimAPI_MakeRevol(BRepBuilderAPI_MakeFace(wire).Face(), axis, kPi);
}

TEST(OcctSurfaces, ThatMeetThemselvesOnTheirAxisAreRefused)
{
    for (const double distance : {1.0, 1.5}) {
        const auto read = readModelFromShape(revolvedDisk(distance));
        ASSERT_TRUE(read) << describe(read.error());
        RunContext context;
        const auto sample = sampleSurface(read->model, {}, context);
        ASSERT_TRUE(sample) << describe(sample.error());
        if (distance > 1.0) {
            EXPECT_TRUE(sample->failures.empty());
            continue;
        }
        ASSERT_EQ(sample->failures.size(), 1u);
        const Error& error = sample->failures.front().second;
        EXPECT_NE(error.message.find("meets itself"), std::string::npos) << describe(error);
        ASSERT_TRUE(error.point);
        EXPECT_NEAR(length(*error.point), 0.0, 1e-6);
    }
}

}  // namespace
}  // namespace mesher
