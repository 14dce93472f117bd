#pragma once

#include "io/atomic_file.h"

#include <charconv>
#include <concepts>
#include <cstddef>
#include <functional>
#include <span>
#include <string_view>
#include <utility>
#include <vector>

namespace mesher {

/// Collects text and bytes for a file in a large buffer. Numbers are written in the shortest form that reads back as the same
/// double, whatever the locale. An error of the file is kept and told by `finish`; what comes after it is dropped.
class FileBuffer
{
public:
    /// Asked now and then; false ends the writing with an error.
    using Permission = std::function<bool()>;

    explicit FileBuffer(AtomicFile& file, Permission mayGoOn = {})
        : file_(file), mayGoOn_(std::move(mayGoOn)), buffer_(kCapacity)
    {
    }
    FileBuffer(const FileBuffer&) = delete;
    FileBuffer& operator=(const FileBuffer&) = delete;

    FileBuffer& operator<<(std::string_view text)
    {
        append({text.data(), text.size()});
        return *this;
    }
    FileBuffer& operator<<(const char* text) { return *this << std::string_view(text); }
    FileBuffer& operator<<(char character)
    {
        makeRoom(1);
        buffer_[size_++] = character;
        return *this;
    }
    FileBuffer& operator<<(double value)
    {
        if (!isTaking_) return *this;
        makeRoom(kLongestNumber);
        advance(std::to_chars(cursor(), cursor() + kLongestNumber, value + 0.0));
        return *this;
    }
    template <std::integral Integer>
    requires(!std::same_as<Integer, char> && !std::same_as<Integer, bool>) FileBuffer&
    operator<<(Integer value)
    {
        if (!isTaking_) return *this;
        makeRoom(kLongestNumber);
        advance(std::to_chars(cursor(), cursor() + kLongestNumber, value));
        return *this;
    }
    void append(std::span<const char> bytes);

    /// Writes out what is still here; the first error of the file, if there was one.
    [[nodiscard]] Result<void> finish();

private:
    static constexpr std::size_t kCapacity = std::size_t{1} << 20;
    static constexpr std::size_t kLongestNumber = 32;

    [[nodiscard]] char* cursor() { return buffer_.data() + size_; }
    void advance(std::to_chars_result end) { size_ = static_cast<std::size_t>(end.ptr - buffer_.data()); }
    void makeRoom(std::size_t count)
    {
        if (size_ + count > buffer_.size()) flush();
    }
    void flush();

    AtomicFile& file_;
    Permission mayGoOn_;
    std::vector<char> buffer_;
    std::size_t size_ = 0;
    bool isTaking_ = true;  ///< false once there is an error: what is dropped need not be put into digits
    Result<void> state_;
};

}  // namespace mesher
