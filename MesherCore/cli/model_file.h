#pragma once

#include "brep/occt/read_model.h"

#include <filesystem>

namespace mesher {

/// Reads the model of a command; tried in a process of its own first unless somebody waits for this one, who tells its crashes.
/// `next` is the stage that follows.
[[nodiscard]] Result<ReadModel> readModelFile(const std::filesystem::path& path, bool heals,
                                              std::string_view next);

}  // namespace mesher
