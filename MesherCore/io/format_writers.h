#pragma once

#include "base/result.h"
#include "io/file_buffer.h"
#include "io/write_options.h"
#include "mesh/classified_mesh.h"

namespace mesher {

[[nodiscard]] Result<void> writeGmsh41(const ClassifiedMesh& mesh, FileBuffer& out,
                                       const WriteOptions& options);
[[nodiscard]] Result<void> writeGmsh22(const ClassifiedMesh& mesh, FileBuffer& out,
                                       const WriteOptions& options);
[[nodiscard]] Result<void> writeVtu(const ClassifiedMesh& mesh, FileBuffer& out, const WriteOptions& options);
[[nodiscard]] Result<void> writeVtkText(const ClassifiedMesh& mesh, FileBuffer& out,
                                        const WriteOptions& options);
[[nodiscard]] Result<void> writeVtkBinary(const ClassifiedMesh& mesh, FileBuffer& out,
                                          const WriteOptions& options);
[[nodiscard]] Result<void> writeSu2(const ClassifiedMesh& mesh, FileBuffer& out, const WriteOptions& options);
[[nodiscard]] Result<void> writeStlText(const ClassifiedMesh& mesh, FileBuffer& out,
                                        const WriteOptions& options);
[[nodiscard]] Result<void> writeStlBinary(const ClassifiedMesh& mesh, FileBuffer& out,
                                          const WriteOptions& options);
[[nodiscard]] Result<void> writePly(const ClassifiedMesh& mesh, FileBuffer& out, const WriteOptions& options);
[[nodiscard]] Result<void> writeAbaqusInp(const ClassifiedMesh& mesh, FileBuffer& out,
                                          const WriteOptions& options);
[[nodiscard]] Result<void> writeUnv(const ClassifiedMesh& mesh, FileBuffer& out, const WriteOptions& options);
[[nodiscard]] Result<void> writePng(const ClassifiedMesh& mesh, FileBuffer& out, const WriteOptions& options);

}  // namespace mesher
