#include "io/mesh_writer.h"

#include "io/mesh_reader.h"
#include "mesh/classified_mesh_hash.h"
#include "mesh/mesh_check.h"
#include "support/sample_meshes.h"
#include "support/temp_dir.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <limits>
#include <sstream>

namespace mesher {
namespace {

std::string contentOf(const std::filesystem::path& path)
{
    std::ifstream file(path, std::ios::binary);
    std::ostringstream text;
    text << file.rdbuf();
    return text.str();
}

std::string written(const ClassifiedMesh& mesh, std::string_view format)
{
    const test::TempDir folder;
    const Result<void> result = writeMesh(mesh, folder.path() / "mesh", format);
    EXPECT_TRUE(result) << describe(result.error());
    return contentOf(folder.path() / "mesh");
}

std::size_t countOf(std::string_view text, std::string_view what)
{
    std::size_t count = 0;
    for (std::size_t at = text.find(what); at != std::string_view::npos; at = text.find(what, at + 1))
        ++count;
    return count;
}

template <std::size_t N>
void expectEqual(const std::vector<MeshElement<N>>& a, const std::vector<MeshElement<N>>& b)
{
    ASSERT_EQ(a.size(), b.size());
    for (std::size_t i = 0; i < a.size(); ++i) {
        EXPECT_EQ(a[i].node, b[i].node) << i;
        EXPECT_EQ(a[i].entity, b[i].entity) << i;
    }
}

/// Coordinates that need all digits, and the extremes of what a double holds.
ClassifiedMesh roughened(ClassifiedMesh mesh)
{
    for (MeshNode& node : mesh.nodes) {
        node.position = (1.0 / 3.0) * node.position + Vec3{std::sqrt(2.0), -1e-17, 1e5};
    }
    mesh.nodes[NodeId(0)].position = {std::numeric_limits<double>::denorm_min(), -1.7976931348623157e308,
                                      5e-324};
    return mesh;
}

struct RoundTrip
{
    const char* format;
    const char* extension;
    bool isVolume;
};

class MeshRoundTrip : public testing::TestWithParam<RoundTrip>
{
};

/// Element order is that of the entities, as writers may sort by it.
ClassifiedMesh sortedByEntity(ClassifiedMesh mesh)
{
    const auto sort = [](auto& elements) {
        std::stable_sort(elements.begin(), elements.end(),
                         [](const auto& a, const auto& b) { return a.entity < b.entity; });
    };
    sort(mesh.points);
    sort(mesh.lines);
    sort(mesh.triangles);
    sort(mesh.tets);
    return mesh;
}

TEST_P(MeshRoundTrip, GivesTheSameMeshBitForBit)
{
    const ClassifiedMesh mesh =
        sortedByEntity(roughened(GetParam().isVolume ? test::twoSolidMesh(3) : test::twoFaceMesh(5)));
    const Result<MeshFile> file = readMeshText(written(mesh, GetParam().format), GetParam().extension);
    ASSERT_TRUE(file) << describe(file.error());
    const ClassifiedMesh& read = file.value().mesh;
    ASSERT_EQ(read.nodes.size(), mesh.nodes.size());
    for (std::uint32_t i = 0; i < mesh.nodes.size(); ++i) {
        EXPECT_EQ(read.nodes[NodeId(i)].position, mesh.nodes[NodeId(i)].position) << i;
        EXPECT_EQ(read.nodes[NodeId(i)].entity, mesh.nodes[NodeId(i)].entity) << i;
    }
    expectEqual(read.points, mesh.points);
    expectEqual(read.lines, mesh.lines);
    expectEqual(read.triangles, mesh.triangles);
    expectEqual(read.tets, mesh.tets);
    EXPECT_EQ(classifiedMeshHash(read), classifiedMeshHash(mesh));
}

INSTANTIATE_TEST_SUITE_P(Formats, MeshRoundTrip,
                         testing::Values(RoundTrip{"msh", ".msh", false}, RoundTrip{"msh", ".msh", true},
                                         RoundTrip{"msh2", ".msh", false}, RoundTrip{"msh2", ".msh", true},
                                         RoundTrip{"vtu", ".vtu", false}, RoundTrip{"vtu", ".vtu", true}),
                         [](const auto& each) {
                             return std::string(each.param.format) +
                                    (each.param.isVolume ? "Volume" : "Plane");
                         });

TEST(MeshRoundTrip, KeepsParametersInVtu)
{
    const ClassifiedMesh mesh = test::twoFaceMesh();
    const Result<MeshFile> file = readMeshText(written(mesh, "vtu"), ".vtu");
    ASSERT_TRUE(file);
    for (std::uint32_t i = 0; i < mesh.nodes.size(); ++i) {
        EXPECT_EQ(file.value().mesh.nodes[NodeId(i)].parameters, mesh.nodes[NodeId(i)].parameters);
    }
}

TEST(MeshRoundTrip, KeepsWhatHasNoEntity)
{
    for (const char* format : {"msh", "msh2"}) {
        ClassifiedMesh mesh = test::twoFaceMesh();
        for (MeshElement<3>& triangle : mesh.triangles) {
            if (triangle.entity.index == 1) triangle.entity.index = EntityRef::kNone;
        }
        const Result<MeshFile> file = readMeshText(written(mesh, format), ".msh");
        ASSERT_TRUE(file);
        EXPECT_EQ(checkMesh(file.value().mesh).unclassified,
                  checkMesh(mesh).unclassified + (format[3] == '2' ? 9u : 0u))
            << format;
    }
}

TEST(GmshFile, NamesAnEntityByItsNumber)
{
    const std::string text = written(test::twoSolidMesh(), "msh");
    EXPECT_NE(text.find("2 3 \"Face3\""), std::string::npos);
    EXPECT_NE(text.find("3 2 \"Solid2\""), std::string::npos);
    EXPECT_NE(text.find("$PhysicalNames\n45\n"), std::string::npos);  // 12 + 20 + 11 + 2
}

TEST(GmshFile, TellsWhatBoundsAnEntity)
{
    const std::string text = written(test::twoFaceMesh(), "msh");
    // Edge1 runs from Vertex1 to Vertex2; Face1 has four edges.
    EXPECT_NE(text.find("\n1 0 0 0 0.4 0 0 1 1 2 1 -2\n"), std::string::npos);
    EXPECT_NE(text.find("\n1 0 0 0 0.4 0.4 0 1 1 4 "), std::string::npos);
}

TEST(Su2File, HasTheOuterEdgesAsMarkersAndNoZ)
{
    const std::string text = written(test::twoFaceMesh(4), "su2");
    EXPECT_NE(text.find("NDIME= 2\n"), std::string::npos);
    EXPECT_NE(text.find("NELEM= 64\n"), std::string::npos);
    EXPECT_NE(text.find("NPOIN= 45\n0 0 0\n"), std::string::npos);
    EXPECT_NE(text.find("NMARK= 6\n"), std::string::npos);  // seven edges, one of them between the faces
    EXPECT_EQ(countOf(text, "MARKER_ELEMS= 4\n"), 6u);
}

TEST(Su2File, HasTheOuterFacesAsMarkers)
{
    const std::string text = written(test::twoSolidMesh(2), "su2");
    EXPECT_NE(text.find("NDIME= 3\n"), std::string::npos);
    EXPECT_NE(text.find("NMARK= 10\n"), std::string::npos);
    EXPECT_EQ(countOf(text, "MARKER_ELEMS= 8\n"), 10u);
}

TEST(Su2File, RefusesAPlaneMeshThatIsNotLevel)
{
    ClassifiedMesh mesh = test::twoFaceMesh();
    mesh.nodes[NodeId(3)].position.z = 1e-12;
    const test::TempDir folder;
    const Result<void> result = writeMesh(mesh, folder.path() / "mesh.su2");
    ASSERT_FALSE(result);
    EXPECT_NE(describe(result.error()).find("constant z"), std::string::npos);
    EXPECT_TRUE(std::filesystem::is_empty(folder.path()));
}

TEST(StlFile, HasASolidForEachFace)
{
    const std::string text = written(test::twoSolidMesh(2), "stl");
    EXPECT_EQ(countOf(text, "endsolid Face"), 11u);
    EXPECT_EQ(countOf(text, "facet normal"), 2 * 88u - 88u);
    EXPECT_EQ(countOf(text, "vertex "), 3 * 88u);
}

TEST(StlFile, InBinaryHasFiftyBytesATriangle)
{
    EXPECT_EQ(written(test::twoSolidMesh(2), "stl-binary").size(), 84u + 50u * 88u);
}

TEST(PlyFile, HasTheTrianglesAndOnlyTheirNodes)
{
    const ClassifiedMesh mesh = test::twoSolidMesh(3);
    const std::string text = written(mesh, "ply");
    const std::size_t header = text.find("end_header\n") + 11;
    const std::size_t inner = 2 * 2 * 2 * 2;
    const std::size_t nodes = mesh.nodes.size() - inner;
    EXPECT_NE(text.find("element vertex " + std::to_string(nodes) + "\n"), std::string::npos);
    EXPECT_EQ(text.size() - header, 24 * nodes + 17 * mesh.triangles.size());
}

TEST(AbaqusFile, HasElementsSetsAndSurfaces)
{
    const std::string text = written(test::twoSolidMesh(2), "inp");
    EXPECT_NE(text.find("*ELEMENT, TYPE=C3D4, ELSET=Solid2\n"), std::string::npos);
    EXPECT_EQ(countOf(text, "*NSET, NSET=Face"), 11u);
    EXPECT_EQ(countOf(text, "*SURFACE, NAME=Face"), 11u);
    EXPECT_EQ(countOf(text, ", S"), 96u + 11u - 11u + 0u);
}

TEST(AbaqusFile, OfAPlaneHasPlaneStressElements)
{
    const std::string text = written(test::twoFaceMesh(2), "inp");
    EXPECT_NE(text.find("*ELEMENT, TYPE=CPS3, ELSET=Face1\n"), std::string::npos);
    EXPECT_EQ(countOf(text, "*SURFACE, NAME=Edge"), 7u);
}

TEST(AbaqusFile, NamesTheSideOfATetByItsNodes)
{
    ClassifiedMesh mesh;
    for (const Vec3& p :
         {Vec3{0.0, 0.0, 0.0}, Vec3{1.0, 0.0, 0.0}, Vec3{0.0, 1.0, 0.0}, Vec3{0.0, 0.0, 1.0}}) {
        mesh.nodes.push_back({p, {0, static_cast<std::uint32_t>(mesh.nodes.size())}, {}});
    }
    mesh.tets.push_back({{NodeId(0), NodeId(1), NodeId(2), NodeId(3)}, {3, 0}});
    // S1 = 1-2-3, S2 = 1-4-2, S3 = 2-4-3, S4 = 3-4-1
    mesh.triangles = {{{NodeId(0), NodeId(2), NodeId(1)}, {2, 0}},
                      {{NodeId(0), NodeId(1), NodeId(3)}, {2, 1}},
                      {{NodeId(1), NodeId(2), NodeId(3)}, {2, 2}},
                      {{NodeId(0), NodeId(3), NodeId(2)}, {2, 3}}};
    const std::string text = written(mesh, "inp");
    for (const char* surface : {"Face1, TYPE=ELEMENT\n1, S1\n", "Face2, TYPE=ELEMENT\n1, S2\n",
                                "Face3, TYPE=ELEMENT\n1, S3\n", "Face4, TYPE=ELEMENT\n1, S4\n"}) {
        EXPECT_NE(text.find(surface), std::string::npos) << surface;
    }
}

TEST(UnvFile, HasNodesElementsAndGroupsInColumns)
{
    const std::string text = written(test::twoFaceMesh(1), "unv");
    EXPECT_EQ(text.substr(0, 14), "    -1\n  2411\n");
    EXPECT_NE(text.find("\n   1.0000000000000001D-01   0.0000000000000000D+00   0.0000000000000000D+00\n"),
              std::string::npos);
    EXPECT_NE(text.find("\nFace2\n"), std::string::npos);
    EXPECT_EQ(countOf(text, "\n    -1\n"), 5u);
}

TEST(VtkFile, InBinaryIsBigEndian)
{
    const std::string text = written(test::twoFaceMesh(1), "vtk-binary");
    const std::size_t first = text.find("double\n") + 7;
    const std::string tenth = text.substr(first + 24, 8);  // x of the second node
    EXPECT_EQ(tenth, std::string("\x3f\xb9\x99\x99\x99\x99\x99\x9a", 8));
}

TEST(MeshFormats, AreFoundByExtensionAndByName)
{
    EXPECT_EQ(findFormat("a/b.MSH").value()->name, "msh");
    EXPECT_EQ(findFormat("a/b.msh", "msh2").value()->name, "msh2");
    for (const MeshFormat& format : meshFormats())
        EXPECT_EQ(findFormat("x", format.name).value()->name, format.name);
    const Result<const MeshFormat*> unknown = findFormat("a/b.xyz");
    ASSERT_FALSE(unknown);
    EXPECT_EQ(unknown.error().code, ErrorCode::InvalidArgument);
    EXPECT_NE(unknown.error().remedy.find("vtu"), std::string::npos);
    EXPECT_FALSE(findFormat("noextension"));
    EXPECT_FALSE(findFormat("a.msh", "nonsense"));
}

}  // namespace
}  // namespace mesher
