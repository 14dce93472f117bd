#pragma once

#include "base/result.h"

#include <cstddef>
#include <filesystem>
#include <span>
#include <string>

namespace mesher {

/// A file that appears complete or not at all: written beside its target under another name, then renamed over it.
/// Guarantees   until `commit` succeeds the target is as it was; a file that is not committed leaves nothing behind; after
///              `commit` the content is on the disk, not only in its cache
/// Refuses      with ErrorCode::Unwritable, a directory as target, a folder that is missing, what may not be written, a full disk
/// A target that is no regular file (a device, a pipe) cannot be replaced and is written directly. A symbolic link stays, what
/// it points to is replaced.
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
    [[nodiscard]] Result<void> commit();

private:
    AtomicFile(int descriptor, std::filesystem::path target, std::filesystem::path temporary);

    /// The present errno as an error about the target; nothing is left of the file afterwards.
    [[nodiscard]] Error fail(const char* doing);
    void discard() noexcept;

    int descriptor_ = -1;
    std::filesystem::path target_;
    std::filesystem::path temporary_;  ///< empty if the target is written directly
};

}  // namespace mesher
