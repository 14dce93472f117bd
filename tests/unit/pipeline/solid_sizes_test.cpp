#include "pipeline/solid_sizes.h"

#include "brep/analytic/solids.h"
#include "pipeline/mesh_solids.h"
#include "support/model_union.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <memory>
#include <string>
#include <utility>

namespace mesher::test {
namespace {

ClassifiedMesh meshOf(const BrepModel& model, const MeshOptions& options)
{
    RunContext context;
    MeshOutcome outcome = meshSolids(model, options, nullptr, context);
    for (const Error& error : outcome.report.failures) ADD_FAILURE() << describe(error);
    return outcome.mesh.value_or(ClassifiedMesh{});
}

std::shared_ptr<const SizingField> fieldOf(const BrepModel& model, const MeshOptions& options)
{
    RunContext context;
    const auto field = solidSizes(model, options, nullptr, context);
    EXPECT_TRUE(field) << describe(field.error());
    return field ? *field : nullptr;
}

/// Of the elements whose middle is as asked.
template <class Elements>
double meanEdge(const ClassifiedMesh& mesh, const Elements& elements,
                const std::function<bool(const EntityRef&, const Vec3&)>& isAsked)
{
    double sum = 0.0;
    int count = 0;
    for (const auto& element : elements) {
        Vec3 middle;
        for (const NodeId node : element.node) {
            middle = middle + (1.0 / static_cast<double>(element.node.size())) * mesh.nodes[node].position;
        }
        if (!isAsked(element.entity, middle)) continue;
        for (std::size_t i = 0; i < element.node.size(); ++i) {
            for (std::size_t j = 0; j < i; ++j, ++count)
                sum += length(mesh.nodes[element.node[i]].position - mesh.nodes[element.node[j]].position);
        }
    }
    EXPECT_GT(count, 0);
    return count > 0 ? sum / count : 0.0;
}

MeshOptions sizeOf(const std::string& entity, double size)
{
    MeshOptions options;
    options.localSizes = {{entity, size}};
    return options;
}

/// Others make 28,342, 17,609 and 7,577 tetrahedra of these at the same number, and edges of 0.95 to 0.99 sizes on the surface.
TEST(SolidSizes, MeanTheEdgeOnSurfacesAndWhatOthersMeanInside)
{
    struct Case
    {
        BrepModel model;
        double size, tetsOfOthers;
    };
    for (const Case& c :
         {Case{*makeBox({}, {1.0, 2.0, 3.0}), 0.1, 28'342.0},
          Case{*makeCylinder({}, 5.0, 10.0), 0.6, 17'609.0}, Case{*makeSphere({}, 5.0), 0.7, 7'577.0}}) {
        MeshOptions options;
        options.size = c.size;
        const ClassifiedMesh mesh = meshOf(c.model, options);
        const auto all = [](const EntityRef&, const Vec3&) { return true; };
        EXPECT_NEAR(meanEdge(mesh, mesh.triangles, all), c.size, 0.06 * c.size);
        EXPECT_NEAR(static_cast<double>(mesh.tets.size()), c.tetsOfOthers, 0.15 * c.tetsOfOthers);
    }
}

TEST(SolidSizes, HoldOnAWholeFaceAndGrowOffIt)
{
    const BrepModel model = *makeBox({}, {8.0, 8.0, 8.0});
    MeshOptions options = sizeOf("Face6", 1.0);
    options.grading = 2.0;
    const auto field = fieldOf(model, options);
    ASSERT_TRUE(field);
    EXPECT_NEAR(field->sizeAt({4.0, 4.0, 8.0}), 1.0, 1e-9);
    EXPECT_NEAR(field->sizeAt({4.0, 4.0, 4.0}), 3.0, 1e-9);
    EXPECT_NEAR(field->smallestNear({4.0, 4.0, 4.0}, 2.0), 2.0, 1e-9);
    const ClassifiedMesh mesh = meshOf(model, options);
    const auto middleOf = [](std::uint32_t face) {
        return [face](const EntityRef& entity, const Vec3& middle) {
            return entity.index == face && std::hypot(middle.x - 4.0, middle.y - 4.0) < 2.0;
        };
    };
    EXPECT_NEAR(meanEdge(mesh, mesh.triangles, middleOf(5)), 0.9, 0.25);
    EXPECT_GT(meanEdge(mesh, mesh.triangles, middleOf(4)), 2.5);
}

TEST(SolidSizes, HoldOnClosedFaces)
{
    for (const BrepModel& model : {*makeSphere({}, 1.0), *makeTorus({}, 1.2, 0.5)}) {
        const ClassifiedMesh mesh = meshOf(model, sizeOf("Face1", 0.4));
        const auto all = [](const EntityRef&, const Vec3&) { return true; };
        EXPECT_NEAR(meanEdge(mesh, mesh.triangles, all), 0.36, 0.08);
    }
}

TEST(SolidSizes, OfOneSolidStayInside)
{
    const BrepModel model = together(*makeSphere({}, 2.0), *makeBox({10.0, 0.0, 0.0}, {16.0, 6.0, 6.0}));
    const auto inside = [](std::uint32_t solid) {
        return [solid](const EntityRef& entity, const Vec3&) { return entity.index == solid; };
    };
    const ClassifiedMesh first = meshOf(model, sizeOf("Solid1", 0.6));
    EXPECT_NEAR(meanEdge(first, first.tets, inside(0)), 0.68, 0.08);
    EXPECT_GT(meanEdge(first, first.tets, inside(1)), 2.0);
    const ClassifiedMesh second = meshOf(model, sizeOf("Solid2", 1.0));
    EXPECT_NEAR(meanEdge(second, second.tets, inside(1)), 1.2, 0.2);
    const auto field = fieldOf(model, sizeOf("Solid2", 1.0));
    ASSERT_TRUE(field);
    EXPECT_EQ(field->sizeAt({13.0, 3.0, 3.0}), 1.0);
    EXPECT_NEAR(field->sizeAt({8.0, 3.0, 3.0}), 3.0, 1e-9);
}

TEST(SolidSizes, OfTheOnlySolidHoldEverywhere)
{
    const auto field = fieldOf(*makeTorus({}, 2.0, 0.8), sizeOf("Solid1", 0.5));
    ASSERT_TRUE(field);
    EXPECT_EQ(field->sizeAt({2.0, 0.0, 0.0}), 0.5);
}

TEST(SolidSizes, ByDistanceBeginAtTheWholeFace)
{
    MeshOptions options;
    options.distanceSizes = {{"Face6", 0.5, 0.25, 1.0}};
    const auto field = fieldOf(*makeBox({}, {8.0, 8.0, 8.0}), options);
    ASSERT_TRUE(field);
    EXPECT_NEAR(field->sizeAt({4.0, 4.0, 7.0}), 0.5, 1e-9);
    EXPECT_NEAR(field->sizeAt({4.0, 4.0, 3.0}), 1.5, 1e-9);
}

TEST(SolidSizes, RefuseWhatTheModelDoesNotHave)
{
    const BrepModel model = *makeSphere({}, 1.0);
    RunContext context;
    for (const char* name : {"Face2", "Solid2", "Edge9", "Vertex7", "Lid"}) {
        const auto field = solidSizes(model, sizeOf(name, 0.1), nullptr, context);
        ASSERT_FALSE(field);
        EXPECT_EQ(field.error().entity, name);
    }
}

}  // namespace
}  // namespace mesher::test
