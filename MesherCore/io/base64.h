#pragma once

#include "io/file_buffer.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

namespace mesher {

/// Writes bytes as base64 text; `finish` pads the end.
class Base64Encoder
{
public:
    explicit Base64Encoder(FileBuffer& out) : out_(out) {}

    void append(std::span<const std::byte> bytes);
    template <class T>
    void appendValue(const T& value)
    {
        append(std::as_bytes(std::span<const T, 1>(&value, 1)));
    }
    void finish();

private:
    void writeGroup();

    FileBuffer& out_;
    std::array<std::uint8_t, 3> group_{};
    std::size_t filled_ = 0;
};

[[nodiscard]] constexpr std::size_t base64Length(std::size_t byteCount) { return (byteCount + 2) / 3 * 4; }

/// The bytes that the text stands for, up to its end or its first padding; blanks are skipped. `length` becomes the number of
/// characters read. Nothing if a character does not belong into base64.
[[nodiscard]] std::optional<std::vector<std::byte>> decodeBase64(std::string_view text, std::size_t& length);

}  // namespace mesher
