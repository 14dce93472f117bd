#pragma once

#include "base/error.h"

#include <filesystem>
#include <optional>
#include <string>

namespace mesher {

/// An error about a file that cannot be written, with a remedy for the code of errno.
[[nodiscard]] Error unwritable(const std::filesystem::path& target, const std::string& message, int code);
/// The same with the system's word for the code behind what was being done.
[[nodiscard]] Error unwritable(const std::filesystem::path& target, const char* doing, int code);

[[nodiscard]] std::filesystem::path folderOf(const std::filesystem::path& target);

/// What stands in the way of writing to the target, as far as can be told beforehand. `target` becomes what a link points to, be
/// it there or not; `isDirect` tells whether it is a device, a pipe or the like, which cannot be replaced.
[[nodiscard]] std::optional<Error> findObstacle(std::filesystem::path& target, bool& isDirect);

/// The permissions of the file that is replaced, else what the user's mask leaves of a new file.
[[nodiscard]] unsigned permissionsFor(const std::filesystem::path& target);

/// The new name of a file is lost in a power cut unless its folder is on the disk, too.
void syncFolderOf(const std::filesystem::path& target);

}  // namespace mesher
