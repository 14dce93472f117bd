#include "brep/occt/model_builder.h"
#include "mesh/region_sides.h"
#include "sizing/uniform_size.h"
#include "surface_sampling/sample_surface.h"
#include "surface_sampling/surface_check.h"
#include "unit/brep/occt_models.h"

#include <BRepAlgoAPI_Cut.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakePolygon.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRepPrimAPI_MakePrism.hxx>
#include <gp_Ax2.hxx>

#include <gtest/gtest.h>

#include <algorithm>
#include <utility>

namespace mesher {
namespace {

constexpr double kSize = 1.5;

/// A wedge of 1.5 degrees, 30 long.
TopoDS_Shape wedge()
{
    BRepBuilderAPI_MakePolygon outline(gp_Pnt(0.0, 0.0, 0.0), gp_Pnt(30.0, 0.0, 0.0), gp_Pnt(30.0, 0.8, 0.0),
                                       Standard_True);
    return BRepPrimAPI_MakePrism(BRepBuilderAPI_MakeFace(outline.Wire()).Face(), gp_Vec(0.0, 0.0, 8.0))
        .Shape();
}

/// A plate that is thicker on one half.
TopoDS_Shape steppedPlate()
{
    BRepBuilderAPI_MakePolygon outline;
    for (const auto& [x, y] :
         {std::pair{0.0, 0.0}, {12.0, 0.0}, {12.0, 0.1}, {6.0, 0.1}, {6.0, 0.05}, {0.0, 0.05}})
        outline.Add(gp_Pnt(x, y, 0.0));
    outline.Close();
    return BRepPrimAPI_MakePrism(BRepBuilderAPI_MakeFace(outline.Wire()).Face(), gp_Vec(0.0, 0.0, 8.0))
        .Shape();
}

/// A block with a hole that comes to within 0.02 of one of its sides: two of its faces have a narrow neck there.
TopoDS_Shape blockWithNecks()
{
    const gp_Ax2 axis(gp_Pnt(6.0, 4.02, -1.0), gp_Dir(0.0, 0.0, 1.0));
    return BRepAlgoAPI_Cut(BRepPrimAPI_MakeBox(12.0, 10.0, 8.0).Shape(),
                           BRepPrimAPI_MakeCylinder(axis, 4.0, 12.0).Shape())
        .Shape();
}

SurfaceSample sampleAt(const BrepModel& model, const RegionSides& sides, double maxTets)
{
    const UniformSize size(kSize);
    SurfaceSamplingOptions options;
    options.curves.sizes = &size;
    options.facets.sizes = &size;
    options.walls.sides = &sides;
    options.walls.maxTets = maxTets;
    RunContext context;
    return std::move(*sampleSurface(model, options, context));
}

double facetsForSize(const SurfaceMesh& mesh)
{
    double area = 0.0;
    for (const SurfaceFacet& facet : mesh.facets) {
        if (!facet.isAlive()) continue;
        const Vec3& a = mesh.nodes[facet.node[0]].position;
        area += 0.5 *
                length(cross(mesh.nodes[facet.node[1]].position - a, mesh.nodes[facet.node[2]].position - a));
    }
    return area / (0.433 * kSize * kSize);
}

/// Good facets where a face is narrow are as small as it is, and so are those that grow from there into the faces beside.
void expectFacetsOfTheSize(const TopoDS_Shape& shape)
{
    const Result<BrepModel> model = buildModel(shape);
    ASSERT_TRUE(model);
    const RegionSides sides = *regionSidesOf(*model);
    const SurfaceSample flat = sampleAt(*model, sides, 2000.0);
    EXPECT_EQ(flat.stopReason, StopReason::Done);
    EXPECT_TRUE(flat.counts.certificate.errors.empty());
    EXPECT_FALSE(keptOf(flat.counts.surveyedWalls).empty());
    EXPECT_LT(static_cast<double>(flat.counts.facets), 2.5 * facetsForSize(flat.surface->mesh()));
    const SurfaceSample good = sampleAt(*model, sides, 1e7);
    EXPECT_TRUE(keptOf(good.counts.surveyedWalls).empty());
    EXPECT_EQ(good.counts.refinement.leftOnRims, 0u);
    EXPECT_GT(good.counts.facets, 2 * flat.counts.facets);
}

TEST(FlatWalls, HaveFacetsOfTheSizeInAWedge) { expectFacetsOfTheSize(wedge()); }

TEST(FlatWalls, HaveFacetsOfTheSizeWhereAHoleNearlyMeetsASide) { expectFacetsOfTheSize(blockWithNecks()); }

/// One side is that of two walls, and just one of them is kept.
TEST(FlatWalls, HaveNoFacetsOfTheWallBeside)
{
    const Result<BrepModel> model = buildModel(steppedPlate());
    ASSERT_TRUE(model);
    const RegionSides sides = *regionSidesOf(*model);
    const SurfaceSample flat = sampleAt(*model, sides, 0.0);
    const std::vector<WallSides> kept = keptOf(flat.counts.surveyedWalls);
    ASSERT_EQ(kept.size(), 2u);
    for (const WallSides& one : kept) {
        RunContext context;
        const std::vector<FlatWallFacet> facets = facetsOnWalls(*flat.surface, sides, {one}, context);
        EXPECT_FALSE(facets.empty());
        for (const FlatWallFacet& facet : facets) EXPECT_EQ(facet.sides, one);
    }
}

}  // namespace
}  // namespace mesher
