#pragma once

#include "base/result.h"
#include "io/mesh_reader.h"

#include <string_view>

namespace mesher {

[[nodiscard]] Result<MeshFile> readGmsh(std::string_view text);
[[nodiscard]] Result<MeshFile> readVtu(std::string_view text);

}  // namespace mesher
