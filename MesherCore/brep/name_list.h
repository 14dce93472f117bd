#pragma once

#include <string>
#include <vector>

namespace mesher {

/// "Face1, Face2 and Face7"; of a long list the first twenty and how many more there are.
[[nodiscard]] std::string listOf(const std::vector<std::string>& names);

/// A number for notes, of three digits.
[[nodiscard]] std::string roughNumber(double value);

}  // namespace mesher
