#pragma once

#include <Interface_InterfaceModel.hxx>

#include <optional>
#include <string>

namespace mesher {

/// Whether an entity is a point, curve, surface, edge, face or the like; its format knows.
using IsOfShape = bool (*)(const Handle(Standard_Transient) & entity);

/// What keeps the shapes of a STEP or IGES file that has been read from being made: the first entity of geometry or topology that is not
/// as its schema wants it. The kernel reads past such entities and later ends the process at what they lack.
/// Faults of names, styles and texts, which many files have, are passed over.
[[nodiscard]] std::optional<std::string> findDamage(const Handle(Interface_InterfaceModel) & model,
                                                    IsOfShape isOfShape);

}  // namespace mesher
