#pragma once

#include "base/result.h"
#include "brep/brep_model.h"

#include <TopoDS_Shape.hxx>

namespace mesher {

/// The topology and geometry of a shape as the mesher asks for them.
///
/// Guarantees   entities are numbered as TopExp::MapShapes numbers those of the whole shape; notes name every edge off its
///              faces or vertices by more than the tolerance, open wire and edge without curve
/// Requires     a shape with a face, every face with a finite surface and wire, every edge with vertices; else an Error that
///              names the entity
[[nodiscard]] Result<BrepModel> buildModel(const TopoDS_Shape& shape);

}  // namespace mesher
