#include "io/short_number.h"

#include "base/assert.h"

#include <array>
#include <charconv>
#include <cmath>
#include <utility>

namespace mesher {

namespace {

std::string printed(double value, std::chars_format format, int precision)
{
    std::array<char, 512> text{};
    const char* end = std::to_chars(text.data(), text.data() + text.size(), value, format, precision).ptr;
    return std::string(text.data(), static_cast<std::size_t>(end - text.data()));
}

/// "1.5e-07" as "1.5e-7", "2e+30" as "2e30".
std::string withShortExponent(std::string text)
{
    std::size_t first = text.find('e') + 1;
    if (text[first] == '+') {
        text.erase(first, 1);
    } else {
        ++first;
    }
    while (first + 1 < text.size() && text[first] == '0') text.erase(first, 1);
    return text;
}

/// With an exponent and as many digits as fit.
std::string scientific(double value, std::size_t width)
{
    for (int precision = 16; precision > 0; --precision) {
        std::string text = withShortExponent(printed(value, std::chars_format::scientific, precision));
        if (text.size() <= width) return text;
    }
    return withShortExponent(printed(value, std::chars_format::scientific, 0));
}

/// Of what is less than 1: without an exponent and without the zero before the point.
std::string fraction(double value, std::size_t width)
{
    const std::size_t sign = value < 0.0 ? 1 : 0;
    std::string text = printed(value, std::chars_format::fixed, static_cast<int>(width - sign - 1));
    text.erase(sign, 1);
    return text;
}

double read(const std::string& text)
{
    double value = 0.0;
    std::from_chars(text.data(), text.data() + text.size(), value);
    return value;
}

}  // namespace

std::string shortNumber(double value, std::size_t width)
{
    MESHER_PRECONDITION(std::isfinite(value) && width >= 10);
    value += 0.0;  // no sign of zero
    std::array<char, 32> text{};
    const char* end = std::to_chars(text.data(), text.data() + text.size(), value).ptr;
    const auto size = static_cast<std::size_t>(end - text.data());
    if (size <= width) return std::string(text.data(), size);
    std::string best = scientific(value, width);
    if (std::abs(value) < 0.5) {
        std::string other = fraction(value, width);
        if (std::abs(read(other) - value) <= std::abs(read(best) - value)) best = std::move(other);
    }
    return best;
}

}  // namespace mesher
