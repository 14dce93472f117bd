#include "io/mesh_reader.h"

#include "io/format_readers.h"

#include <algorithm>
#include <cctype>
#include <fstream>
#include <utility>

namespace mesher {

namespace {

namespace fs = std::filesystem;

Error unreadable(const fs::path& path, std::string message, std::string remedy)
{
    return {ErrorCode::Unreadable, std::move(message), path.string(), {}, std::move(remedy)};
}

Result<std::string> readWhole(const fs::path& path)
{
    std::error_code code;
    const fs::file_status status = fs::status(path, code);
    if (!fs::exists(status))
        return unreadable(path, "there is no such file", "check the name and the folder");
    if (fs::is_directory(status)) return unreadable(path, "is a folder", "give the name of a mesh file");
    std::ifstream file(path, std::ios::binary);
    if (!file) return unreadable(path, "the file cannot be opened", "check that you may read it");
    std::string content;
    const std::uintmax_t size = fs::file_size(path, code);
    if (!code && fs::is_regular_file(status)) content.reserve(static_cast<std::size_t>(size));
    char block[1 << 16];
    while (file.read(block, sizeof block) || file.gcount() > 0) {
        content.append(block, static_cast<std::size_t>(file.gcount()));
    }
    if (file.bad()) return unreadable(path, "the file cannot be read to its end", "check the disk");
    if (content.empty()) return unreadable(path, "the file is empty", "write the mesh again");
    return content;
}

}  // namespace

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

Result<MeshFile> readMesh(const fs::path& path)
{
    std::string extension = path.extension().string();
    std::transform(extension.begin(), extension.end(), extension.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    const Result<std::string> content = readWhole(path);
    if (!content) return content.error();
    Result<MeshFile> file = readMeshText(content.value(), extension);
    if (file) return file;
    Error error = file.error();
    error.entity = path.string();
    return error;
}

}  // namespace mesher
