#include "io/mesh_reader.h"

#include "io/format_readers.h"
#include "io/read_whole_file.h"

#include <algorithm>
#include <cctype>

namespace mesher {

Result<MeshFile> readMeshText(std::string_view content, std::string_view extension)
{
    if (extension == ".msh") return readGmsh(content);
    if (extension == ".vtu") return readVtu(content);
    return Error{ErrorCode::Unreadable,
                 "the extension '" + std::string(extension) + "' is of no mesh file that can be read",
                 {},
                 {},
                 "give a .msh or .vtu file"};
}

Result<MeshFile> readMesh(const std::filesystem::path& path)
{
    std::string extension = path.extension().string();
    std::transform(extension.begin(), extension.end(), extension.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    const Result<std::string> content = readWholeFile(path);
    if (!content) return content.error();
    Result<MeshFile> file = readMeshText(content.value(), extension);
    if (file) return file;
    Error error = file.error();
    error.entity = path.string();
    return error;
}

}  // namespace mesher
