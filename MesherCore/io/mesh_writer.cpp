#include "io/mesh_writer.h"

#include "io/format_writers.h"

#include <algorithm>
#include <array>
#include <cctype>

namespace mesher {

namespace {

constexpr std::array kFormats = {
    MeshFormat{"msh", ".msh", "Gmsh 4.1 ASCII with physical groups", writeGmsh41},
    MeshFormat{"msh2", ".msh", "Gmsh 2.2 ASCII with physical groups", writeGmsh22},
    MeshFormat{"vtu", ".vtu", "VTK XML unstructured grid with the entity of each cell", writeVtu},
    MeshFormat{"vtk", ".vtk", "legacy VTK, text", writeVtkText},
    MeshFormat{"vtk-binary", ".vtk", "legacy VTK, binary", writeVtkBinary},
    MeshFormat{"su2", ".su2", "SU2 with a marker for each boundary edge or face", writeSu2, true},
    MeshFormat{"stl", ".stl", "STL of the outer triangles, text, one solid for each face", writeStlText},
    MeshFormat{"stl-binary", ".stl", "STL of the outer triangles, binary, single precision", writeStlBinary},
    MeshFormat{"ply", ".ply", "PLY of the outer triangles, text", writePly},
    MeshFormat{"inp", ".inp", "Abaqus and CalculiX with node, element and surface sets", writeAbaqusInp},
    MeshFormat{"unv", ".unv", "I-DEAS universal file with groups", writeUnv},
    MeshFormat{"png", ".png", "picture of the mesh", writePng},
};

std::string lowered(std::string text)
{
    std::transform(text.begin(), text.end(), text.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return text;
}

std::string knownFormats()
{
    std::string list;
    for (const MeshFormat& format : kFormats) list += (list.empty() ? "" : ", ") + std::string(format.name);
    return "known formats are " + list;
}

}  // namespace

std::span<const MeshFormat> meshFormats() { return kFormats; }

Result<const MeshFormat*> findFormat(const std::filesystem::path& path, std::string_view name)
{
    if (!name.empty()) {
        for (const MeshFormat& format : kFormats) {
            if (format.name == name) return &format;
        }
        return Error{
            ErrorCode::InvalidArgument, "unknown format '" + std::string(name) + "'", {}, {}, knownFormats()};
    }
    const std::string extension = lowered(path.extension().string());
    for (const MeshFormat& format : kFormats) {
        if (format.extension == extension) return &format;
    }
    const std::string what = extension.empty() ? "has no extension that tells the format"
                                               : "the extension '" + extension + "' is of no known format";
    return Error{ErrorCode::InvalidArgument, what, path.string(), {}, knownFormats()};
}

Result<AtomicFile> prepareMesh(const ClassifiedMesh& mesh, const std::filesystem::path& path,
                               std::string_view formatName, const WriteOptions& options,
                               FileBuffer::Permission mayGoOn)
{
    const Result<const MeshFormat*> format = findFormat(path, formatName);
    if (!format) return format.error();
    Result<AtomicFile> file = AtomicFile::create(path);
    if (!file) return file.error();
    FileBuffer out(*file, std::move(mayGoOn));
    if (const Result<void> written = format.value()->write(mesh, out, options); !written) {
        Error error = written.error();
        if (error.entity.empty()) error.entity = path.string();
        return error;
    }
    if (const Result<void> finished = out.finish(); !finished) return finished.error();
    if (const Result<void> prepared = file->prepare(); !prepared) return prepared.error();
    return file;
}

Result<void> writeMesh(const ClassifiedMesh& mesh, const std::filesystem::path& path,
                       std::string_view formatName, const WriteOptions& options)
{
    Result<AtomicFile> file = prepareMesh(mesh, path, formatName, options);
    if (!file) return file.error();
    return file->commit();
}

Result<void> probeMeshTarget(const std::filesystem::path& path, std::string_view formatName)
{
    const Result<const MeshFormat*> format = findFormat(path, formatName);
    if (!format) return format.error();
    return AtomicFile::probe(path);
}

}  // namespace mesher
