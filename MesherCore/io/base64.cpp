#include "io/base64.h"

namespace mesher {

namespace {

constexpr std::string_view kAlphabet = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
constexpr std::uint8_t kForeign = 255;

constexpr std::array<std::uint8_t, 256> kValueOf = [] {
    std::array<std::uint8_t, 256> values{};
    values.fill(kForeign);
    for (std::size_t i = 0; i < kAlphabet.size(); ++i) {
        values[static_cast<unsigned char>(kAlphabet[i])] = static_cast<std::uint8_t>(i);
    }
    return values;
}();

constexpr bool isBlank(char c) { return c == ' ' || c == '\n' || c == '\r' || c == '\t'; }

}  // namespace

void Base64Encoder::append(std::span<const std::byte> bytes)
{
    for (const std::byte byte : bytes) {
        group_[filled_++] = std::to_integer<std::uint8_t>(byte);
        if (filled_ == 3) writeGroup();
    }
}

void Base64Encoder::writeGroup()
{
    const std::uint32_t bits = static_cast<std::uint32_t>(group_[0] << 16 | group_[1] << 8 | group_[2]);
    const std::array<char, 4> text = {kAlphabet[bits >> 18], kAlphabet[bits >> 12 & 63],
                                      kAlphabet[bits >> 6 & 63], kAlphabet[bits & 63]};
    out_.append(text);
    filled_ = 0;
}

void Base64Encoder::finish()
{
    if (filled_ == 0) return;
    for (std::size_t i = filled_; i < 3; ++i) group_[i] = 0;
    const std::uint32_t bits = static_cast<std::uint32_t>(group_[0] << 16 | group_[1] << 8);
    out_ << kAlphabet[bits >> 18] << kAlphabet[bits >> 12 & 63]
         << (filled_ == 2 ? kAlphabet[bits >> 6 & 63] : '=') << '=';
    filled_ = 0;
}

std::optional<std::vector<std::byte>> decodeBase64(std::string_view text, std::size_t& length)
{
    std::vector<std::byte> bytes;
    bytes.reserve(text.size() / 4 * 3);
    std::uint32_t bits = 0;
    unsigned held = 0;  // characters of the present group of four
    unsigned paddings = 0;
    for (length = 0; length < text.size(); ++length) {
        const char c = text[length];
        if (isBlank(c)) continue;
        if (paddings > 0 && c != '=') break;
        const std::uint8_t value = c == '=' ? std::uint8_t{0} : kValueOf[static_cast<unsigned char>(c)];
        if (value == kForeign || (c == '=' && held < 2)) return std::nullopt;
        paddings += c == '=' ? 1 : 0;
        bits = bits << 6 | value;
        if (++held < 4) continue;
        for (unsigned i = 0; i + paddings < 3; ++i)
            bytes.push_back(static_cast<std::byte>(bits >> (16 - 8 * i)));
        held = 0;
        if (paddings > 0) {
            ++length;
            break;
        }
    }
    if (held != 0) return std::nullopt;
    return bytes;
}

}  // namespace mesher
