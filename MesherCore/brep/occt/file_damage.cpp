#include "brep/occt/file_damage.h"

#include <Interface_Check.hxx>
#include <Interface_ReportEntity.hxx>
#include <StepRepr_RepresentationItem.hxx>
#include <TCollection_HAsciiString.hxx>

#include <string_view>

namespace mesher {

namespace {

/// Points, curves, surfaces, edges, faces and the like.
bool isOfShape(const Handle(Standard_Transient) & entity)
{
    const std::string_view type = entity->DynamicType()->Name();
    if (type.starts_with("IGESGeom_") || type.starts_with("IGESSolid_")) return true;
    return entity->IsKind(STANDARD_TYPE(StepRepr_RepresentationItem)) &&
           (type.starts_with("StepGeom_") || type.starts_with("StepShape_"));
}

/// Some texts of the kernel for IGES are not to be found by it, or not filled in.
std::string reasonOf(const std::string& text)
{
    const bool isWhole =
        text.find("Unknown message") == std::string::npos && text.find('%') == std::string::npos;
    return isWhole ? text : "the entity is not as the format wants it";
}

}  // namespace

std::optional<std::string> findDamage(const Handle(Interface_InterfaceModel) & model)
{
    for (int i = 1; i <= model->NbEntities(); ++i) {
        if (!model->IsReportEntity(i)) continue;
        const Handle(Interface_Check) check = model->ReportEntity(i)->Check();
        const Handle(Standard_Transient) entity = model->Value(i);
        if (!check->HasFailed() || !isOfShape(entity)) continue;
        const Handle(TCollection_HAsciiString) label = model->StringLabel(entity);
        return std::string(label->ToCString()) + ": " + reasonOf(check->CFail(1));
    }
    return std::nullopt;
}

}  // namespace mesher
