#include "base/random.h"
#include "brep/occt/read_model.h"
#include "occt_models.h"
#include "support/temp_dir.h"
#include "support/test_effort.h"

#include <BRepTools.hxx>
#include <BinTools.hxx>
#include <BinTools_ShapeSet.hxx>
#include <IGESControl_Writer.hxx>
#include <Message.hxx>
#include <STEPControl_Writer.hxx>

#include <gtest/gtest.h>

#include <fstream>
#include <iterator>
#include <sstream>

namespace mesher {

namespace {

namespace fs = std::filesystem;

std::string textOf(const TopoDS_Shape& shape)
{
    std::ostringstream stream;
    BRepTools::Write(shape, stream);
    return stream.str();
}

std::string binaryOf(const TopoDS_Shape& shape)
{
    std::ostringstream stream;
    BinTools::Write(shape, stream);
    return stream.str();
}

/// As FreeCAD's exportBinary writes it.
std::string freeCadBinaryOf(const TopoDS_Shape& shape)
{
    std::ostringstream stream;
    BinTools_ShapeSet set;
    const int index = set.Add(shape);
    set.Write(stream);
    BinTools::PutInteger(stream, index);
    BinTools::PutInteger(stream, set.Locations().Index(shape.Location()));
    BinTools::PutInteger(stream, static_cast<int>(shape.Orientation()));
    return stream.str();
}

std::string contentOf(const fs::path& path)
{
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
}

std::string stepOf(const TopoDS_Shape& shape)
{
    const test::TempDir folder;
    Message::DefaultMessenger()->ChangePrinters().Clear();
    STEPControl_Writer writer;
    writer.Transfer(shape, STEPControl_AsIs);
    writer.Write((folder.path() / "model.step").c_str());
    return contentOf(folder.path() / "model.step");
}

Result<ReadModel> readText(const std::string& content, const std::string& fileName = "model.bin")
{
    const test::TempDir folder;
    const fs::path path = folder.path() / fileName;
    std::ofstream(path, std::ios::binary) << content;
    return readModel(path);
}

Result<ReadModel> fromMemory(const std::string& content)
{
    return readModelFromMemory(std::as_bytes(std::span(content)), "the stream");
}

void expectPlate(const Result<ReadModel>& read, const std::string& format)
{
    ASSERT_TRUE(read) << describe(read.error());
    EXPECT_EQ(read->format, format);
    EXPECT_EQ(read->model.solids.size(), 1u);
    EXPECT_EQ(read->model.faces.size(), 9u);
    EXPECT_NEAR(read->model.box.extent().x, 6.0, 1e-6);
    EXPECT_NEAR(read->model.box.extent().z, 0.5, 1e-6);
    EXPECT_FALSE(read->shape->IsNull());
}

}  // namespace

TEST(ReadModel, TellsFormatsByContentWhateverTheName)
{
    const TopoDS_Shape plate = test::drilledPlate();
    expectPlate(readText(textOf(plate), "a.step"), "BREP text");
    expectPlate(readText(binaryOf(plate), "a.brep"), "BREP binary");
    expectPlate(readText(freeCadBinaryOf(plate), "a.igs"), "BREP binary");
    expectPlate(readText(stepOf(plate), "a.brep"), "STEP");
    expectPlate(fromMemory(freeCadBinaryOf(plate)), "BREP binary");
    expectPlate(fromMemory(textOf(plate)), "BREP text");
    expectPlate(fromMemory(stepOf(plate)), "STEP");
}

TEST(ReadModel, BinaryIsBitExact)
{
    const TopoDS_Shape plate = test::drilledPlate();
    const BrepModel before = readModelFromShape(plate).value().model;
    for (const std::string& content : {binaryOf(plate), freeCadBinaryOf(plate)}) {
        const BrepModel after = fromMemory(content).value().model;
        ASSERT_EQ(after.edges.size(), before.edges.size());
        for (std::uint32_t i = 0; i < before.edges.size(); ++i) {
            const BrepEdge& a = before.edges[BrepEdgeId(i)];
            const BrepEdge& b = after.edges[BrepEdgeId(i)];
            EXPECT_EQ(a.part, b.part);
            EXPECT_EQ(a.curve->position(a.part.at(0.3)), b.curve->position(b.part.at(0.3)));
        }
    }
}

TEST(ReadModel, FreeCadBinaryKeepsPlacementAndOrientation)
{
    gp_Trsf shift;
    shift.SetTranslation(gp_Vec(5.0, 0.0, 0.0));
    const TopoDS_Shape moved = test::drilledPlate().Moved(TopLoc_Location(shift)).Reversed();
    const Result<ReadModel> read = fromMemory(freeCadBinaryOf(moved));
    ASSERT_TRUE(read);
    EXPECT_NEAR(read->model.box.low.x, 5.0, 1e-6);
    EXPECT_EQ(read->shape->Orientation(), moved.Orientation());
}

TEST(ReadModel, StepComesInMillimetresAndTellsItsUnit)
{
    std::string content = stepOf(test::drilledPlate());
    EXPECT_EQ(fromMemory(content)->fileUnit, "millimetre");
    const std::string millimetre = "SI_UNIT(.MILLI.,.METRE.)";
    const std::size_t place = content.find(millimetre);
    ASSERT_NE(place, std::string::npos);
    content.replace(place, millimetre.size(), "SI_UNIT($,.METRE.)");
    const Result<ReadModel> read = fromMemory(content);
    ASSERT_TRUE(read);
    EXPECT_EQ(read->fileUnit, "metre");
    EXPECT_EQ(read->model.unit, "mm");
    EXPECT_NEAR(read->model.box.extent().x, 6000.0, 1e-3);
}

TEST(ReadModel, ReadsIges)
{
    const test::TempDir folder;
    const fs::path path = folder.path() / "model.igs";
    IGESControl_Writer writer("MM", 1);
    writer.AddShape(test::drilledPlate());
    writer.Write(path.c_str());
    const Result<ReadModel> read = readModel(path);
    ASSERT_TRUE(read) << describe(read.error());
    EXPECT_EQ(read->format, "IGES");
    EXPECT_EQ(read->model.faces.size(), 9u);
    const std::string content = contentOf(path);
    EXPECT_FALSE(fromMemory(content));
    EXPECT_FALSE(readText(content.substr(0, content.size() / 2)));

    // A loop of a face becomes a point.
    std::string damaged = content;
    for (int line = 0; line < 2; ++line) {
        const std::size_t loop = damaged.find("\n     508");
        ASSERT_NE(loop, std::string::npos);
        damaged.replace(loop, 9, "\n     116");
    }
    std::ofstream(path) << damaged;
    const Result<ReadModel> refused = readModel(path);
    ASSERT_FALSE(refused);
    EXPECT_NE(refused.error().message.find("the IGES file is damaged at D"), std::string::npos)
        << describe(refused.error());
}

/// Some of these crash the kernel's own reader.
TEST(ReadModel, EndsOnDamagedIges)
{
    const test::TempDir folder;
    const fs::path path = folder.path() / "model.igs";
    IGESControl_Writer writer("MM", 1);
    writer.AddShape(test::drilledPlate());
    writer.Write(path.c_str());
    const std::string content = contentOf(path);
    int refused = 0;
    for (int round = 0; round < test::repetitions(100); ++round) {
        SCOPED_TRACE("round " + std::to_string(round));
        Random random(static_cast<std::uint64_t>(round));
        std::string damaged = content;
        for (int change = 0; change < 4; ++change) {
            std::size_t at = random.below(static_cast<std::uint32_t>(damaged.size()));
            at = damaged.find_first_of("0123456789", at);
            if (at != std::string::npos) damaged[at] = static_cast<char>('0' + random.below(10));
        }
        std::ofstream(path) << damaged;
        if (!readModel(path)) ++refused;
    }
    EXPECT_GT(refused, 0);
}

TEST(ReadModel, BadFilesAreOneErrorWithFileAndRemedy)
{
    const test::TempDir folder;
    const auto expectError = [](const Result<ReadModel>& read, const std::string& entity) {
        ASSERT_FALSE(read);
        EXPECT_EQ(read.error().code, ErrorCode::Unreadable) << describe(read.error());
        EXPECT_NE(read.error().entity.find(entity), std::string::npos) << describe(read.error());
        EXPECT_FALSE(read.error().remedy.empty()) << describe(read.error());
    };
    expectError(readModel(folder.path() / "missing.step"), "missing.step");
    expectError(readModel(folder.path()), folder.path().string());
    expectError(readText("", "empty.step"), "empty.step");
    expectError(readText("solid of nothing\n", "wrong.stl"), "wrong.stl");
    expectError(readText(std::string(5000, '\0'), "zeros.brep"), "zeros.brep");
    expectError(
        readText("ISO-10303-21;\nHEADER;\nENDSEC;\nDATA;\nENDSEC;\nEND-ISO-10303-21;\n", "hollow.step"),
        "hollow.step");
    expectError(readText("ISO-10303-21;\nnonsense $$$ (((\nEND-ISO-10303-21;\n", "nonsense.step"),
                "nonsense.step");
    expectError(readText("\nCASCADE Topology V1, (c) Matra-Datavision\nLocations 0\nnonsense\nTShapes 99\n",
                         "bad.brep"),
                "bad.brep");
    expectError(fromMemory(""), "the stream");
}

TEST(ReadModel, TruncatedFilesAreRefusedWhereverTheyEnd)
{
    const TopoDS_Shape plate = test::drilledPlate();
    for (const std::string& whole : {textOf(plate), binaryOf(plate), freeCadBinaryOf(plate), stepOf(plate)}) {
        for (const double share : {0.001, 0.01, 0.1, 0.3, 0.5, 0.7, 0.9, 0.97, 0.99}) {
            const auto size = static_cast<std::size_t>(share * static_cast<double>(whole.size()));
            const Result<ReadModel> read = fromMemory(whole.substr(0, size));
            EXPECT_FALSE(read) << size << " of " << whole.size() << ": " << whole.substr(0, 30);
        }
    }
}

TEST(ReadModel, NothingIsPrinted)
{
    const std::string step = stepOf(test::drilledPlate());
    testing::internal::CaptureStdout();
    testing::internal::CaptureStderr();
    EXPECT_TRUE(readText(step));
    EXPECT_FALSE(readText(step.substr(0, step.size() / 2)));
    EXPECT_FALSE(readText("ISO-10303-21;\nnonsense $$$ (((\nEND-ISO-10303-21;\n"));
    EXPECT_FALSE(
        readText("\nCASCADE Topology V1, (c) Matra-Datavision\nLocations 0\nnonsense\nTShapes 99\n"));
    EXPECT_FALSE(readText(binaryOf(test::drilledPlate()).substr(0, 3000)));
    EXPECT_EQ(testing::internal::GetCapturedStdout(), "");
    EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
}

TEST(ReadModel, HealingIsDoneOnRequestAndReported)
{
    // A wire whose last edge runs the wrong way: healing turns it and says so.
    const TopoDS_Face bowTie = test::rawFace(test::polygon({{0, 0, 0}, {0, 1, 0}, {1, 1, 0}, {1, 0, 0}}));
    const Result<ReadModel> asIs = readModelFromShape(bowTie);
    ASSERT_TRUE(asIs);
    const Result<ReadModel> healed = readModelFromShape(bowTie, {true});
    ASSERT_TRUE(healed) << describe(healed.error());
    EXPECT_FALSE(healed->model.notes.empty());
}

}  // namespace mesher
