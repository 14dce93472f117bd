#include "io/file_buffer.h"

#include <algorithm>

namespace mesher {

void FileBuffer::append(std::span<const char> bytes)
{
    while (!bytes.empty()) {
        makeRoom(1);
        const std::size_t count = std::min(bytes.size(), buffer_.size() - size_);
        std::copy_n(bytes.begin(), count, buffer_.begin() + static_cast<std::ptrdiff_t>(size_));
        size_ += count;
        bytes = bytes.subspan(count);
    }
}

void FileBuffer::flush()
{
    if (state_ && mayGoOn_ && !mayGoOn_())
        state_ = Error{ErrorCode::Unwritable, "the run ended before the file was whole", {}, {}, {}};
    if (state_) state_ = file_.write({buffer_.data(), size_});
    isTaking_ = state_.hasValue();
    size_ = 0;
}

Result<void> FileBuffer::finish()
{
    flush();
    return state_;
}

}  // namespace mesher
