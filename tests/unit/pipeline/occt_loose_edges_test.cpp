#include "brep/occt/read_model.h"
#include "pipeline/mesh_model.h"

#include <BRepAlgoAPI_Cut.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <Geom_Circle.hxx>
#include <Geom_Curve.hxx>
#include <TopExp.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Vertex.hxx>

#include <gtest/gtest.h>

namespace mesher::test {
namespace {

/// A plate with a hole that leaves a web to its side narrower than the tolerance by which its edges are off.
TopoDS_Shape plateWithWeb(double web, double tolerance)
{
    const gp_Ax2 axis(gp_Pnt(12.0, 3.0 + web, -1.0), gp_Dir(0.0, 0.0, 1.0));
    const TopoDS_Shape plate = BRepAlgoAPI_Cut(BRepPrimAPI_MakeBox(20.0, 12.0, 4.0).Shape(),
                                               BRepPrimAPI_MakeCylinder(axis, 3.0, 6.0).Shape())
                                   .Shape();
    TopTools_IndexedMapOfShape edges;
    TopExp::MapShapes(plate, TopAbs_EDGE, edges);
    const BRep_Builder builder;
    for (int i = 1; i <= edges.Extent(); ++i) {
        const TopoDS_Edge& edge = TopoDS::Edge(edges(i));
        TopLoc_Location location;
        double first = 0.0, last = 0.0;
        const Handle(Geom_Curve) curve = BRep_Tool::Curve(edge, location, first, last);
        // The rim of the hole and the side of the plate change places.
        const bool isRim = curve->DynamicType() == STANDARD_TYPE(Geom_Circle);
        const gp_Vec by(0.3 * tolerance, (isRim ? -0.8 : 0.8) * tolerance, 0.2 * tolerance);
        builder.UpdateEdge(edge, Handle(Geom_Curve)::DownCast(curve->Translated(by)), location, tolerance);
        for (const TopoDS_Vertex& end : {TopExp::FirstVertex(edge), TopExp::LastVertex(edge)})
            builder.UpdateVertex(end, tolerance);
    }
    return plate;
}

TEST(LooseEdges, AreMeshedAlsoWhereLoopsAreCloserThanTheirTolerance)
{
    for (const double web : {0.01, 0.03}) {
        SCOPED_TRACE(web);
        const auto read = readModelFromShape(plateWithWeb(web, 0.02));
        ASSERT_TRUE(read) << describe(read.error());
        MeshOptions options;
        options.size = 3.0;
        options.isChecked = true;
        RunContext context;
        const MeshOutcome outcome = meshModel(read->model, options, nullptr, 2, context);
        for (const Error& error : outcome.report.failures) ADD_FAILURE() << describe(error);
        EXPECT_EQ(outcome.report.status, MeshReport::Status::Done);
    }
}

}  // namespace
}  // namespace mesher::test
