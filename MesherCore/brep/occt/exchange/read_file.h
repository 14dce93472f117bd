#pragma once

#include "base/result.h"

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

[[nodiscard]] inline Error unreadableFile(const std::string& name, std::string message,
                                          std::string remedy = "export the model again")
{
    return Error{ErrorCode::Unreadable, std::move(message), name, {}, std::move(remedy)};
}

/// What the module of a file format exports under the name kReadFile.
/// Requires     an OcctSilence alive
/// `content` is the whole file; `name` is what errors call it. IGES is read from the file `name` itself.
using ReadFile = void (*)(const std::string& content, const std::string& name, Result<ShapeFromFile>& result);
constexpr const char* kReadFile = "mesher_read_file";

}  // namespace mesher

extern "C" {
void mesher_read_file(const std::string& content, const std::string& name,
                      mesher::Result<mesher::ShapeFromFile>& result);
}
