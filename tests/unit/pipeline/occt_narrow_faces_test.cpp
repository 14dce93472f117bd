#include "brep/occt/model_builder.h"
#include "pipeline/mesh_solids.h"
#include "quality/tet_measures.h"

#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakePolygon.hxx>
#include <BRepPrimAPI_MakePrism.hxx>

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <string>
#include <utility>

namespace mesher {
namespace {

/// A bar whose top has two chamfers that are far smaller than the size.
BrepModel chamferedBar()
{
    constexpr double kChamfer = 0.01;
    BRepBuilderAPI_MakePolygon outline;
    for (const auto& [x, y] : {std::pair{0.0, 0.0},
                               {3.0, 0.0},
                               {3.0, 2.0 - kChamfer},
                               {3.0 - kChamfer, 2.0},
                               {kChamfer, 2.0},
                               {0.0, 2.0 - kChamfer}})
        outline.Add(gp_Pnt(x, y, 0.0));
    outline.Close();
    return *buildModel(
        BRepPrimAPI_MakePrism(BRepBuilderAPI_MakeFace(outline.Wire()).Face(), gp_Vec(0.0, 0.0, 9.0)).Shape());
}

MeshOutcome meshBar(MeshOptions options)
{
    options.size = 0.8;
    options.isImproved = false;
    RunContext context;
    MeshOutcome outcome = meshSolids(chamferedBar(), options, nullptr, context);
    for (const Error& error : outcome.report.failures) ADD_FAILURE() << describe(error);
    return outcome;
}

std::uint64_t warningsOfStrips(const MeshReport& report)
{
    return static_cast<std::uint64_t>(
        std::count_if(report.warnings.begin(), report.warnings.end(), [](const std::string& warning) {
            return warning.find("wide, is left with flat triangles") != std::string::npos &&
                   warning.find("--max-wall-elements") != std::string::npos;
        }));
}

std::uint64_t badTets(const ClassifiedMesh& mesh)
{
    std::uint64_t bad = 0;
    for (const auto& tet : mesh.tets) {
        TetCorners corner;
        for (std::size_t i = 0; i < 4; ++i) corner[i] = mesh.nodes[tet.node[i]].position;
        const auto angles = dihedralAngles(corner);
        const auto [least, most] = std::minmax_element(angles.begin(), angles.end());
        bad += *least < 18.0 || *most > 155.5 ? 1u : 0u;
    }
    return bad;
}

TEST(NarrowFaces, AreKeptFlatAndToldWhereGoodOnesWouldTakeTooMany)
{
    const MeshOutcome outcome = meshBar({});
    ASSERT_TRUE(outcome.mesh);
    EXPECT_LT(outcome.mesh->tets.size(), 10'000u);
    EXPECT_EQ(warningsOfStrips(outcome.report), 2u);
    std::uint64_t told = 0;
    for (const LeftElements& left : outcome.report.left) told += left.dimension == 3 ? left.count : 0;
    const std::uint64_t bad = badTets(*outcome.mesh);
    EXPECT_GT(bad, 0u);
    EXPECT_LT(bad, outcome.mesh->tets.size() / 10);
    EXPECT_GE(told, bad);
}

TEST(NarrowFaces, AreMadeGoodOnAWish)
{
    MeshOptions options;
    options.maxWallElements = 1'000'000;
    const MeshOutcome outcome = meshBar(options);
    ASSERT_TRUE(outcome.mesh && outcome.report.tetQuality);
    EXPECT_EQ(warningsOfStrips(outcome.report), 0u);
    EXPECT_GT(outcome.mesh->tets.size(), 100'000u);
    EXPECT_GE(outcome.report.tetQuality->dihedral.least(), 18.0);
    EXPECT_LE(outcome.report.tetQuality->dihedral.largest(), 155.1);
}

}  // namespace
}  // namespace mesher
