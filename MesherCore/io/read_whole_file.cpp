#include "io/read_whole_file.h"

#include <fstream>
#include <utility>

namespace mesher {

namespace {

namespace fs = std::filesystem;

Error unreadable(const fs::path& path, std::string message, std::string remedy)
{
    return {ErrorCode::Unreadable, std::move(message), path.string(), {}, std::move(remedy)};
}

}  // namespace

Result<std::string> readWholeFile(const fs::path& path)
{
    std::error_code code;
    const fs::file_status status = fs::status(path, code);
    if (!fs::exists(status))
        return unreadable(path, "there is no such file", "check the name and the folder");
    if (fs::is_directory(status)) return unreadable(path, "is a folder", "give the name of a file");
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
    if (content.empty()) return unreadable(path, "the file is empty", "write it again");
    return content;
}

}  // namespace mesher
