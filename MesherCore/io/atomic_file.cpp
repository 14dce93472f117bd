#include "io/atomic_file.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <optional>
#include <system_error>
#include <utility>

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
        case EROFS: return "choose a disk that is not read-only";
        case ENOENT: return "make the folder first";
        case EISDIR: return "give a file name, not a folder";
        default: return "choose another place";
    }
}

Error unwritable(const fs::path& target, const std::string& message, int code)
{
    return {ErrorCode::Unwritable, message, target.string(), {}, remedyFor(code)};
}

Error unwritable(const fs::path& target, const char* doing, int code)
{
    return unwritable(target, std::string(doing) + ": " + std::generic_category().message(code), code);
}

/// What stands in the way of writing to the target, as far as can be told beforehand; `target` becomes what a link points to.
std::optional<Error> findObstacle(fs::path& target, bool& isDirect)
{
    isDirect = false;
    if (target.empty()) return unwritable(target, std::string("the name of the file is empty"), EISDIR);
    std::error_code code;
    if (fs::is_symlink(target, code)) {
        const fs::path resolved = fs::weakly_canonical(target, code);
        if (code) return unwritable(target, "the link cannot be followed", code.value());
        target = resolved;
    }
    const fs::file_status status = fs::status(target, code);
    if (fs::is_directory(status) || !target.has_filename()) {
        return unwritable(target, std::string("is a folder"), EISDIR);
    }
    if (fs::exists(status)) {
        if (access(target.c_str(), W_OK) != 0) return unwritable(target, "cannot be written", errno);
        isDirect = !fs::is_regular_file(status);
        if (isDirect) return std::nullopt;
    }
    const fs::path folder = target.has_parent_path() ? target.parent_path() : fs::path(".");
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

/// The permissions of the file that is replaced, else what the user's mask leaves of a new file.
mode_t permissionsFor(const fs::path& target)
{
    struct stat existing
    {
    };
    if (stat(target.c_str(), &existing) == 0) return existing.st_mode & 0777u;
    const mode_t mask = umask(0);
    umask(mask);
    return 0666u & ~mask;
}

/// The new name of the file is lost in a power cut unless its folder is on the disk, too.
void syncFolderOf(const fs::path& target)
{
    const fs::path folder = target.has_parent_path() ? target.parent_path() : fs::path(".");
    const int descriptor = open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    if (descriptor < 0) return;
    fsync(descriptor);
    close(descriptor);
}

}  // namespace

AtomicFile::AtomicFile(int descriptor, fs::path target, fs::path temporary)
    : descriptor_(descriptor), target_(std::move(target)), temporary_(std::move(temporary))
{
}

AtomicFile::AtomicFile(AtomicFile&& other) noexcept
    : descriptor_(std::exchange(other.descriptor_, -1)),
      target_(std::move(other.target_)),
      temporary_(std::exchange(other.temporary_, {}))
{
}

AtomicFile& AtomicFile::operator=(AtomicFile&& other) noexcept
{
    if (this != &other) {
        discard();
        descriptor_ = std::exchange(other.descriptor_, -1);
        target_ = std::move(other.target_);
        temporary_ = std::exchange(other.temporary_, {});
    }
    return *this;
}

AtomicFile::~AtomicFile() { discard(); }

Result<AtomicFile> AtomicFile::create(const fs::path& path)
{
    fs::path target = path;
    bool isDirect = false;
    if (auto obstacle = findObstacle(target, isDirect)) return *obstacle;
    if (isDirect) {
        const int descriptor = open(target.c_str(), O_WRONLY | O_CLOEXEC);
        if (descriptor < 0) return unwritable(path, "cannot be opened", errno);
        return AtomicFile(descriptor, target, {});
    }
    std::string temporary = target.string() + ".partial-XXXXXX";
    const int descriptor = mkostemp(temporary.data(), O_CLOEXEC);
    if (descriptor < 0) return unwritable(path, "cannot be made", errno);
    AtomicFile file(descriptor, target, temporary);
    if (fchmod(descriptor, permissionsFor(target)) != 0) return file.fail("cannot be made");
    return file;
}

Result<void> AtomicFile::probe(const fs::path& path)
{
    fs::path target = path;
    bool isDirect = false;
    if (auto obstacle = findObstacle(target, isDirect)) return *obstacle;
    return {};
}

Result<void> AtomicFile::write(std::span<const char> bytes)
{
    while (!bytes.empty()) {
        const ssize_t count = ::write(descriptor_, bytes.data(), bytes.size());
        if (count < 0 && errno == EINTR) continue;
        if (count < 0) return fail("cannot be written");
        bytes = bytes.subspan(static_cast<std::size_t>(count));
    }
    return {};
}

Result<void> AtomicFile::commit()
{
    // Devices and pipes have nothing to synchronise and say so.
    if (fsync(descriptor_) != 0 && !(temporary_.empty() && (errno == EINVAL || errno == EROFS))) {
        return fail("cannot be written to the disk");
    }
    if (close(std::exchange(descriptor_, -1)) != 0) return fail("cannot be closed");
    if (temporary_.empty()) return {};
    if (rename(temporary_.c_str(), target_.c_str()) != 0) return fail("cannot be replaced");
    temporary_.clear();
    syncFolderOf(target_);
    return {};
}

Error AtomicFile::fail(const char* doing)
{
    const int code = errno;
    discard();
    return unwritable(target_, doing, code);
}

void AtomicFile::discard() noexcept
{
    if (descriptor_ >= 0) close(std::exchange(descriptor_, -1));
    if (!temporary_.empty()) {
        unlink(temporary_.c_str());
        temporary_.clear();
    }
}

}  // namespace mesher
