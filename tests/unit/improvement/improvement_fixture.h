#pragma once

#include "brep/analytic/axes.h"
#include "brep/analytic/solids.h"
#include "improvement/dihedral_score.h"
#include "improvement/improve_mesh.h"
#include "improvement/improvement_check.h"
#include "pipeline/mesh_solids.h"
#include "quality/quality_statistics.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

namespace mesher::test {

struct SolidExample
{
    std::string name;
    BrepModel model;
    double size = 0.0;
};

inline std::vector<SolidExample> solidExamples()
{
    std::vector<SolidExample> examples;
    examples.push_back({"box", makeBox({0, 0, 0}, {3, 2, 1}).value(), 0.3});
    examples.push_back({"cylinder", makeCylinder(Axes{}, 1.0, 2.5).value(), 0.35});
    examples.push_back({"frustum", makeCone(Axes{}, 1.5, 0.5, 2.0).value(), 0.35});
    examples.push_back({"sphere", makeSphere(Axes{}, 1.0).value(), 0.25});
    examples.push_back({"torus", makeTorus(Axes{}, 2.0, 0.7).value(), 0.3});
    return examples;
}

/// The image of a point in the plane x = 1.
inline Vec3 mirrored(const Vec3& p) { return {2.0 - p.x, p.y, p.z}; }

/// Takes a mesh of the unit cube on into its mirror image, a second cube that shares the face x = 1 with the first: two solids and
/// a mesh that fits the model `makeTwoCubes`.
inline BrepModel makeTwoCubes()
{
    BrepModel model = makeBox({0, 0, 0}, {1, 1, 1}).value();
    const BrepModel other = makeBox({1, 0, 0}, {2, 1, 1}).value();
    for (const BrepVertex& vertex : other.vertices) model.vertices.push_back(vertex);
    const auto count = static_cast<std::uint32_t>(other.vertices.size());
    for (BrepEdge edge : other.edges) {
        edge.first = BrepVertexId(edge.first.value + count);
        edge.last = BrepVertexId(edge.last.value + count);
        model.edges.push_back(edge);
    }
    const auto edges = static_cast<std::uint32_t>(other.edges.size());
    for (BrepFace face : other.faces) {
        for (BrepLoop& loop : face.loops) {
            for (BrepCoedge& coedge : loop.coedges) coedge.edge = BrepEdgeId(coedge.edge.value + edges);
        }
        model.faces.push_back(face);
    }
    model.solids.push_back({});
    return model;
}

/// The entity of the second cube that a node of the first has as its mirror image: that which is nearest of its dimension.
inline MeshNode mirroredNode(const BrepModel& model, const MeshNode& node)
{
    MeshNode image{mirrored(node.position), node.entity, {}};
    const auto& [dimension, index] = node.entity;
    if (dimension == 3) image.entity.index = 1;
    double least = 1e9;
    const auto keepNearest = [&](double distance, std::uint32_t candidate, Vec2 parameters) {
        if (distance >= least) return;
        least = distance;
        image.entity.index = candidate;
        image.parameters = parameters;
    };
    if (dimension == 0) {
        for (std::uint32_t v = 8; v < 16; ++v)
            keepNearest(length(model.vertices[BrepVertexId(v)].position - image.position), v, {});
    } else if (dimension == 1) {
        for (std::uint32_t e = 12; e < 24; ++e) {
            const BrepEdge& edge = model.edges[BrepEdgeId(e)];
            const CurveProjection found = edge.curve->project(image.position, edge.part);
            keepNearest(found.distance, e, {found.parameter, 0.0});
        }
    } else if (dimension == 2) {
        const std::uint32_t f = index < 2 ? 7 - index : 6 + index;  // xmin and xmax change places
        keepNearest(0.0, f, model.faces[BrepFaceId(f)].surface->project(image.position).parameters);
    }
    return image;
}

inline ClassifiedMesh twoCubesOf(const ClassifiedMesh& cube, const BrepModel& model)
{
    ClassifiedMesh mesh = cube;
    constexpr std::uint32_t kShared = 1;  // the face x = 1 of the first cube
    IdVector<NodeId, NodeId> imageOf(cube.nodes.size());
    for (std::uint32_t i = 0; i < cube.nodes.size(); ++i) {
        const MeshNode& node = cube.nodes[NodeId(i)];
        imageOf[NodeId(i)] =
            node.position.x == 1.0 ? NodeId(i) : mesh.nodes.push_back(mirroredNode(model, node));
    }
    const auto isShared = [&](NodeId n) { return cube.nodes[n].position.x == 1.0; };
    for (const auto& point : cube.points) {
        if (isShared(point.node[0])) continue;
        const NodeId image = imageOf[point.node[0]];
        mesh.points.push_back({{image}, mesh.nodes[image].entity});
    }
    for (const auto& line : cube.lines) {
        if (isShared(line.node[0]) && isShared(line.node[1])) continue;
        const NodeId a = imageOf[line.node[0]];
        const NodeId b = imageOf[line.node[1]];
        const Vec3 middle = 0.5 * (mesh.nodes[a].position + mesh.nodes[b].position);
        mesh.lines.push_back(
            {{b, a}, mirroredNode(model, {mirrored(middle), {1, line.entity.index}, {}}).entity});
    }
    for (const auto& triangle : cube.triangles) {
        const std::uint32_t f = triangle.entity.index;
        if (f == kShared) continue;
        const auto& v = triangle.node;
        mesh.triangles.push_back({{imageOf[v[0]], imageOf[v[2]], imageOf[v[1]]}, {2, f < 2 ? 7 - f : 6 + f}});
    }
    for (const auto& tet : cube.tets) {
        const auto& v = tet.node;
        mesh.tets.push_back({{imageOf[v[0]], imageOf[v[2]], imageOf[v[1]], imageOf[v[3]]}, {3, 1}});
    }
    return mesh;
}

/// As the refinement leaves it.
inline ClassifiedMesh refinedMesh(const SolidExample& example)
{
    MeshOptions options;
    options.size = example.size;
    options.isImproved = false;
    RunContext context;
    MeshOutcome outcome = meshSolids(example.model, options, nullptr, context);
    EXPECT_TRUE(outcome.mesh) << example.name;
    return outcome.mesh ? std::move(*outcome.mesh) : ClassifiedMesh{};
}

inline Improvement improved(ClassifiedMesh& mesh, const BrepModel& model,
                            const ImprovementOptions& options = {})
{
    RunContext context;
    const Result<Improvement> result = improveMesh(mesh, model, options, context);
    EXPECT_TRUE(result);
    return result ? result.value() : Improvement{};
}

inline testing::AssertionResult isImprovementOf(const ClassifiedMesh& after, const ClassifiedMesh& before,
                                                const BrepModel& model)
{
    const CheckReport report = checkImprovement(before, after, model);
    if (report.isValid()) return testing::AssertionSuccess();
    return testing::AssertionFailure() << report.violations << " violations, first: " << report.problem;
}

}  // namespace mesher::test
