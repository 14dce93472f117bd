#include "io/write_text_file.h"

#include "io/atomic_file.h"

namespace mesher {

Result<void> writeTextFile(std::string_view text, const std::filesystem::path& path)
{
    Result<AtomicFile> file = AtomicFile::create(path);
    if (!file) return file.error();
    if (const Result<void> written = file->write(text); !written) return written;
    return file->commit();
}

}  // namespace mesher
