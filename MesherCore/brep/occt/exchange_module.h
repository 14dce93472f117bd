#pragma once

#include "brep/occt/exchange/read_file.h"

namespace mesher {

struct FileReader
{
    ReadFile read;
};

/// What reads STEP or IGES. Each is in a module of its own, loaded when a file needs it and kept: the kernel's libraries
/// for them take the linker longer than a small mesh takes us.
/// Errors       there is no such module beside the program, or the linker refuses it
[[nodiscard]] Result<FileReader> loadStepReader();
[[nodiscard]] Result<FileReader> loadIgesReader();

}  // namespace mesher
