#include "brep/occt/step_damage.h"

#include <Interface_Check.hxx>
#include <Interface_ReportEntity.hxx>
#include <StepRepr_RepresentationItem.hxx>

#include <string_view>

namespace mesher {

namespace {

/// Points, curves, surfaces, edges, faces and the like.
bool isOfShape(const Handle(Standard_Transient) & entity)
{
    const std::string_view type = entity->DynamicType()->Name();
    return entity->IsKind(STANDARD_TYPE(StepRepr_RepresentationItem)) &&
           (type.starts_with("StepGeom_") || type.starts_with("StepShape_"));
}

}  // namespace

std::optional<std::string> findDamage(const Handle(StepData_StepModel) & model)
{
    for (int i = 1; i <= model->NbEntities(); ++i) {
        if (!model->IsReportEntity(i)) continue;
        const Handle(Interface_Check) check = model->ReportEntity(i)->Check();
        const Handle(Standard_Transient) entity = model->Value(i);
        if (!check->HasFailed() || !isOfShape(entity)) continue;
        return "#" + std::to_string(model->IdentLabel(entity)) + ": " + check->CFail(1);
    }
    return std::nullopt;
}

}  // namespace mesher
