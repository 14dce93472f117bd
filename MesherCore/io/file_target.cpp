#include "io/file_target.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <string>
#include <system_error>

namespace mesher {

namespace {

namespace fs = std::filesystem;

std::string remedyFor(int code)
{
    switch (code) {
        case ENOSPC:
        case EDQUOT: return "free some space or write to another disk";
        case EFBIG: return "raise the limit on the size of files or write a smaller mesh";
        case EACCES:
        case EPERM: return "choose a place that you may write to";
        case ENXIO:
        case ETIMEDOUT:
        case EPIPE: return "keep a program reading from it";
        case EROFS: return "choose a disk that is not read-only";
        case ENOENT: return "make the folder first";
        case EISDIR: return "give a file name, not a folder";
        default: return "choose another place";
    }
}

/// The end of a chain of links, be it there or not.
fs::path followed(fs::path target, std::error_code& code)
{
    constexpr int kMostLinks = 40;
    for (int i = 0; fs::is_symlink(fs::symlink_status(target, code)); ++i) {
        if (i == kMostLinks) code = std::make_error_code(std::errc::too_many_symbolic_link_levels);
        const fs::path next = code ? fs::path() : fs::read_symlink(target, code);
        if (code) return target;
        target = target.parent_path() / next;
    }
    code.clear();
    return target;
}

}  // namespace

Error unwritable(const fs::path& target, const std::string& message, int code)
{
    return {ErrorCode::Unwritable, message, target.string(), {}, remedyFor(code)};
}

Error unwritable(const fs::path& target, const char* doing, int code)
{
    return unwritable(target, std::string(doing) + ": " + std::generic_category().message(code), code);
}

fs::path folderOf(const fs::path& target)
{
    return target.has_parent_path() ? target.parent_path() : fs::path(".");
}

std::optional<Error> findObstacle(fs::path& target, bool& isDirect)
{
    isDirect = false;
    if (target.empty()) return unwritable(target, std::string("the name of the file is empty"), EISDIR);
    std::error_code code;
    const fs::file_status status = fs::status(target, code);
    isDirect = fs::exists(status) && !fs::is_directory(status) && !fs::is_regular_file(status);
    if (!isDirect) {
        const fs::path resolved = followed(target, code);
        if (code) return unwritable(target, "the link cannot be followed", code.value());
        target = resolved;
    }
    if (fs::is_directory(status) || !target.has_filename()) {
        return unwritable(target, std::string("is a folder"), EISDIR);
    }
    if (fs::exists(status) && access(target.c_str(), W_OK) != 0)
        return unwritable(target, "cannot be written", errno);
    if (isDirect) return std::nullopt;
    const fs::path folder = folderOf(target);
    if (!fs::exists(folder, code)) {
        return unwritable(target, "the folder " + folder.string() + " does not exist", ENOENT);
    }
    if (!fs::is_directory(folder, code))
        return unwritable(target, folder.string() + " is not a folder", ENOTDIR);
    if (access(folder.c_str(), W_OK | X_OK) != 0) {
        return unwritable(target, "the folder cannot be written", errno);
    }
    return std::nullopt;
}

unsigned permissionsFor(const fs::path& target)
{
    struct stat existing
    {
    };
    if (stat(target.c_str(), &existing) == 0) return existing.st_mode & 0777u;
    const mode_t mask = umask(0);
    umask(mask);
    return 0666u & ~mask;
}

void syncFolderOf(const fs::path& target)
{
    const int descriptor = open(folderOf(target).c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    if (descriptor < 0) return;
    fsync(descriptor);
    close(descriptor);
}

}  // namespace mesher
