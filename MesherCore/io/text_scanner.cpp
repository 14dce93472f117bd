#include "io/text_scanner.h"

#include "base/assert.h"

#include <algorithm>
#include <utility>

namespace mesher {

namespace {

constexpr std::size_t kLongestQuote = 40;

/// As much of a text as a message should show, without what a terminal would act on.
std::string shown(std::string_view text)
{
    std::string result(text.substr(0, kLongestQuote));
    std::replace_if(
        result.begin(), result.end(), [](char c) { return static_cast<unsigned char>(c) < 32 || c == 127; },
        '?');
    return std::string("'").append(result).append(text.size() > kLongestQuote ? "…'" : "'");
}

}  // namespace

Error TextScanner::failure() const
{
    MESHER_PRECONDITION(failed());
    return *failure_;
}

void TextScanner::fail(std::string message, std::string remedy)
{
    if (failed()) return;
    failure_ = Error{
        ErrorCode::Unreadable, "line " + std::to_string(line()) + ": " + message, {}, {}, std::move(remedy)};
    position_ = text_.size();
}

std::size_t TextScanner::line() const
{
    const std::string_view before = text_.substr(0, position_);
    return 1 + static_cast<std::size_t>(std::count(before.begin(), before.end(), '\n'));
}

void TextScanner::skipBlanks()
{
    while (position_ < text_.size() && isBlank(text_[position_])) ++position_;
}

void TextScanner::failNumber()
{
    const std::string_view found = word();
    fail(found.empty() ? "the file ends where a number is expected"
                       : "a number is expected, not " + shown(found),
         found.empty() ? "write the file again, it is cut off" : "");
}

bool TextScanner::atEnd()
{
    skipBlanks();
    return position_ == text_.size();
}

std::string_view TextScanner::word()
{
    skipBlanks();
    const std::size_t first = position_;
    while (position_ < text_.size() && !isBlank(text_[position_])) ++position_;
    return text_.substr(first, position_ - first);
}

std::string_view TextScanner::restOfLine()
{
    const std::size_t end = std::min(text_.find('\n', position_), text_.size());
    std::string_view rest = text_.substr(position_, end - position_);
    position_ = std::min(end + 1, text_.size());
    while (!rest.empty() && isBlank(rest.front())) rest.remove_prefix(1);
    while (!rest.empty() && isBlank(rest.back())) rest.remove_suffix(1);
    return rest;
}

std::string_view TextScanner::quoted()
{
    skipBlanks();
    if (position_ == text_.size() || text_[position_] != '"') {
        fail("a name in quotation marks is expected");
        return {};
    }
    const std::size_t first = position_ + 1;
    const std::size_t end = text_.find_first_of("\"\n", first);
    if (end == std::string_view::npos || text_[end] != '"') {
        fail("a name is not closed by a quotation mark");
        return {};
    }
    position_ = end + 1;
    return text_.substr(first, end - first);
}

void TextScanner::expect(std::string_view wanted)
{
    const std::string_view found = word();
    if (found == wanted) return;
    const std::string where = std::string(wanted) + " is expected";
    if (found.empty()) {
        fail("the file ends where " + where, "write the file again, it is cut off");
    } else {
        fail(where + ", not " + shown(found));
    }
}

std::int64_t TextScanner::integer(std::int64_t low, std::int64_t high)
{
    const std::int64_t value = integer();
    if (!failed() && (value < low || value > high)) {
        fail(std::to_string(value) + " is not in the range from " + std::to_string(low) + " to " +
             std::to_string(high));
    }
    return failed() ? low : value;
}

std::size_t TextScanner::count(std::size_t leastCharacters)
{
    const std::int64_t value = integer();
    if (failed()) return 0;
    // The last item may lack its line break.
    const std::size_t room = (text_.size() - position_ + 1) / leastCharacters;
    if (value < 0 || static_cast<std::uint64_t>(value) > room) {
        fail("there cannot be " + std::to_string(value) + " items in the rest of the file",
             "write the file again, it is cut off or broken");
        return 0;
    }
    return static_cast<std::size_t>(value);
}

void TextScanner::skipPastLine(std::string_view wanted)
{
    while (!failed()) {
        if (atEnd()) {
            fail("the file ends before " + std::string(wanted), "write the file again, it is cut off");
        } else if (restOfLine() == wanted) {
            return;
        }
    }
}

}  // namespace mesher
