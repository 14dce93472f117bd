#include "brep/shell_closing.h"

#include "brep/analytic/solids.h"
#include "brep/face_sewing.h"
#include "brep/model_measures.h"
#include "support/model_union.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <numbers>
#include <string>

namespace mesher::test {
namespace {

/// Each face of the model with edges and vertices of its own, and no solid; every second face looks the wrong way.
BrepModel facesOf(const BrepModel& model)
{
    BrepModel faces;
    faces.box = model.box;
    for (const BrepFace& found : model.faces) {
        BrepFace face = found;
        std::map<BrepVertexId, BrepVertexId> vertexOf;
        std::map<BrepEdgeId, BrepEdgeId> edgeOf;
        const auto copyOf = [&](BrepVertexId v) {
            if (vertexOf.contains(v)) return vertexOf[v];
            faces.vertices.push_back(model.vertices[v]);
            return vertexOf[v] = BrepVertexId(static_cast<std::uint32_t>(faces.vertices.size() - 1));
        };
        for (BrepLoop& loop : face.loops) {
            for (BrepCoedge& coedge : loop.coedges) {
                if (!edgeOf.contains(coedge.edge)) {
                    BrepEdge edge = model.edges[coedge.edge];
                    edge.first = copyOf(edge.first);
                    edge.last = copyOf(edge.last);
                    faces.edges.push_back(edge);
                    edgeOf[coedge.edge] = BrepEdgeId(static_cast<std::uint32_t>(faces.edges.size() - 1));
                }
                coedge.edge = edgeOf[coedge.edge];
            }
        }
        const BrepFaceId id(static_cast<std::uint32_t>(faces.faces.size()));
        faces.faces.push_back(face);
        faces.looseShells.push_back({{{id, id.value % 2 == 1}}, false});
    }
    return faces;
}

double volumeOf(const BrepModel& model)
{
    RunContext context;
    return measureModel(model, context).volume.value;
}

bool isNoted(const BrepModel& model, const std::string& text)
{
    return std::any_of(model.notes.begin(), model.notes.end(),
                       [&](const std::string& note) { return note.find(text) != std::string::npos; });
}

BrepModel sewn(BrepModel model)
{
    sewFaces(model);
    closeShells(model);
    return model;
}

TEST(ShellClosing, MakesASolidOfFacesWithoutCommonEdges)
{
    const BrepModel box = sewn(facesOf(*makeBox({}, {1.0, 2.0, 3.0})));
    ASSERT_EQ(box.solids.size(), 1u);
    EXPECT_TRUE(box.looseShells.empty());
    EXPECT_NEAR(volumeOf(box), 6.0, 1e-12);
    EXPECT_TRUE(isNoted(box, "Solid1 was made of the closed shell of Face1, Face2, "));
    const BrepModel cylinder = sewn(facesOf(*makeCylinder({}, 1.0, 2.0)));
    ASSERT_EQ(cylinder.solids.size(), 1u);
    EXPECT_NEAR(volumeOf(cylinder), 2.0 * std::numbers::pi, 1e-4);
}

TEST(ShellClosing, ClosedShellsAreVoidsAndSolidsByTurns)
{
    BrepModel nested = together(*makeBox({}, {9.0, 9.0, 9.0}), *makeBox({1.0, 1.0, 1.0}, {8.0, 8.0, 8.0}));
    nested = together(nested, *makeBox({2.0, 3.0, 4.0}, {5.0, 6.0, 7.0}));
    nested = together(nested, *makeBox({20.0, 0.0, 0.0}, {21.0, 1.0, 1.0}));
    const BrepModel model = sewn(facesOf(nested));
    ASSERT_EQ(model.solids.size(), 3u);
    EXPECT_EQ(model.solids[BrepSolidId(0)].shells.size(), 2u);
    EXPECT_NEAR(volumeOf(model), 9.0 * 9.0 * 9.0 - 7.0 * 7.0 * 7.0 + 27.0 + 1.0, 1e-9);
}

TEST(ShellClosing, LeavesOpenShellsOpen)
{
    BrepModel box = facesOf(*makeBox({}, {1.0, 1.0, 1.0}));
    box.looseShells.pop_back();
    box.faces.resize(5);
    const BrepModel model = sewn(std::move(box));
    EXPECT_TRUE(model.solids.empty());
    ASSERT_EQ(model.looseShells.size(), 1u);
    EXPECT_EQ(model.looseShells.front().faces.size(), 5u);
}

TEST(FaceSewing, LeavesEdgesThatAreFartherApartThanTheLimit)
{
    BrepModel model =
        facesOf(together(*makeBox({}, {1.0, 1.0, 1.0}), *makeBox({1.001, 0.0, 0.0}, {2.0, 1.0, 1.0})));
    sewFaces(model);
    closeShells(model);
    EXPECT_EQ(model.solids.size(), 2u);
}

TEST(FaceSewing, KeepsNamesAndSplitsWhereOtherEdgesEnd)
{
    // A square of 2 x 2 beside two of 1 x 1: the upper faces of three boxes.
    BrepModel model =
        facesOf(together(together(*makeBox({}, {2.0, 2.0, 1.0}), *makeBox({2.0, 0.0, 0.0}, {3.0, 1.0, 1.0})),
                         *makeBox({2.0, 1.0, 0.0}, {3.0, 2.0, 1.0})));
    BrepModel lids;
    lids.box = model.box;
    lids.vertices = model.vertices;
    lids.edges = model.edges;
    for (const std::uint32_t lid : {5u, 11u, 17u}) {
        lids.looseShells.push_back(
            {{{BrepFaceId(static_cast<std::uint32_t>(lids.faces.size())), false}}, false});
        lids.faces.push_back(model.faces[BrepFaceId(lid)]);
    }
    const std::size_t edges = lids.edges.size();
    sewFaces(lids);
    EXPECT_EQ(lids.edges.size(), edges + 1);
    EXPECT_EQ(lids.faces[BrepFaceId(0)].loops.front().coedges.size(), 5u);
    std::map<BrepEdgeId, int> uses;
    for (const BrepFace& face : lids.faces) {
        for (const BrepCoedge& coedge : face.loops.front().coedges) ++uses[coedge.edge];
    }
    EXPECT_EQ(std::count_if(uses.begin(), uses.end(), [](const auto& use) { return use.second == 2; }), 3);
    closeShells(lids);
    EXPECT_EQ(lids.looseShells.size(), 1u);
}

}  // namespace
}  // namespace mesher::test
