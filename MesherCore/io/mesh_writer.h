#pragma once

#include "base/result.h"
#include "io/file_buffer.h"
#include "io/write_options.h"
#include "mesh/classified_mesh.h"

#include <filesystem>
#include <span>
#include <string>
#include <string_view>

namespace mesher {

/// A kind of mesh file. A new one is a file write_<format>.cpp, a line in format_writers.h and one in mesh_writer.cpp.
struct MeshFormat
{
    std::string_view name;       ///< for --format
    std::string_view extension;  ///< ".msh"; the first format of an extension is its default
    std::string_view description;
    /// Refuses, with a typed error, a mesh that the format cannot hold; errors of the file are told by the buffer.
    Result<void> (*write)(const ClassifiedMesh& mesh, FileBuffer& out, const WriteOptions& options);
    bool wantsLevelPlane = false;  ///< of a mesh of faces, all nodes have to be at one z
};

[[nodiscard]] std::span<const MeshFormat> meshFormats();

/// The format of that name, or without a name that of the path's extension (in any case).
[[nodiscard]] Result<const MeshFormat*> findFormat(const std::filesystem::path& path,
                                                   std::string_view name = {});

/// Writes the mesh into a file that is still to be published, so that several can appear together.
/// Guarantees   coordinates in model units that read back as the same doubles, but for binary STL, which has single precision by
///              its nature, and for what does not fit the 20 characters of a number in INP: that loses least
/// Refuses      an unknown format (InvalidArgument), a mesh that the format cannot hold, a target that cannot be written
[[nodiscard]] Result<AtomicFile> prepareMesh(const ClassifiedMesh& mesh, const std::filesystem::path& path,
                                             std::string_view formatName = {},
                                             const WriteOptions& options = {},
                                             FileBuffer::Permission mayGoOn = {});

/// The same in one step: the file appears complete or not at all (AtomicFile).
[[nodiscard]] Result<void> writeMesh(const ClassifiedMesh& mesh, const std::filesystem::path& path,
                                     std::string_view formatName = {}, const WriteOptions& options = {});

/// Whether writeMesh could open this target in this format; changes nothing.
[[nodiscard]] Result<void> probeMeshTarget(const std::filesystem::path& path,
                                           std::string_view formatName = {});

}  // namespace mesher
