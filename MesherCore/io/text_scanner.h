#pragma once

#include "base/error.h"

#include <charconv>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <system_error>

namespace mesher {

/// Reads words, numbers and lines from text. The first failure is kept with its line, and from then on everything fails: a reader
/// may ask a few questions in a row and look at `failed` once.
class TextScanner
{
public:
    explicit TextScanner(std::string_view text) : text_(text) {}

    [[nodiscard]] bool failed() const { return failure_.has_value(); }
    /// "line 17: a number is expected, not 'abc'"
    [[nodiscard]] Error failure() const;
    void fail(std::string message, std::string remedy = {});

    [[nodiscard]] bool atEnd();
    [[nodiscard]] std::string_view word();
    /// The text up to the end of the line, without blanks around it; the next line is then the current one.
    [[nodiscard]] std::string_view restOfLine();
    /// A text between quotation marks, on one line.
    [[nodiscard]] std::string_view quoted();
    /// Fails unless the next word is this one.
    void expect(std::string_view wanted);
    [[nodiscard]] double real() { return number<double>(); }
    [[nodiscard]] std::int64_t integer() { return number<std::int64_t>(); }
    /// An integer in [low, high].
    [[nodiscard]] std::int64_t integer(std::int64_t low, std::int64_t high);
    /// A number of items that take at least `leastCharacters` each: there cannot be more than the rest of the text holds.
    [[nodiscard]] std::size_t count(std::size_t leastCharacters);
    /// Moves behind the next line that is this word; fails if there is none.
    void skipPastLine(std::string_view wanted);

private:
    template <class T>
    T number()
    {
        skipBlanks();
        if (failed()) return T{};
        const char* first = text_.data() + position_;
        const char* last = text_.data() + text_.size();
        if (first != last && *first == '+') ++first;
        T value{};
        const auto [end, code] = std::from_chars(first, last, value);
        const bool isWhole = end == last || isBlank(*end);
        if (code != std::errc() || !isWhole) {
            failNumber();
            return T{};
        }
        position_ = static_cast<std::size_t>(end - text_.data());
        return value;
    }
    [[nodiscard]] static bool isBlank(char c) { return c == ' ' || c == '\n' || c == '\r' || c == '\t'; }
    void skipBlanks();
    void failNumber();
    [[nodiscard]] std::size_t line() const;

    std::string_view text_;
    std::size_t position_ = 0;
    std::optional<Error> failure_;
};

}  // namespace mesher
