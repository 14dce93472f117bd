// Writes the hard solid of a seed as a file, or argues about a file whether its shape is sound:
//   make_hard_solid SEED FILE.brep|FILE.step     prints the recipe; ends with 1 if the kernel cannot make it, or read it again
//   make_hard_solid --check FILE.brep|FILE.step  prints "valid" and "crosses-itself" where they hold, by the kernel's checks

#include "hard_solids.h"

#include <BOPAlgo_ArgumentAnalyzer.hxx>
#include <BRepCheck_Analyzer.hxx>
#include <BRepTools.hxx>
#include <BRep_Builder.hxx>
#include <Message.hxx>
#include <Message_Messenger.hxx>
#include <Message_Printer.hxx>
#include <STEPControl_Reader.hxx>
#include <STEPControl_Writer.hxx>

#include <algorithm>
#include <cstdlib>
#include <iostream>
#include <string>

namespace {

bool write(const TopoDS_Shape& shape, const std::string& path)
{
    if (path.ends_with(".brep")) return BRepTools::Write(shape, path.c_str());
    STEPControl_Writer writer;
    return writer.Transfer(shape, STEPControl_AsIs) == IFSelect_RetDone &&
           writer.Write(path.c_str()) == IFSelect_RetDone;
}

/// Null if the kernel cannot.
TopoDS_Shape read(const std::string& path)
{
    TopoDS_Shape shape;
    if (path.ends_with(".brep")) {
        const BRep_Builder builder;
        BRepTools::Read(shape, path.c_str(), builder);
        return shape;
    }
    STEPControl_Reader reader;
    if (reader.ReadFile(path.c_str()) != IFSelect_RetDone || reader.TransferRoots() == 0) return shape;
    return reader.OneShape();
}

bool crossesItself(const TopoDS_Shape& shape)
{
    BOPAlgo_ArgumentAnalyzer analyzer;
    analyzer.SetShape1(shape);
    analyzer.ArgumentTypeMode() = false;
    analyzer.SelfInterMode() = true;
    analyzer.Perform();
    const BOPAlgo_ListOfCheckResult& results = analyzer.GetCheckResult();
    return std::any_of(results.begin(), results.end(), [](const BOPAlgo_CheckResult& result) {
        return result.GetCheckStatus() == BOPAlgo_SelfIntersect;
    });
}

}  // namespace

int main(int count, char** words)
{
    if (count != 3) return 2;
    Message::DefaultMessenger()->RemovePrinters(STANDARD_TYPE(Message_Printer));
    if (std::string(words[1]) == "--check") {
        const TopoDS_Shape shape = read(words[2]);
        if (shape.IsNull()) return 1;
        if (BRepCheck_Analyzer(shape).IsValid()) std::cout << "valid\n";
        if (crossesItself(shape)) std::cout << "crosses-itself\n";
        return 0;
    }
    const mesher::test::HardSolid solid = mesher::test::hardSolid(std::strtoull(words[1], nullptr, 10));
    std::cout << solid.recipe << '\n';
    return !solid.shape.IsNull() && write(solid.shape, words[2]) && !read(words[2]).IsNull() ? 0 : 1;
}
