#pragma once

#include "base/result.h"
#include "brep/occt/exchange/read_file.h"
#include "brep/occt/model_format.h"

#include <string>

namespace mesher {

/// Loads what the reader of a format needs, so that processes that are forked afterwards have it.
[[nodiscard]] Result<void> prepareReader(ModelFormat format);

/// Requires     an OcctSilence alive
/// `content` is the whole file; `name` is what errors call it. IGES is read from the file `name` itself.
[[nodiscard]] Result<ShapeFromFile> readShape(ModelFormat format, const std::string& content,
                                              const std::string& name);

}  // namespace mesher
