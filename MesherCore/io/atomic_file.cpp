#include "io/atomic_file.h"

#include "io/file_target.h"

#include <fcntl.h>
#include <poll.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <utility>

namespace mesher {

namespace {

namespace fs = std::filesystem;

/// A name beside a file that no other program takes.
fs::path nameBeside(const fs::path& folder, int attempt)
{
    return folder / (".partial-" + std::to_string(getpid()) + "-" + std::to_string(attempt));
}

/// By which a file without a name is given one.
std::string handleOf(int descriptor) { return "/proc/self/fd/" + std::to_string(descriptor); }

}  // namespace

AtomicFile::AtomicFile(AtomicFile&& other) noexcept
    : descriptor_(std::exchange(other.descriptor_, -1)),
      target_(std::move(other.target_)),
      temporary_(std::exchange(other.temporary_, {})),
      isDirect_(other.isDirect_),
      isPublished_(other.isPublished_),
      isNew_(other.isNew_)
{
}

AtomicFile& AtomicFile::operator=(AtomicFile&& other) noexcept
{
    if (this != &other) {
        discard();
        descriptor_ = std::exchange(other.descriptor_, -1);
        target_ = std::move(other.target_);
        temporary_ = std::exchange(other.temporary_, {});
        isDirect_ = other.isDirect_;
        isPublished_ = other.isPublished_;
        isNew_ = other.isNew_;
    }
    return *this;
}

AtomicFile::~AtomicFile() { discard(); }

Result<AtomicFile> AtomicFile::create(const fs::path& path)
{
    fs::path target = path;
    bool isDirect = false;
    if (auto obstacle = findObstacle(target, isDirect)) return *obstacle;
    // What a device or a pipe gets is collected first, so that it gets nothing of a run that fails.
    std::error_code code;
    const fs::path folder = isDirect ? fs::temp_directory_path(code) : folderOf(target);
    Result<AtomicFile> file = createUnnamed(folder, target);
    if (!file) return file;
    file->isDirect_ = isDirect;
    if (!isDirect && fchmod(file->descriptor_, permissionsFor(target)) != 0)
        return file->fail("cannot be made");
    return file;
}

/// Some disks know no files without names: there it has one from the beginning.
Result<AtomicFile> AtomicFile::createUnnamed(const fs::path& folder, const fs::path& target)
{
    const bool canBeNamed = access("/proc/self/fd", X_OK) == 0;
    const int unnamed = canBeNamed ? open(folder.c_str(), O_TMPFILE | O_RDWR | O_CLOEXEC, 0600) : -1;
    if (unnamed >= 0) return AtomicFile(unnamed, target);
    std::string temporary = (folder / ".partial-XXXXXX").string();
    const int descriptor = mkostemp(temporary.data(), O_CLOEXEC);
    if (descriptor < 0) return unwritable(target, "cannot be made", errno);
    AtomicFile file(descriptor, target);
    file.temporary_ = temporary;
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

Result<void> AtomicFile::prepare()
{
    if (!isDirect_ && fsync(descriptor_) != 0) return fail("cannot be written to the disk");
    return {};
}

Result<void> AtomicFile::publish()
{
    Result<void> published = isDirect_ ? copyToTarget() : giveName();
    if (published && !isDirect_ && !isNew_) published = exchange();
    isPublished_ = static_cast<bool>(published);
    return published;
}

/// That of the target where there is nothing yet, else one beside it.
Result<void> AtomicFile::giveName()
{
    constexpr int kMostAttempts = 1000;
    if (!temporary_.empty()) return {};
    const std::string handle = handleOf(descriptor_);
    const auto link = [&](const fs::path& name) {
        return linkat(AT_FDCWD, handle.c_str(), AT_FDCWD, name.c_str(), AT_SYMLINK_FOLLOW) == 0;
    };
    if (link(target_)) {
        isNew_ = true;
        return {};
    }
    for (int attempt = 0; errno == EEXIST && attempt < kMostAttempts; ++attempt) {
        const fs::path name = nameBeside(folderOf(target_), attempt);
        if (!link(name)) continue;
        temporary_ = name;
        return {};
    }
    return fail("cannot be made");
}

/// Afterwards the name beside the target has the old file, where the disk can do that.
Result<void> AtomicFile::exchange()
{
    if (renameat2(AT_FDCWD, temporary_.c_str(), AT_FDCWD, target_.c_str(), RENAME_EXCHANGE) == 0) return {};
    isNew_ = errno == ENOENT;
    if (rename(temporary_.c_str(), target_.c_str()) != 0) return fail("cannot be replaced");
    temporary_.clear();
    return {};
}

void AtomicFile::withdraw() noexcept
{
    if (!isPublished_ || isDirect_) return;
    if (isNew_) {
        unlink(target_.c_str());
    } else if (!temporary_.empty()) {
        rename(temporary_.c_str(), target_.c_str());
        temporary_.clear();
    }
    discard();
}

Result<void> AtomicFile::commit()
{
    if (const Result<void> prepared = prepare(); !prepared) return prepared;
    return publishAll({this, 1});
}

Result<void> AtomicFile::copyToTarget()
{
    // Opened this way, a pipe that nobody reads is an error instead of a wait for a reader.
    const int pipe = open(target_.c_str(), O_WRONLY | O_NONBLOCK | O_CLOEXEC);
    if (pipe < 0) return fail(errno == ENXIO ? "is read by no program" : "cannot be opened");
    const Result<void> sent = send(pipe);
    if (::close(pipe) != 0 && sent) return fail("cannot be closed");
    return sent;
}

Result<void> AtomicFile::send(int pipe)
{
    constexpr int kMostWait = 30'000;  // milliseconds in which a reader takes nothing
    std::array<char, 1u << 16> block{};
    for (off_t at = 0;;) {
        const ssize_t size = pread(descriptor_, block.data(), block.size(), at);
        if (size < 0) return fail("cannot be copied");
        if (size == 0) return {};
        for (ssize_t done = 0; done < size;) {
            const ssize_t count = ::write(pipe, block.data() + done, static_cast<std::size_t>(size - done));
            if (count >= 0) {
                done += count;
                continue;
            }
            if (errno != EAGAIN && errno != EINTR) return fail("cannot be written");
            pollfd wait{pipe, POLLOUT, 0};
            errno = ETIMEDOUT;
            if (poll(&wait, 1, kMostWait) == 0) return fail("is not read");
        }
        at += size;
    }
}

Error AtomicFile::fail(const char* doing)
{
    const int code = errno;
    discard();
    return unwritable(target_, doing, code);
}

void AtomicFile::discard() noexcept
{
    if (descriptor_ >= 0) ::close(std::exchange(descriptor_, -1));
    if (!temporary_.empty()) {
        unlink(temporary_.c_str());
        temporary_.clear();
    }
}

Result<void> publishAll(std::span<AtomicFile> files)
{
    // What cannot be taken back comes first: if it fails, nothing has been replaced.
    for (const bool isDirect : {true, false}) {
        for (AtomicFile& file : files) {
            if (file.isDirect() != isDirect) continue;
            const Result<void> published = file.publish();
            if (published) continue;
            for (AtomicFile& before : files) before.withdraw();
            return published;
        }
    }
    // What was replaced goes at once, before anything that takes time: a program that is killed here leaves it behind.
    for (AtomicFile& file : files) file.discard();
    for (const AtomicFile& file : files) {
        if (!file.isDirect_) syncFolderOf(file.target_);
    }
    return {};
}

}  // namespace mesher
