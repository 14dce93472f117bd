#include "brep/occt/exchange/file_damage.h"
#include "brep/occt/exchange/transfer.h"

#include <Interface_Static.hxx>
#include <STEPControl_Reader.hxx>
#include <StepBasic_Product.hxx>
#include <StepBasic_ProductDefinition.hxx>
#include <StepBasic_ProductDefinitionFormation.hxx>
#include <StepData_StepModel.hxx>
#include <StepRepr_NextAssemblyUsageOccurrence.hxx>
#include <StepRepr_RepresentationItem.hxx>
#include <TColStd_SequenceOfAsciiString.hxx>
#include <TCollection_HAsciiString.hxx>

#include <algorithm>
#include <optional>
#include <sstream>
#include <string_view>

namespace mesher {

namespace {

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

bool isOfShape(const Handle(Standard_Transient) & entity)
{
    const std::string_view type = entity->DynamicType()->Name();
    return entity->IsKind(STANDARD_TYPE(StepRepr_RepresentationItem)) &&
           (type.starts_with("StepGeom_") || type.starts_with("StepShape_"));
}

Result<ShapeFromFile> readStep(const std::string& content, const std::string& name)
{
    STEPControl_Reader reader;
    Interface_Static::SetCVal("xstep.cascade.unit", "MM");
    std::istringstream stream(content);
    const IFSelect_ReturnStatus status = reader.ReadStream(name.c_str(), stream);
    if (status != IFSelect_RetDone)
        return unreadableFile(name, "the STEP file cannot be read: " + reasonOf(status));
    if (const std::optional<std::string> damage = findDamage(reader.StepModel(), isOfShape))
        return unreadableFile(name, "the STEP file is damaged at " + *damage);
    Result<TopoDS_Shape> shape = transfer(reader, name);
    if (!shape) return shape.error();
    TColStd_SequenceOfAsciiString lengths, angles, solidAngles;
    reader.FileUnits(lengths, angles, solidAngles);
    return ShapeFromFile{*std::move(shape), lengths.IsEmpty() ? "" : lengths.First().ToCString(),
                         partsOf(reader.StepModel())};
}

}  // namespace

}  // namespace mesher

void mesher_read_file(const std::string& content, const std::string& name,
                      mesher::Result<mesher::ShapeFromFile>& result)
{
    result = mesher::readStep(content, name);
}
