#pragma once

#include "base/result.h"
#include "base/vec.h"

#include <filesystem>
#include <string_view>
#include <vector>

namespace mesher {

struct SizePoint
{
    Vec3 position;
    double size = 0.0;
};

/// Reads points with sizes: text with a line "x y z size" for each, in model units; empty lines and what follows a # are skipped.
/// Guarantees   at least one point; positive, finite sizes and finite places
/// Refuses      with ErrorCode::Unreadable, the path and the line: everything else
[[nodiscard]] Result<std::vector<SizePoint>> readSizePoints(const std::filesystem::path& path);

/// The same from memory.
[[nodiscard]] Result<std::vector<SizePoint>> readSizePointsText(std::string_view content);

}  // namespace mesher
