#pragma once

#include "base/result.h"

#include <TopoDS_Shape.hxx>

#include <string>
#include <vector>

namespace mesher {

struct RepairedShape
{
    TopoDS_Shape shape;
    std::vector<std::string> changes;  ///< one clause each, with the entity's name in the shape as it was
};

/// The kernel's repair (ShapeFix) on the user's wish, with what it changed.
[[nodiscard]] Result<RepairedShape> repairShape(const TopoDS_Shape& shape);

}  // namespace mesher
