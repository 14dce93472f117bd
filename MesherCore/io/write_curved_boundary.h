#pragma once

#include "base/result.h"
#include "mesh/curved_boundary.h"

#include <filesystem>

namespace mesher {

/// Writes the file that docs/formats/curved_boundary.md describes; numbers read back as the same doubles.
[[nodiscard]] Result<void> writeCurvedBoundary(const CurvedBoundary& boundary,
                                               const std::filesystem::path& path);

}  // namespace mesher
