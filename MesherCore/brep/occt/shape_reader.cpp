#include "brep/occt/shape_reader.h"

#include "brep/occt/occt_error.h"

#include <BRepTools.hxx>
#include <BRep_Builder.hxx>
#include <BinTools.hxx>
#include <BinTools_ShapeSet.hxx>
#include <IFSelect_ReturnStatus.hxx>
#include <IGESControl_Reader.hxx>
#include <IGESData_GlobalSection.hxx>
#include <IGESData_IGESModel.hxx>
#include <Interface_Static.hxx>
#include <STEPControl_Reader.hxx>
#include <TColStd_SequenceOfAsciiString.hxx>
#include <TCollection_HAsciiString.hxx>

#include <sstream>
#include <utility>

namespace mesher {

namespace {

constexpr const char* kExportRemedy = "export the model again";

Error unreadable(const std::string& name, std::string message, std::string remedy = kExportRemedy)
{
    return Error{ErrorCode::Unreadable, std::move(message), name, {}, std::move(remedy)};
}

std::string reasonOf(IFSelect_ReturnStatus status)
{
    switch (status) {
        case IFSelect_RetVoid: return "it has no content";
        case IFSelect_RetError: return "it is no valid file of its format";
        case IFSelect_RetFail: return "its entities cannot be read";
        case IFSelect_RetStop: return "reading was stopped";
        default: return "unknown status";
    }
}

template <class Reader>
Result<TopoDS_Shape> transfer(Reader& reader, const std::string& name)
{
    if (reader.TransferRoots() == 0) return unreadable(name, "nothing in it is a shape", "export solids, shells or faces");
    TopoDS_Shape shape = reader.OneShape();
    if (shape.IsNull()) return unreadable(name, "its shape is null");
    return shape;
}

Result<ShapeFromFile> readStep(const std::string& content, const std::string& name)
{
    STEPControl_Reader reader;
    Interface_Static::SetCVal("xstep.cascade.unit", "MM");
    std::istringstream stream(content);
    const IFSelect_ReturnStatus status = reader.ReadStream(name.c_str(), stream);
    if (status != IFSelect_RetDone) return unreadable(name, "the STEP file cannot be read: " + reasonOf(status));
    Result<TopoDS_Shape> shape = transfer(reader, name);
    if (!shape) return shape.error();
    TColStd_SequenceOfAsciiString lengths, angles, solidAngles;
    reader.FileUnits(lengths, angles, solidAngles);
    return ShapeFromFile{*std::move(shape), lengths.IsEmpty() ? "" : lengths.First().ToCString()};
}

Result<ShapeFromFile> readIges(const std::string& name)
{
    IGESControl_Reader reader;
    Interface_Static::SetCVal("xstep.cascade.unit", "MM");
    const IFSelect_ReturnStatus status = reader.ReadFile(name.c_str());
    if (status != IFSelect_RetDone) return unreadable(name, "the IGES file cannot be read: " + reasonOf(status));
    Result<TopoDS_Shape> shape = transfer(reader, name);
    if (!shape) return shape.error();
    const Handle(TCollection_HAsciiString) unit = reader.IGESModel()->GlobalSection().UnitName();
    return ShapeFromFile{*std::move(shape), unit.IsNull() ? "" : unit->ToCString()};
}

/// The kernel's BREP readers go on, without end, when a stream fails: this one throws instead.
std::istringstream throwingStream(const std::string& content)
{
    std::istringstream stream(content);
    stream.exceptions(std::ios::failbit | std::ios::badbit);
    return stream;
}

Result<ShapeFromFile> readText(const std::string& content, const std::string& name)
{
    // The blank keeps the last number from ending at the end of the stream.
    std::istringstream stream = throwingStream(content + "\n");
    TopoDS_Shape shape;
    BRepTools::Read(shape, stream, BRep_Builder());
    if (shape.IsNull()) return unreadable(name, "the BREP text is truncated or damaged");
    return ShapeFromFile{shape, ""};
}

/// After the shapes OCCT names the root by a sign and two integers, FreeCAD by three integers.
Result<ShapeFromFile> readBinary(const std::string& content, const std::string& name)
{
    constexpr std::size_t kFreeCadTrailer = 3 * sizeof(std::int32_t);
    const Error damaged = unreadable(name, "the binary BREP is truncated or damaged");
    std::istringstream stream = throwingStream(content);
    BinTools_ShapeSet set;
    set.Read(stream);
    if (set.NbShapes() == 0) return damaged;
    const auto position = static_cast<std::size_t>(stream.tellg());
    if (content.size() - position != kFreeCadTrailer) {
        std::istringstream again = throwingStream(content);
        TopoDS_Shape shape;
        BinTools::Read(shape, again);
        if (shape.IsNull()) return damaged;
        return ShapeFromFile{shape, ""};
    }
    int index = 0, location = 0, orientation = 0;
    BinTools::GetInteger(stream, index);
    BinTools::GetInteger(stream, location);
    BinTools::GetInteger(stream, orientation);
    const bool isValid = 1 <= index && index <= set.NbShapes() && 0 <= location &&
                         location <= set.Locations().NbLocations() && TopAbs_FORWARD <= orientation &&
                         orientation <= TopAbs_EXTERNAL;
    if (!isValid) return damaged;
    TopoDS_Shape shape = set.Shape(index);
    shape.Location(set.Locations().Location(location));
    shape.Orientation(static_cast<TopAbs_Orientation>(orientation));
    return ShapeFromFile{shape, ""};
}

}  // namespace

Result<ShapeFromFile> readShape(ModelFormat format, const std::string& content, const std::string& name)
{
    return guarded(name, kExportRemedy, [&]() -> Result<ShapeFromFile> {
        switch (format) {
            case ModelFormat::Step: return readStep(content, name);
            case ModelFormat::Iges: return readIges(name);
            case ModelFormat::BrepText: return readText(content, name);
            case ModelFormat::BrepBinary: return readBinary(content, name);
        }
        return unreadable(name, "its format is unknown");
    });
}

}  // namespace mesher
