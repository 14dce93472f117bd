#pragma once

#include "io/atomic_file.h"
#include "mesh/curved_boundary.h"

#include <filesystem>

namespace mesher {

/// Writes the file that docs/formats/curved_boundary.md describes, still to be published; numbers read back as the same doubles.
[[nodiscard]] Result<AtomicFile> prepareCurvedBoundary(const CurvedBoundary& boundary,
                                                       const std::filesystem::path& path);

}  // namespace mesher
