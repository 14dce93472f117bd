#pragma once

#include "base/result.h"
#include "io/file_buffer.h"
#include "mesh/classified_mesh.h"

namespace mesher {

[[nodiscard]] Result<void> writeGmsh41(const ClassifiedMesh& mesh, FileBuffer& out);
[[nodiscard]] Result<void> writeGmsh22(const ClassifiedMesh& mesh, FileBuffer& out);
[[nodiscard]] Result<void> writeVtu(const ClassifiedMesh& mesh, FileBuffer& out);
[[nodiscard]] Result<void> writeVtkText(const ClassifiedMesh& mesh, FileBuffer& out);
[[nodiscard]] Result<void> writeVtkBinary(const ClassifiedMesh& mesh, FileBuffer& out);
[[nodiscard]] Result<void> writeSu2(const ClassifiedMesh& mesh, FileBuffer& out);
[[nodiscard]] Result<void> writeStlText(const ClassifiedMesh& mesh, FileBuffer& out);
[[nodiscard]] Result<void> writeStlBinary(const ClassifiedMesh& mesh, FileBuffer& out);
[[nodiscard]] Result<void> writePly(const ClassifiedMesh& mesh, FileBuffer& out);
[[nodiscard]] Result<void> writeAbaqusInp(const ClassifiedMesh& mesh, FileBuffer& out);
[[nodiscard]] Result<void> writeUnv(const ClassifiedMesh& mesh, FileBuffer& out);
[[nodiscard]] Result<void> writePng(const ClassifiedMesh& mesh, FileBuffer& out);

}  // namespace mesher
