#include "io/mesh_reader.h"

#include "base/random.h"
#include "io/mesh_writer.h"
#include "support/sample_meshes.h"
#include "support/temp_dir.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>
#include <sstream>

namespace mesher {
namespace {

constexpr const char* kTriangle22 = "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n"
                                    "$Nodes\n3\n10 0 0 0\n7 1 0 0\n20 0 1e0 +0\n$EndNodes\n"
                                    "$Elements\n1\n5 2 2 0 3 10 7 20\n$EndElements\n";

constexpr const char* kSize =
    "$NodeData\n1\n\"size\"\n1\n0.0\n3\n0\n1\n3\n20 0.5\n7 0.25\n10 2\n$EndNodeData\n";

void expectUnreadable(const std::string& text, const std::string& part, const char* extension = ".msh")
{
    const Result<MeshFile> file = readMeshText(text, extension);
    ASSERT_FALSE(file) << text;
    EXPECT_EQ(file.error().code, ErrorCode::Unreadable);
    EXPECT_NE(describe(file.error()).find(part), std::string::npos) << describe(file.error());
}

std::string replaced(std::string text, const std::string& what, const std::string& by)
{
    const std::size_t at = text.find(what);
    EXPECT_NE(at, std::string::npos) << what;
    return at == std::string::npos ? text : text.replace(at, what.size(), by);
}

TEST(ReadGmsh, OrdersNodesByTheirTags)
{
    const Result<MeshFile> file = readMeshText(kTriangle22, ".msh");
    ASSERT_TRUE(file) << describe(file.error());
    const ClassifiedMesh& mesh = file.value().mesh;
    ASSERT_EQ(mesh.nodes.size(), 3u);
    EXPECT_EQ(mesh.nodes[NodeId(0)].position, (Vec3{1.0, 0.0, 0.0}));
    EXPECT_EQ(mesh.triangles[0].node, (std::array{NodeId(1), NodeId(0), NodeId(2)}));
    EXPECT_EQ(mesh.triangles[0].entity, (EntityRef{2, 2}));
    EXPECT_EQ(mesh.nodes[NodeId(0)].entity, (EntityRef{2, 2}));
}

TEST(ReadGmsh, ReadsAFieldOfSizes)
{
    const Result<MeshFile> file = readMeshText(std::string(kTriangle22) + kSize, ".msh");
    ASSERT_TRUE(file) << describe(file.error());
    ASSERT_EQ(file.value().fields.size(), 1u);
    EXPECT_EQ(file.value().fields[0].name, "size");
    EXPECT_EQ(file.value().fields[0].values, (std::vector<double>{0.25, 2.0, 0.5}));
}

TEST(ReadGmsh, RefusesWithTheLine)
{
    const std::string text = kTriangle22;
    expectUnreadable(replaced(text, "1 0 0\n", "1 x 0\n"), "line 7: a number is expected, not 'x'");
    expectUnreadable(replaced(text, "2.2 0 8", "4.0 0 8"), "4.0");
    expectUnreadable(replaced(text, "2.2 0 8", "2.2 1 8"), "binary");
    expectUnreadable(replaced(text, "7 20\n", "7 21\n"), "no node 21");
    expectUnreadable(replaced(text, "10 0 0 0", "7 0 0 0"), "twice");
    expectUnreadable(replaced(text, "5 2 2 0 3 10 7 20", "5 3 2 0 3 10 7 20"), "type 3");
    expectUnreadable(replaced(text, "$Nodes\n3\n", "$Nodes\n999999999999\n"), "cannot be 999999999999 items");
    expectUnreadable(replaced(text, "$Nodes\n3\n", "$Nodes\n-3\n"), "cannot be -3");
    expectUnreadable(replaced(text, "$Nodes\n3\n", "$Nodes\n4\n"), "line ");
    expectUnreadable(text.substr(0, text.size() - 14), "cut off");
    expectUnreadable("no mesh", "$MeshFormat is expected");
    expectUnreadable("$MeshFormat\n4.1 0 8\n$EndMeshFormat\n", "no nodes");
    expectUnreadable(text + replaced(kSize, "20 0.5\n", "20 0.5\n21 1\n"), "$EndNodeData is expected");
    expectUnreadable(text + replaced(replaced(kSize, "10 2\n", ""), "1\n3\n20", "1\n2\n20"),
                     "no value for node 10");
}

TEST(ReadMesh, RefusesFilesThatAreNotThere)
{
    const test::TempDir folder;
    std::ofstream(folder.path() / "empty.msh").close();
    std::ofstream(folder.path() / "model.step") << "ISO-10303-21;";
    const auto refusal = [&](const char* name) { return describe(readMesh(folder.path() / name).error()); };
    EXPECT_NE(refusal("missing.msh").find("no such file"), std::string::npos);
    EXPECT_NE(refusal("empty.msh").find("empty"), std::string::npos);
    EXPECT_NE(refusal("model.step").find(".msh or .vtu"), std::string::npos);
    EXPECT_NE(refusal("").find("is a folder"), std::string::npos);
}

constexpr const char* kVtu =
    "<?xml version=\"1.0\"?>\n<!-- <a> -->\n"
    "<VTKFile type=\"UnstructuredGrid\" version=\"0.1\" byte_order=\"LittleEndian\">\n<UnstructuredGrid>\n"
    "<Piece NumberOfPoints=\"3\" NumberOfCells=\"1\">\n<PointData Scalars='h'>\n"
    "<DataArray type=\"Float64\" Name=\"h\" format=\"ascii\">0.5 0.25 1e-3</DataArray>\n</PointData>\n"
    "<Points><DataArray type=\"Float32\" NumberOfComponents=\"3\" format=\"ascii\">0 0 0 1 0 0 0 1 "
    "0</DataArray></Points>\n"
    "<Cells><DataArray type=\"Int32\" Name=\"connectivity\" format=\"ascii\">0 1 2</DataArray>\n"
    "<DataArray type=\"Int32\" Name=\"offsets\" format=\"ascii\">3</DataArray>\n"
    "<DataArray type=\"UInt8\" Name=\"types\" format=\"ascii\">5</DataArray></Cells>\n"
    "</Piece>\n</UnstructuredGrid>\n</VTKFile>\n";

TEST(ReadVtu, ReadsTextAndFields)
{
    const Result<MeshFile> file = readMeshText(kVtu, ".vtu");
    ASSERT_TRUE(file) << describe(file.error());
    ASSERT_EQ(file.value().mesh.triangles.size(), 1u);
    ASSERT_EQ(file.value().fields.size(), 1u);
    EXPECT_EQ(file.value().fields[0].values, (std::vector<double>{0.5, 0.25, 1e-3}));
}

TEST(ReadVtu, ReadsInlineBase64WithAHeaderOf32Bits)
{
    // 4 bytes of length 3, then the bytes 0 1 2 as UInt8 connectivity.
    const std::string text =
        replaced(kVtu, "type=\"Int32\" Name=\"connectivity\" format=\"ascii\">0 1 2<",
                 "type=\"UInt8\" Name=\"connectivity\" format=\"binary\">\n AwAAAAABAg==\n<");
    const Result<MeshFile> file = readMeshText(text, ".vtu");
    ASSERT_TRUE(file) << describe(file.error());
    EXPECT_EQ(file.value().mesh.triangles[0].node[2], NodeId(2));
}

TEST(ReadVtu, RefusesWithTheOffset)
{
    const std::string text = kVtu;
    expectUnreadable("garbage", "no VTK XML", ".vtu");
    expectUnreadable(text.substr(0, 300), "offset", ".vtu");
    expectUnreadable(text.substr(0, text.size() - 40), "cut off", ".vtu");
    expectUnreadable(replaced(text, "LittleEndian", "BigEndian"), "big-endian", ".vtu");
    expectUnreadable(replaced(text, "\"UnstructuredGrid\"", "\"PolyData\""), "not an unstructured grid",
                     ".vtu");
    expectUnreadable(replaced(text, "NumberOfPoints=\"3\"", "NumberOfPoints=\"4\""), "as many values",
                     ".vtu");
    expectUnreadable(replaced(text, "NumberOfCells=\"1\"", "NumberOfCells=\"-1\""), "no number", ".vtu");
    expectUnreadable(replaced(text, ">0 1 2<", ">0 1 3<"), "node 3", ".vtu");
    expectUnreadable(replaced(text, ">5<", ">9<"), "type 9", ".vtu");
    expectUnreadable(replaced(text, ">3<", ">4<"), "connectivity", ".vtu");
    expectUnreadable(replaced(text, "</Cells>", ""), "closed", ".vtu");
}

std::string sample(std::string_view format, bool isVolume)
{
    const test::TempDir folder;
    const ClassifiedMesh mesh = isVolume ? test::twoSolidMesh(1) : test::twoFaceMesh(2);
    EXPECT_TRUE(writeMesh(mesh, folder.path() / "m", format));
    std::ifstream file(folder.path() / "m", std::ios::binary);
    std::ostringstream text;
    text << file.rdbuf();
    return text.str();
}

/// Changes, cuts, repeats or removes a few bytes at random places.
std::string mutated(std::string text, Random& random)
{
    static const std::string kTokens[] = {
        "-1", "0", "99999999999999999999", "nan", "1e999", "$", "\"", "<", ">", "\n", " ", "\0"};
    const std::uint32_t changes = 1 + random.below(4);
    for (std::uint32_t i = 0; i < changes && !text.empty(); ++i) {
        const std::size_t at = random.below(static_cast<std::uint32_t>(text.size()));
        switch (random.below(5)) {
            case 0: text[at] = static_cast<char>(random.below(256)); break;
            case 1: text.resize(at); break;
            case 2: text.erase(at, 1 + random.below(20)); break;
            case 3: text.insert(at, kTokens[random.below(std::size(kTokens))]); break;
            default:
                text.insert(
                    at, text.substr(random.below(static_cast<std::uint32_t>(text.size())), random.below(60)));
        }
    }
    return text;
}

/// Whatever comes out must be consistent; nothing may crash, hang or take memory without end.
TEST(ReadMesh, SurvivesMutatedFiles)
{
    const char* wanted = std::getenv("MESHER_FUZZ_CASES");
    const int cases = wanted != nullptr ? std::atoi(wanted) : 3000;
    const std::string extra = std::string(kTriangle22) + kSize;
    const std::pair<std::string, const char*> seeds[] = {{sample("msh", false), ".msh"},
                                                         {sample("msh", true), ".msh"},
                                                         {sample("msh2", true), ".msh"},
                                                         {extra, ".msh"},
                                                         {sample("vtu", false), ".vtu"},
                                                         {sample("vtu", true), ".vtu"},
                                                         {kVtu, ".vtu"}};
    int accepted = 0;
    for (std::size_t s = 0; s < std::size(seeds); ++s) {
        Random random(1000 + s);
        for (int i = 0; i < cases; ++i) {
            const Result<MeshFile> file = readMeshText(mutated(seeds[s].first, random), seeds[s].second);
            if (!file) {
                EXPECT_FALSE(describe(file.error()).empty());
                continue;
            }
            ++accepted;
            const std::size_t nodeCount = file.value().mesh.nodes.size();
            for (const auto& tet : file.value().mesh.tets) {
                for (const NodeId node : tet.node) ASSERT_LT(node.value, nodeCount);
            }
            for (const auto& triangle : file.value().mesh.triangles) {
                for (const NodeId node : triangle.node) ASSERT_LT(node.value, nodeCount);
            }
            for (const NodalField& field : file.value().fields) ASSERT_EQ(field.values.size(), nodeCount);
        }
    }
    EXPECT_GT(accepted, 0);
}

}  // namespace
}  // namespace mesher
