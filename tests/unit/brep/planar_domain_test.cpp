#include "brep/planar_domain.h"

#include "brep/analytic/solids.h"
#include "brep/occt/read_model.h"
#include "brep/planarity.h"
#include "occt_models.h"

#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakeWire.hxx>
#include <BRep_Builder.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Compound.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Vertex.hxx>
#include <gp_Ax2.hxx>
#include <gp_Circ.hxx>

#include <gtest/gtest.h>

#include <numbers>

namespace mesher {

namespace {

using FaceIds = std::vector<BrepFaceId>;

const BrepFaceId kFirst(0u);

BrepModel modelOf(const TopoDS_Shape& shape) { return readModelFromShape(shape).value().model; }

Result<PlanarCurveComplex> domainOf(const TopoDS_Shape& shape, const FaceIds& faces = {kFirst})
{
    const Result<ReadModel> read = readModelFromShape(shape);
    if (!read) return read.error();
    return planarCurveComplex(read->model, faces);
}

TopoDS_Wire circle(double x, double radius)
{
    const gp_Circ geometry(gp_Ax2(gp_Pnt(x, 0.0, 0.0), gp_Dir(0.0, 0.0, 1.0)), radius);
    return BRepBuilderAPI_MakeWire(BRepBuilderAPI_MakeEdge(geometry));
}

/// Signed area to the left of the curves of a region, by many chords.
double areaOf(const PlanarCurveComplex& complex, RegionId region)
{
    constexpr int kChords = 20000;
    double area = 0.0;
    for (const PccCurve& curve : complex.curves) {
        const double sign = (curve.left == region ? 1.0 : 0.0) - (curve.right == region ? 1.0 : 0.0);
        for (int i = 0; i < kChords && sign != 0.0; ++i) {
            const Vec2 a =
                complex.frame.toPlane(curve.curve->position(curve.part.at(static_cast<double>(i) / kChords)));
            const Vec2 b = complex.frame.toPlane(curve.curve->position(curve.part.at((i + 1.0) / kChords)));
            area += 0.5 * sign * cross(a, b);
        }
    }
    return area;
}

void expectError(const Result<PlanarCurveComplex>& result, const std::string& entity,
                 const std::string& message)
{
    ASSERT_FALSE(result);
    EXPECT_NE(result.error().entity.find(entity), std::string::npos) << describe(result.error());
    EXPECT_NE(result.error().message.find(message), std::string::npos) << describe(result.error());
    EXPECT_FALSE(result.error().remedy.empty());
}

}  // namespace

TEST(PlanarDomain, AnnulusHasOneRegionBetweenTwoCircles)
{
    BRepBuilderAPI_MakeFace face(circle(0.0, 2.0));
    face.Add(TopoDS::Wire(circle(0.5, 1.0).Reversed()));
    const auto domain = domainOf(face.Face());
    ASSERT_TRUE(domain) << describe(domain.error());
    EXPECT_EQ(domain->curves.size(), 2u);
    EXPECT_EQ(domain->points.size(), 2u);
    EXPECT_EQ(domain->regionNames, std::vector<std::string>{"Face1"});
    EXPECT_NEAR(areaOf(*domain, RegionId(1u)), 3.0 * std::numbers::pi, 1e-6);
    EXPECT_NEAR(areaOf(*domain, RegionId(0u)), -3.0 * std::numbers::pi, 1e-6);
}

TEST(PlanarDomain, TheFrameAndAreaOfEveryFaceOfTheKernelsSolidsAreRight)
{
    for (const TopoDS_Shape& shape : {test::drilledPlate(), test::gluedBoxes()}) {
        const BrepModel model = modelOf(shape);
        for (std::uint32_t f = 0; f < model.faces.size(); ++f) {
            if (!model.faces[BrepFaceId(f)].surface->planeFrame()) continue;
            const auto domain = planarCurveComplex(model, FaceIds{BrepFaceId(f)});
            ASSERT_TRUE(domain) << describe(domain.error());
            EXPECT_GT(areaOf(*domain, RegionId(1u)), 0.1);
            for (const PccPoint& point : domain->points) {
                EXPECT_EQ(point.spacePosition, model.vertices[point.vertex].position);
                EXPECT_LT(length(domain->frame.toSpace(point.position) - point.spacePosition), 1e-12);
            }
        }
    }
}

TEST(PlanarDomain, FacesShareTheirEdge)
{
    const BrepModel model = modelOf(test::gluedBoxes());
    FaceIds top;
    for (std::uint32_t f = 0; f < model.faces.size(); ++f) {
        const BrepFace& face = model.faces[BrepFaceId(f)];
        const Vec3 p = face.surface->position({face.boundsU.at(0.5), face.boundsV.at(0.5)});
        if (p.z == 1.0) top.push_back(BrepFaceId(f));
    }
    ASSERT_EQ(top.size(), 2u);
    const auto domain = planarCurveComplex(model, top);
    ASSERT_TRUE(domain) << describe(domain.error());
    EXPECT_EQ(domain->curves.size(), 7u);
    EXPECT_EQ(domain->points.size(), 6u);
    EXPECT_NEAR(areaOf(*domain, RegionId(1u)) + areaOf(*domain, RegionId(2u)), 3.0, 1e-9);
    EXPECT_NEAR(std::min(areaOf(*domain, RegionId(1u)), areaOf(*domain, RegionId(2u))), 1.0, 1e-9);
    const auto shared = [](const PccCurve& c) { return c.left != RegionId(0u) && c.right != RegionId(0u); };
    EXPECT_EQ(std::count_if(domain->curves.begin(), domain->curves.end(), shared), 1);
}

TEST(PlanarDomain, EmbeddedEdgesAndVerticesBelongToTheirFace)
{
    TopoDS_Face face = test::rawFace(test::polygon({{0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {0, 4, 0}}));
    const BRep_Builder builder;
    TopoDS_Wire slit;
    builder.MakeWire(slit);
    builder.Add(slit,
                BRepBuilderAPI_MakeEdge(gp_Pnt(1, 1, 0), gp_Pnt(3, 1, 0)).Edge().Oriented(TopAbs_INTERNAL));
    builder.Add(face, slit);
    TopoDS_Vertex point;
    builder.MakeVertex(point, gp_Pnt(2, 3, 0), 1e-7);
    builder.Add(face, point.Oriented(TopAbs_INTERNAL));
    const auto domain = domainOf(face);
    ASSERT_TRUE(domain) << describe(domain.error());
    EXPECT_EQ(domain->curves.size(), 5u);
    const auto isInside = [](const PccCurve& c) { return c.left == RegionId(1u) && c.right == RegionId(1u); };
    EXPECT_EQ(std::count_if(domain->curves.begin(), domain->curves.end(), isInside), 1);
    ASSERT_EQ(domain->embeddedPoints.size(), 1u);
    EXPECT_EQ(domain->points[domain->embeddedPoints[0].point.value].spacePosition, (Vec3{2.0, 3.0, 0.0}));
    EXPECT_EQ(domain->embeddedPoints[0].region, RegionId(1u));
}

TEST(PlanarDomain, CurvedFacesAreRefusedWithTheirDistance)
{
    const BrepModel cylinder = makeCylinder({}, 2.0, 3.0).value();
    expectError(planarCurveComplex(cylinder, FaceIds{kFirst}), "Face1", "not plane");
    EXPECT_TRUE(planarCurveComplex(cylinder, FaceIds{BrepFaceId(1u)}));
    EXPECT_FALSE(planarCurveComplex(cylinder, FaceIds{}));
    expectError(planarCurveComplex(cylinder, FaceIds{BrepFaceId(7u)}), "Face8", "no such face");
    expectError(planarCurveComplex(cylinder, FaceIds{BrepFaceId(1u), BrepFaceId(1u)}), "Face2", "twice");
    expectError(planarCurveComplex(cylinder, FaceIds{BrepFaceId(1u), BrepFaceId(2u)}), "Face3",
                "another plane than Face2: its boundary is up to 3 off that");
    const BrepModel box = makeBox({0.0, 0.0, 0.0}, {1.0, 2.0, 3.0}).value();
    for (std::uint32_t f = 1; f < 6; ++f) {
        expectError(planarCurveComplex(box, FaceIds{kFirst, BrepFaceId(f)}), "Face" + std::to_string(f + 1),
                    "another plane than Face1");
    }
}

TEST(Planarity, TellsFacesOfOnePlaneFromOthers)
{
    const BrepModel cylinder = makeCylinder({}, 2.0, 3.0).value();
    const BrepFaceId wall(0u), bottom(1u), top(2u);
    EXPECT_FALSE(lieInOnePlane(cylinder, FaceIds{wall}));
    EXPECT_TRUE(lieInOnePlane(cylinder, FaceIds{top}));
    EXPECT_FALSE(lieInOnePlane(cylinder, FaceIds{bottom, top})) << "parallel, one above the other";
    EXPECT_FALSE(lieInOnePlane(cylinder, FaceIds{bottom, wall}));
    BrepModel beside = cylinder;
    beside.faces.push_back(makeBox({5.0, 0.0, 0.0}, {6.0, 2.0, 3.0}).value().faces[BrepFaceId(4u)]);
    for (BrepLoop& loop : beside.faces[BrepFaceId(3u)].loops) loop.coedges.clear();
    EXPECT_TRUE(lieInOnePlane(beside, FaceIds{bottom, BrepFaceId(3u)}));
}

TEST(PlanarDomain, OpenNullAndFlatWiresAreRefused)
{
    expectError(domainOf(test::rawFace(test::polygon({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}}, false))), "Face1",
                "open between");
    expectError(domainOf(test::rawFace(test::polygon({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}}))), "Face1",
                "no area");
    expectError(domainOf(test::rawFace(test::polygon({{0, 0, 0}, {0, 1, 0}, {1, 1, 0}, {1, 0, 0}}))), "Face1",
                "wrong way");
    TopoDS_Wire nothing;
    BRep_Builder().MakeWire(nothing);
    EXPECT_FALSE(domainOf(test::rawFace(nothing)));
}

TEST(PlanarDomain, CrossingEdgesAreNamedWithThePoint)
{
    // A bow tie whose left half is the larger one, so that its area does not vanish.
    const auto bowTie = domainOf(
        test::rawFace(test::polygon({{0, 0, 0}, {4, 4, 0}, {4, 3, 0}, {0, 3.5, 0}, {0, 2, 0}, {3, 0, 0}})));
    expectError(bowTie, "Edge", "");
    BRepBuilderAPI_MakeFace pierced(circle(0.0, 2.0));
    pierced.Add(TopoDS::Wire(circle(1.5, 1.0).Reversed()));
    const auto holes = domainOf(pierced.Face());
    expectError(holes, "Edge1 and Edge2", "away from a common vertex");
    EXPECT_EQ(holes.error().code, ErrorCode::IntersectingConstraints);
    EXPECT_NEAR(length(*holes.error().point), 2.0, 1e-6);
    EXPECT_NEAR(length(*holes.error().point - Vec3{1.5, 0.0, 0.0}), 1.0, 1e-6);
}

TEST(PlanarDomain, NearCurvesAreToldFromTouchingOnes)
{
    const auto withHole = [](double x, double radius) {
        BRepBuilderAPI_MakeFace face(circle(0.0, 2.0));
        face.Add(TopoDS::Wire(circle(x, radius).Reversed()));
        return domainOf(face.Face());
    };
    EXPECT_TRUE(withHole(1.0, 1.0 - 1e-4));
    EXPECT_TRUE(withHole(0.0, 2.0 - 1e-4));
    EXPECT_FALSE(withHole(1.0, 1.0));
    EXPECT_FALSE(withHole(0.0, 2.0 + 1e-9));
}

TEST(PlanarDomain, CurvesTangentInACommonVertexAreNoCrossing)
{
    // Two circles that touch from inside in the vertex they share.
    const gp_Ax2 axis(gp_Pnt(-2.0, 0.0, 0.0), gp_Dir(0.0, 0.0, 1.0));
    const gp_Ax2 inner(gp_Pnt(-1.0, 0.0, 0.0), gp_Dir(0.0, 0.0, 1.0));
    const BRep_Builder builder;
    TopoDS_Vertex common;
    builder.MakeVertex(common, gp_Pnt(0.0, 0.0, 0.0), 1e-7);
    const TopoDS_Wire outside =
        BRepBuilderAPI_MakeWire(BRepBuilderAPI_MakeEdge(gp_Circ(axis, 2.0), common, common));
    const TopoDS_Wire inside =
        BRepBuilderAPI_MakeWire(BRepBuilderAPI_MakeEdge(gp_Circ(inner, 1.0), common, common));
    BRepBuilderAPI_MakeFace face(outside);
    face.Add(TopoDS::Wire(inside.Reversed()));
    const auto domain = domainOf(face.Face());
    ASSERT_TRUE(domain) << describe(domain.error());
    EXPECT_EQ(domain->points.size(), 1u);
}

}  // namespace mesher
