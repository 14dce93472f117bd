#pragma once

#include "base/result.h"

#include <filesystem>
#include <string>

namespace mesher {

/// The content of a file.
/// Refuses      with ErrorCode::Unreadable and the path: a missing or empty file, a folder, what may not be or cannot be read
[[nodiscard]] Result<std::string> readWholeFile(const std::filesystem::path& path);

}  // namespace mesher
