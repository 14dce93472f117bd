#include "pipeline/option_checks.h"

#include <charconv>
#include <limits>
#include <utility>

namespace mesher {

namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

}  // namespace

std::string decimalOf(double value)
{
    char digits[32];
    return {digits, std::to_chars(std::begin(digits), std::end(digits), value).ptr};
}

Error optionError(std::string_view option, std::string message, std::string remedy)
{
    return {
        ErrorCode::InvalidArgument, std::move(message), "--" + std::string(option), {}, std::move(remedy)};
}

Result<void> checkRange(std::string_view option, double value, double low, double high)
{
    if (low <= value && value <= high) return {};
    return optionError(option, decimalOf(value) + " is out of range",
                       "give a number from " + decimalOf(low) + " to " + decimalOf(high));
}

Result<void> checkNotNegative(std::string_view option, double value)
{
    if (value >= 0.0 && value < kInfinity) return {};
    return optionError(option, decimalOf(value) + " is out of range", "give a number of at least 0");
}

Result<void> checkSize(std::string_view option, double value, std::string_view whose)
{
    if (value > 0.0 && value < kInfinity) return {};
    return optionError(option, "the size " + decimalOf(value) + std::string(whose) + " makes no sense",
                       "give a length above 0 in model units");
}

}  // namespace mesher
