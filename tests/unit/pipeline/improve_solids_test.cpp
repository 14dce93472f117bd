#include "pipeline/improve_solids.h"

#include "brep/analytic/axes.h"
#include "brep/analytic/solids.h"
#include "mesh/classified_mesh_hash.h"
#include "pipeline/mesh_solids.h"
#include "support/model_union.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>

namespace mesher {
namespace {

MeshOutcome meshed(const BrepModel& model, double size, bool isImproved)
{
    MeshOptions options;
    options.size = size;
    options.isImproved = isImproved;
    options.isChecked = true;
    RunContext context;
    return meshSolids(model, options, nullptr, context);
}

std::uint64_t countOf(const MeshReport& report, std::string_view name)
{
    const auto found = std::find_if(report.counts.begin(), report.counts.end(),
                                    [&](const auto& count) { return count.first == name; });
    return found == report.counts.end() ? 0 : found->second;
}

TEST(ImproveSolids, IsDoneAfterRefinementUnlessSwitchedOff)
{
    const BrepModel model = makeCylinder(Axes{}, 1.0, 2.0).value();
    const MeshOutcome without = meshed(model, 0.3, false);
    const MeshOutcome with = meshed(model, 0.3, true);
    ASSERT_TRUE(without.mesh && with.mesh);
    EXPECT_FALSE(without.report.anglesBeforeImprovement);
    EXPECT_EQ(countOf(without.report, "edge_removals"), 0u);
    ASSERT_TRUE(with.report.anglesBeforeImprovement);
    EXPECT_EQ(with.report.status, MeshReport::Status::Done);
    EXPECT_NEAR(with.report.anglesBeforeImprovement->least, without.report.tetQuality->dihedral.least(),
                1e-9);
    EXPECT_NEAR(with.report.anglesBeforeImprovement->largest, without.report.tetQuality->dihedral.largest(),
                1e-9);
    EXPECT_GT(with.report.tetQuality->dihedral.least(), without.report.tetQuality->dihedral.least() + 5.0);
    EXPECT_LT(with.report.tetQuality->dihedral.largest(),
              without.report.tetQuality->dihedral.largest() - 5.0);
    EXPECT_GT(countOf(with.report, "edge_removals"), 0u);
    EXPECT_LT(countOf(with.report, "bad_tets_after_improvement"),
              countOf(with.report, "bad_tets_before_improvement"));
    const auto json = nlohmann::json::parse(toJson(with.report));
    EXPECT_DOUBLE_EQ(json["quality"]["before_improvement"]["min_dihedral"],
                     with.report.anglesBeforeImprovement->least);
    EXPECT_TRUE(json["seconds"].contains("improvement"));
    EXPECT_FALSE(nlohmann::json::parse(toJson(without.report))["quality"].contains("before_improvement"));
}

/// In a wall that is kept flat nearly all tetrahedra are bad, and none can be helped.
TEST(ImproveSolids, TellsThatItEndedBeforeAllWereTried)
{
    MeshOptions options;
    options.size = 0.4;
    options.maxWallElements = 0;
    RunContext context;
    const BrepModel shell = test::withHollow(*makeSphere({}, 3.0), *makeSphere({}, 2.97));
    const MeshOutcome flat = meshSolids(shell, options, nullptr, context);
    ASSERT_TRUE(flat.mesh);
    EXPECT_EQ(flat.report.status, MeshReport::Status::Done);
    EXPECT_EQ(countOf(flat.report, "improvement_cut_short"), 1u);
    EXPECT_GT(2 * countOf(flat.report, "bad_tets_after_improvement"), flat.mesh->tets.size());
    EXPECT_EQ(nlohmann::json::parse(toJson(flat.report))["counts"]["improvement_cut_short"], 1);
    const MeshOutcome sound = meshed(*makeBox({}, {4.0, 4.0, 4.0}), 1.0, true);
    EXPECT_EQ(countOf(sound.report, "improvement_cut_short"), 0u);
}

TEST(ImproveSolids, ComesToTheSameMeshTwice)
{
    const BrepModel model = makeTorus(Axes{}, 2.0, 0.6).value();
    EXPECT_EQ(meshed(model, 0.3, true).report.meshHash, meshed(model, 0.3, true).report.meshHash);
}

/// Two balls that overlap, one beside the other: improvement sees neither from the other.
struct OverlappingBalls
{
    BrepModel model;
    ClassifiedMesh mesh;

    void add(const Axes& axes)
    {
        const BrepModel ball = makeSphere(axes, 1.0).value();
        const MeshOutcome outcome = meshed(ball, 0.3, false);
        const std::array<std::size_t, 4> offset = {model.vertices.size(), model.edges.size(),
                                                   model.faces.size(), model.solids.size()};
        for (const BrepVertex& vertex : ball.vertices) model.vertices.push_back(vertex);
        for (const BrepEdge& edge : ball.edges) model.edges.push_back(edge);
        for (const BrepFace& face : ball.faces) model.faces.push_back(face);
        for (const BrepSolid& solid : ball.solids) model.solids.push_back(solid);
        const auto shifted = [&](EntityRef entity) {
            entity.index += static_cast<std::uint32_t>(offset[entity.dimension]);
            return entity;
        };
        const auto first = static_cast<std::uint32_t>(mesh.nodes.size());
        for (MeshNode node : outcome.mesh->nodes) {
            node.entity = shifted(node.entity);
            mesh.nodes.push_back(node);
        }
        for (auto triangle : outcome.mesh->triangles) {
            for (NodeId& n : triangle.node) n.value += first;
            mesh.triangles.push_back({triangle.node, shifted(triangle.entity)});
        }
        for (auto tet : outcome.mesh->tets) {
            for (NodeId& n : tet.node) n.value += first;
            mesh.tets.push_back({tet.node, shifted(tet.entity)});
        }
    }
};

TEST(ImproveSolids, LeavesABoundaryThatMeetsItselfAsItIs)
{
    OverlappingBalls balls;
    balls.add(Axes{});
    balls.add(Axes{{1.7, 0.1, 0.2}});
    const ClassifiedMesh before = balls.mesh;
    RunContext context;
    const Result<SolidImprovement> result = improveSolids(balls.mesh, balls.model, {}, context);
    ASSERT_TRUE(result);
    EXPECT_TRUE(result->isBoundaryFrozen);
    EXPECT_GT(result->improvement.counts.edgeRemovals, 0u);
    for (std::size_t i = 0; i < before.triangles.size(); ++i) {
        for (std::size_t k = 0; k < 3; ++k) {
            ASSERT_EQ(balls.mesh.nodes[balls.mesh.triangles[i].node[k]].position,
                      before.nodes[before.triangles[i].node[k]].position);
        }
    }
    balls = {};
    balls.add(Axes{});
    balls.add(Axes{{3.0, 0.1, 0.2}});
    const Result<SolidImprovement> apart = improveSolids(balls.mesh, balls.model, {}, context);
    ASSERT_TRUE(apart);
    EXPECT_FALSE(apart->isBoundaryFrozen);
    EXPECT_GT(apart->improvement.counts.faceMoves, 0u);
}

}  // namespace
}  // namespace mesher
