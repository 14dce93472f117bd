#include "brep/occt/shape_reader.h"

#include "brep/occt/file_damage.h"
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
#include <StepBasic_Product.hxx>
#include <StepBasic_ProductDefinition.hxx>
#include <StepBasic_ProductDefinitionFormation.hxx>
#include <StepData_StepModel.hxx>
#include <StepRepr_NextAssemblyUsageOccurrence.hxx>
#include <TColStd_SequenceOfAsciiString.hxx>
#include <TCollection_HAsciiString.hxx>

#include <algorithm>
#include <optional>
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
    if (reader.TransferRoots() == 0)
        return unreadable(name, "nothing in it is a shape", "export solids, shells or faces");
    TopoDS_Shape shape = reader.OneShape();
    if (shape.IsNull()) return unreadable(name, "its shape is null");
    return shape;
}

Handle(StepBasic_Product) productOf(const Handle(StepBasic_ProductDefinition) & definition)
{
    if (definition.IsNull() || definition->Formation().IsNull()) return nullptr;
    return definition->Formation()->OfProduct();
}

/// Of the products that others are made of.
std::vector<std::string> partsOf(const Handle(StepData_StepModel) & model)
{
    std::vector<std::string> names;
    for (int i = 1; i <= model->NbEntities(); ++i) {
        const auto use = Handle(StepRepr_NextAssemblyUsageOccurrence)::DownCast(model->Value(i));
        if (use.IsNull()) continue;
        const Handle(StepBasic_Product) product = productOf(use->RelatedProductDefinition());
        if (product.IsNull() || product->Name().IsNull()) continue;
        const std::string name = product->Name()->ToCString();
        if (!name.empty() && std::find(names.begin(), names.end(), name) == names.end())
            names.push_back(name);
    }
    return names;
}

Result<ShapeFromFile> readStep(const std::string& content, const std::string& name)
{
    STEPControl_Reader reader;
    Interface_Static::SetCVal("xstep.cascade.unit", "MM");
    std::istringstream stream(content);
    const IFSelect_ReturnStatus status = reader.ReadStream(name.c_str(), stream);
    if (status != IFSelect_RetDone)
        return unreadable(name, "the STEP file cannot be read: " + reasonOf(status));
    if (const std::optional<std::string> damage = findDamage(reader.StepModel()))
        return unreadable(name, "the STEP file is damaged at " + *damage);
    Result<TopoDS_Shape> shape = transfer(reader, name);
    if (!shape) return shape.error();
    TColStd_SequenceOfAsciiString lengths, angles, solidAngles;
    reader.FileUnits(lengths, angles, solidAngles);
    return ShapeFromFile{*std::move(shape), lengths.IsEmpty() ? "" : lengths.First().ToCString(),
                         partsOf(reader.StepModel())};
}

Result<ShapeFromFile> readIges(const std::string& name)
{
    IGESControl_Reader reader;
    Interface_Static::SetCVal("xstep.cascade.unit", "MM");
    const IFSelect_ReturnStatus status = reader.ReadFile(name.c_str());
    if (status != IFSelect_RetDone)
        return unreadable(name, "the IGES file cannot be read: " + reasonOf(status));
    if (const std::optional<std::string> damage = findDamage(reader.IGESModel()))
        return unreadable(name, "the IGES file is damaged at " + *damage);
    Result<TopoDS_Shape> shape = transfer(reader, name);
    if (!shape) return shape.error();
    const Handle(TCollection_HAsciiString) unit = reader.IGESModel()->GlobalSection().UnitName();
    return ShapeFromFile{*std::move(shape), unit.IsNull() ? "" : unit->ToCString(), {}};
}

/// The kernel's BREP readers go on, without end, when a stream fails: this one throws instead.
std::istringstream throwingStream(const std::string& content)
{
    std::istringstream stream(content);
    stream.exceptions(std::ios::failbit | std::ios::badbit);
    return stream;
}

ShapeFromFile readText(const std::string& content)
{
    const StandardOutputSilence silence;
    // The blank keeps the last number from ending at the end of the stream.
    std::istringstream stream = throwingStream(content + "\n");
    TopoDS_Shape shape;
    BRepTools::Read(shape, stream, BRep_Builder());
    return {shape, "", {}};
}

/// After the shapes OCCT names the root by a sign and two integers, FreeCAD by three integers.
ShapeFromFile readBinary(const std::string& content)
{
    constexpr std::size_t kFreeCadTrailer = 3 * sizeof(std::int32_t);
    std::istringstream stream = throwingStream(content);
    BinTools_ShapeSet set;
    set.Read(stream);
    if (set.NbShapes() == 0) return {};
    const auto position = static_cast<std::size_t>(stream.tellg());
    if (content.size() - position != kFreeCadTrailer) {
        std::istringstream again = throwingStream(content);
        TopoDS_Shape shape;
        BinTools::Read(shape, again);
        return {shape, "", {}};
    }
    int index = 0, location = 0, orientation = 0;
    BinTools::GetInteger(stream, index);
    BinTools::GetInteger(stream, location);
    BinTools::GetInteger(stream, orientation);
    const bool isValid = 1 <= index && index <= set.NbShapes() && 0 <= location &&
                         location <= set.Locations().NbLocations() && TopAbs_FORWARD <= orientation &&
                         orientation <= TopAbs_EXTERNAL;
    if (!isValid) return {};
    TopoDS_Shape shape = set.Shape(index);
    shape.Location(set.Locations().Location(location));
    shape.Orientation(static_cast<TopAbs_Orientation>(orientation));
    return {shape, "", {}};
}

/// Runs one of the two readers of BREP; a null shape from it means damage, as does an end of the stream before its own.
template <class Read>
Result<ShapeFromFile> readBrep(const std::string& name, Read read)
{
    const Error damaged = unreadable(name, "the BREP is truncated or damaged");
    try {
        ShapeFromFile result = read();
        if (result.shape.IsNull()) return damaged;
        return result;
    } catch (const std::ios_base::failure&) {
        return damaged;
    }
}

}  // namespace

Result<ShapeFromFile> readShape(ModelFormat format, const std::string& content, const std::string& name)
{
    return guarded(name, kExportRemedy, [&]() -> Result<ShapeFromFile> {
        switch (format) {
            case ModelFormat::Step: return readStep(content, name);
            case ModelFormat::Iges: return readIges(name);
            case ModelFormat::BrepText: return readBrep(name, [&] { return readText(content); });
            case ModelFormat::BrepBinary: return readBrep(name, [&] { return readBinary(content); });
        }
        return unreadable(name, "its format is unknown");
    });
}

}  // namespace mesher
