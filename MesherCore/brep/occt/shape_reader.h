#pragma once

#include "base/result.h"
#include "brep/occt/model_format.h"

#include <TopoDS_Shape.hxx>

#include <string>
#include <vector>

namespace mesher {

struct ShapeFromFile
{
    TopoDS_Shape shape;
    std::string
        unit;  ///< that the file states, "" if none; lengths are converted to millimetres all the same
    std::vector<std::string> parts;  ///< names of the parts of an assembly in STEP, in the order of the file
};

/// Requires     an OcctSilence alive
/// `content` is the whole file; `name` is what errors call it. IGES is read from the file `name` itself.
[[nodiscard]] Result<ShapeFromFile> readShape(ModelFormat format, const std::string& content,
                                              const std::string& name);

}  // namespace mesher
