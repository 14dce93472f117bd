#pragma once

#include "base/result.h"

#include <string>
#include <string_view>

namespace mesher {

/// The shortest decimal that reads back as this number.
[[nodiscard]] std::string decimalOf(double value);

/// What is wrong with an option, which is named as on the command line.
[[nodiscard]] Error optionError(std::string_view option, std::string message, std::string remedy);

/// \name Refuse what is out of range or not a number
///@{
[[nodiscard]] Result<void> checkRange(std::string_view option, double value, double low, double high);
[[nodiscard]] Result<void> checkNotNegative(std::string_view option, double value);
/// A length above 0; `whose`: " of Face6", or nothing.
[[nodiscard]] Result<void> checkSize(std::string_view option, double value, std::string_view whose = {});
///@}

}  // namespace mesher
