#pragma once

#include "base/result.h"

#include <filesystem>
#include <string_view>

namespace mesher {

/// Writes a whole file, which appears complete or not at all (AtomicFile).
[[nodiscard]] Result<void> writeTextFile(std::string_view text, const std::filesystem::path& path);

}  // namespace mesher
