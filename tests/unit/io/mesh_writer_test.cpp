#include "io/mesh_writer.h"

#include "io/mesh_reader.h"
#include "mesh/classified_mesh_hash.h"
#include "mesh/mesh_check.h"
#include "mesh/node_order.h"
#include "support/sample_meshes.h"
#include "support/temp_dir.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <limits>
#include <sstream>
#include <tuple>

namespace mesher {
namespace {

std::string contentOf(const std::filesystem::path& path)
{
    std::ifstream file(path, std::ios::binary);
    std::ostringstream text;
    text << file.rdbuf();
    return text.str();
}

std::string written(const ClassifiedMesh& mesh, std::string_view format,
                    GroupChoice groups = GroupChoice::Bounding)
{
    const test::TempDir folder;
    const Result<void> result = writeMesh(mesh, folder.path() / "mesh", format, {groups});
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

/// The order of nodes and elements is that of the entities, as writers may sort by it.
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
    sortNodesByEntity(mesh);
    return mesh;
}

TEST_P(MeshRoundTrip, GivesTheSameMeshBitForBit)
{
    const ClassifiedMesh mesh =
        sortedByEntity(roughened(GetParam().isVolume ? test::twoSolidMesh(3) : test::twoFaceMesh(5)));
    const std::string text = written(mesh, GetParam().format, GroupChoice::All);
    const Result<MeshFile> file = readMeshText(text, GetParam().extension);
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
        const Result<MeshFile> file = readMeshText(written(mesh, format, GroupChoice::All), ".msh");
        ASSERT_TRUE(file);
        EXPECT_EQ(checkMesh(file.value().mesh).unclassified,
                  checkMesh(mesh).unclassified + (format[3] == '2' ? 9u : 0u))
            << format;
    }
}

/// The lines of $PhysicalNames: dimension, number, name.
std::vector<std::tuple<int, int, std::string>> groupsIn(const std::string& text)
{
    std::istringstream in(text.substr(text.find("$PhysicalNames")));
    std::string word;
    std::size_t count = 0;
    in >> word >> count;
    std::vector<std::tuple<int, int, std::string>> groups(count);
    for (auto& [dimension, number, name] : groups) in >> dimension >> number >> name;
    return groups;
}

TEST(GmshFile, NumbersGroupsThroughAllDimensions)
{
    for (const char* format : {"msh", "msh2"}) {
        const std::string text = written(test::twoSolidMesh(), format, GroupChoice::All);
        const auto groups = groupsIn(text);
        ASSERT_EQ(groups.size(), 45u);  // 2 + 11 + 20 + 12
        for (std::size_t i = 0; i < groups.size(); ++i)
            EXPECT_EQ(std::get<1>(groups[i]), static_cast<int>(i + 1)) << format;
        EXPECT_EQ(groups[1], std::tuple(3, 2, "\"Solid2\""));
        EXPECT_EQ(groups[2], std::tuple(2, 3, "\"Face1\""));
        EXPECT_EQ(groups.back(), std::tuple(0, 45, "\"Vertex12\""));
    }
}

TEST(GmshFile, HasGroupsAndElementsOfEdgesAndVerticesOnlyOnAWish)
{
    for (const char* format : {"msh", "msh2"}) {
        EXPECT_EQ(groupsIn(written(test::twoSolidMesh(), format)).size(), 13u);
        EXPECT_EQ(groupsIn(written(test::twoFaceMesh(), format)).size(), 9u);  // 2 faces, 7 edges
        const ClassifiedMesh mesh = test::twoSolidMesh(3);
        const Result<MeshFile> file = readMeshText(written(mesh, format), ".msh");
        ASSERT_TRUE(file);
        const ClassifiedMesh& read = file.value().mesh;
        EXPECT_TRUE(read.points.empty() && read.lines.empty());
        EXPECT_EQ(read.triangles.size(), mesh.triangles.size());
        EXPECT_EQ(checkMesh(read).problems(), std::vector<std::string>()) << format;
    }
}

/// Without elements on them, edges and vertices are told by the blocks of nodes.
TEST(GmshFile, TellsTheEntitiesOfNodesWithoutTheirGroups)
{
    const ClassifiedMesh mesh = sortedByEntity(test::twoSolidMesh(3));
    const Result<MeshFile> file = readMeshText(written(mesh, "msh"), ".msh");
    ASSERT_TRUE(file);
    for (std::uint32_t i = 0; i < mesh.nodes.size(); ++i)
        EXPECT_EQ(file.value().mesh.nodes[NodeId(i)].entity, mesh.nodes[NodeId(i)].entity) << i;
}

TEST(GmshFile, HasNodesInTheOrderOfTheirNumbers)
{
    const std::string text = written(test::twoSolidMesh(3), "msh");
    std::istringstream in(text.substr(text.find("$Nodes") + 6));
    std::size_t blocks = 0, nodes = 0, last = 0, ignored = 0;
    in >> blocks >> nodes >> ignored >> ignored;
    for (; blocks > 0; --blocks) {
        std::size_t count = 0;
        double coordinate = 0.0;
        in >> ignored >> ignored >> ignored >> count;
        for (std::size_t i = 0; i < count; ++i) {
            std::size_t tag = 0;
            in >> tag;
            EXPECT_EQ(tag, ++last);
        }
        for (std::size_t i = 0; i < 3 * count; ++i) in >> coordinate;
    }
    EXPECT_EQ(last, nodes);
}

TEST(GmshFile, TellsWhatBoundsAnEntity)
{
    const std::string text = written(test::twoFaceMesh(), "msh");
    // Edge1 (tag 3, behind the faces) runs from Vertex1 to Vertex2; Face1 has four edges.
    EXPECT_NE(text.find("\n3 0 0 0 0.4 0 0 1 3 2 10 -11\n"), std::string::npos);
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
    // 11 faces of 8 triangles, one of them between the solids.
    EXPECT_EQ(countOf(text, "endsolid Face"), 10u);
    EXPECT_EQ(countOf(text, "facet normal"), 80u);
    EXPECT_EQ(countOf(text, "vertex "), 3 * 80u);
}

TEST(StlFile, InBinaryHasFiftyBytesATriangle)
{
    EXPECT_EQ(written(test::twoSolidMesh(2), "stl-binary").size(), 84u + 50u * 80u);
}

TEST(PlyFile, HasTheOuterTrianglesAndOnlyTheirNodes)
{
    const ClassifiedMesh mesh = test::twoSolidMesh(3);
    const std::string text = written(mesh, "ply");
    const std::size_t inner = 2 * 2 * 2 * 2 + 2 * 2;  // in the solids, and in the face between them
    const std::size_t nodes = mesh.nodes.size() - inner;
    const std::size_t outer = mesh.triangles.size() - 18;
    EXPECT_NE(text.find("format ascii"), std::string::npos);
    EXPECT_NE(text.find("element vertex " + std::to_string(nodes) + "\n"), std::string::npos);
    EXPECT_NE(text.find("element face " + std::to_string(outer) + "\n"), std::string::npos);
    const std::string body = text.substr(text.find("end_header\n") + 11);
    EXPECT_EQ(countOf(body, "\n"), nodes + outer);
}

/// Numbers of the longest kind, in every place that they may have.
TEST(AbaqusFile, HasNoNumberThatTheSolverCuts)
{
    ClassifiedMesh mesh = test::twoSolidMesh(1);
    const std::vector<double> values = {-9.797174393178826e-16,   -1.2345678901234567e-100,
                                        -1.2345678901234567e+100, -0.0012345678901234567,
                                        -123456.78901234567,      1.0 / 3.0};
    for (std::uint32_t i = 0; i < values.size(); ++i)
        mesh.nodes[NodeId(i)].position = {values[i], 0.0, -values[i]};
    std::istringstream in(written(mesh, "inp"));
    std::string line;
    while (!line.starts_with("*NODE")) std::getline(in, line);
    for (const double value : values) {
        std::getline(in, line);
        const std::size_t first = line.find(',') + 1;
        const std::string word = line.substr(first, line.find(',', first) - first);
        EXPECT_LE(word.size(), 20u) << word;
        EXPECT_NEAR(std::stod(word), value, 1e-12 * std::abs(value)) << word;
    }
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
    EXPECT_NE(text.find("\nEdge7\n"), std::string::npos);
    EXPECT_EQ(countOf(text, "\nVertex"), 0u);
    EXPECT_EQ(countOf(text, "\n    -1\n"), 5u);
}

TEST(UnvFile, OfSolidsHasEdgesAndVerticesOnlyOnAWish)
{
    constexpr const char* kRod = "        11         1         1         7         2\n";
    const std::string text = written(test::twoSolidMesh(1), "unv");
    EXPECT_EQ(countOf(text, "\nEdge") + countOf(text, "\nVertex") + countOf(text, kRod), 0u);
    EXPECT_EQ(countOf(text, "\nFace") + countOf(text, "\nSolid"), 13u);
    const std::string all = written(test::twoSolidMesh(1), "unv", GroupChoice::All);
    EXPECT_EQ(countOf(all, "\nEdge"), 20u);
    EXPECT_EQ(countOf(all, kRod), 20u);
    EXPECT_EQ(countOf(all, "\nVertex"), 12u);
}

TEST(VtkFile, HasItsArraysInOneFieldEach)
{
    const std::string text = written(test::twoFaceMesh(1), "vtk");
    EXPECT_EQ(countOf(text, "SCALARS"), 0u);
    EXPECT_EQ(countOf(text, "FIELD FieldData"), 2u);
    for (const char* array : {"\nentity 1 17 int\n", "\ndimension 1 17 int\n", "\nparameters 2 6 double\n"})
        EXPECT_EQ(countOf(text, array), 1u) << array;
}

TEST(VtuFile, NamesItsGroups)
{
    const std::string text = written(test::twoSolidMesh(1), "vtu");
    for (const char* name : {"\"Solid2\" NumberOfTuples=\"2\" format=\"ascii\">2 3<",
                             "\"Face1\" NumberOfTuples=\"2\" format=\"ascii\">3 2<",
                             "\"Edge20\" NumberOfTuples=\"2\" format=\"ascii\">33 1<",
                             "\"Vertex12\" NumberOfTuples=\"2\" format=\"ascii\">45 0<"})
        EXPECT_EQ(countOf(text, name), 1u) << name;
    EXPECT_EQ(countOf(text, "Name=\"group\""), 1u);
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
