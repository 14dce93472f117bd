#include "base/error.h"

#include "base/assert.h"

#include <charconv>

namespace mesher {

namespace {

void appendNumber(std::string& text, double value)
{
    // The shortest form that reads back as the same double; independent of the locale.
    char digits[32];
    const std::to_chars_result end = std::to_chars(std::begin(digits), std::end(digits), value);
    text.append(digits, end.ptr);
}

std::string textOf(Vec3 point)
{
    std::string text = "(";
    appendNumber(text, point.x);
    text += ", ";
    appendNumber(text, point.y);
    text += ", ";
    appendNumber(text, point.z);
    return text + ")";
}

}  // namespace

std::string_view nameOf(ErrorCode code)
{
    switch (code) {
        case ErrorCode::InvalidArgument: return "invalid argument";
        case ErrorCode::NonFinitePoint: return "non-finite point";
        case ErrorCode::OutOfRange: return "out of range";
        case ErrorCode::DegenerateInput: return "degenerate input";
        case ErrorCode::DuplicatePoint: return "duplicate point";
        case ErrorCode::IntersectingConstraints: return "intersecting constraints";
        case ErrorCode::UnsupportedPlatform: return "unsupported platform";
        case ErrorCode::Unreadable: return "unreadable file";
        case ErrorCode::Unwritable: return "unwritable file";
    }
    MESHER_INVARIANT(false);
    return "";
}

std::string describe(const Error& error)
{
    std::string sentence = error.entity;
    if (error.point) sentence += (sentence.empty() ? "at " : " at ") + textOf(*error.point);
    if (!sentence.empty()) sentence += ": ";
    sentence += error.message.empty() ? std::string(nameOf(error.code)) : error.message;
    if (!error.remedy.empty()) sentence += "; " + error.remedy;
    return sentence + ".";
}

}  // namespace mesher
