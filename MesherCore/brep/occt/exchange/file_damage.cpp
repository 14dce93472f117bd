#include "brep/occt/exchange/file_damage.h"

#include <Interface_Check.hxx>
#include <Interface_ReportEntity.hxx>
#include <TCollection_HAsciiString.hxx>

#include <algorithm>
#include <array>
#include <string_view>

namespace mesher {

namespace {

/// Fields that say nothing about where a shape is: the schema wants them, many writers leave them unset, and the kernel's readers do
/// without. The kernel tells of a field by its name in parentheses.
constexpr std::array<std::string_view, 12> kIdleFields = {"(name)",
                                                          "(description)",
                                                          "(representation_item.name)",
                                                          "(representation_item_name)",
                                                          "(self_intersect)",
                                                          "(closed_curve)",
                                                          "(curve_form)",
                                                          "(knot_spec)",
                                                          "(u_closed)",
                                                          "(v_closed)",
                                                          "(surface_form)",
                                                          "(master_representation)"};

bool isOfIdleField(std::string_view text)
{
    return std::any_of(kIdleFields.begin(), kIdleFields.end(),
                       [&](std::string_view field) { return text.find(field) != std::string_view::npos; });
}

/// The first failure that is about what the shape needs.
std::optional<std::string> failureOf(const Interface_Check& check)
{
    for (int i = 1; i <= check.NbFails(); ++i) {
        const std::string text = check.CFail(i);
        if (!isOfIdleField(text)) return text;
    }
    return std::nullopt;
}

/// Some texts of the kernel for IGES are not to be found by it, or not filled in.
std::string reasonOf(const std::string& text)
{
    const bool isWhole =
        text.find("Unknown message") == std::string::npos && text.find('%') == std::string::npos;
    return isWhole ? text : "the entity is not as the format wants it";
}

}  // namespace

std::optional<std::string> findDamage(const Handle(Interface_InterfaceModel) & model, IsOfShape isOfShape)
{
    for (int i = 1; i <= model->NbEntities(); ++i) {
        if (!model->IsReportEntity(i)) continue;
        const Handle(Interface_Check) check = model->ReportEntity(i)->Check();
        const Handle(Standard_Transient) entity = model->Value(i);
        if (!check->HasFailed() || !isOfShape(entity)) continue;
        const std::optional<std::string> failure = failureOf(*check);
        if (!failure) continue;
        const Handle(TCollection_HAsciiString) label = model->StringLabel(entity);
        return std::string(label->ToCString()) + ": " + reasonOf(*failure);
    }
    return std::nullopt;
}

}  // namespace mesher
