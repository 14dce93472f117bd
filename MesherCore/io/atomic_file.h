#pragma once

#include "base/result.h"

#include <cstddef>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>

namespace mesher {

/// A file that appears complete or not at all: written without a name, then given that of its target.
/// Guarantees   until `publish` succeeds the target is as it was; a file that is not published leaves nothing behind, not even
///              where the program is killed, unless the disk knows no files without names or it happens in the instant in which
///              a file is replaced; once prepared, the content is on the
///              disk, not only in its cache
/// Refuses      with ErrorCode::Unwritable, a directory as target, a folder that is missing, what may not be written, a full disk,
///              a pipe that nobody reads
/// A target that is no regular file (a device, a pipe) cannot be replaced: it gets the content when it is published. A symbolic
/// link stays, what it points to is replaced or made.
class AtomicFile
{
public:
    [[nodiscard]] static Result<AtomicFile> create(const std::filesystem::path& target);
    /// Whether `create` would succeed; changes nothing.
    [[nodiscard]] static Result<void> probe(const std::filesystem::path& target);

    AtomicFile(AtomicFile&& other) noexcept;
    AtomicFile& operator=(AtomicFile&& other) noexcept;
    AtomicFile(const AtomicFile&) = delete;
    AtomicFile& operator=(const AtomicFile&) = delete;
    ~AtomicFile();

    [[nodiscard]] Result<void> write(std::span<const char> bytes);
    /// To be called once everything is written: what can fail for the content's sake has then happened.
    [[nodiscard]] Result<void> prepare();
    /// Makes a prepared file appear. What it replaces is kept until the object ends, so that `withdraw` can bring it back.
    [[nodiscard]] Result<void> publish();
    /// Makes a published file disappear again, unless it is direct.
    void withdraw() noexcept;
    /// All of these steps.
    [[nodiscard]] Result<void> commit();

    /// Whether the target gets its content byte by byte, which cannot be taken back.
    [[nodiscard]] bool isDirect() const { return isDirect_; }

private:
    friend Result<void> publishAll(std::span<AtomicFile> files);

    AtomicFile(int descriptor, std::filesystem::path target)
        : descriptor_(descriptor), target_(std::move(target))
    {
    }

    static Result<AtomicFile> createUnnamed(const std::filesystem::path& folder,
                                            const std::filesystem::path& target);
    [[nodiscard]] Result<void> giveName();
    [[nodiscard]] Result<void> exchange();
    [[nodiscard]] Result<void> copyToTarget();
    [[nodiscard]] Result<void> send(int pipe);

    /// The present errno as an error about the target; nothing is left of the file afterwards.
    [[nodiscard]] Error fail(const char* doing);
    void discard() noexcept;

    int descriptor_ = -1;
    std::filesystem::path target_;
    /// A name beside the target, of the new content before it is published and of the old one afterwards; empty without one.
    std::filesystem::path temporary_;
    bool isDirect_ = false;
    bool isPublished_ = false;
    bool isNew_ = false;  ///< published where there was nothing
};

/// All of the files, which are prepared, or none: if one cannot be published those before it are withdrawn.
[[nodiscard]] Result<void> publishAll(std::span<AtomicFile> files);

}  // namespace mesher
