#pragma once

#include <cstdio>
#include <string>

namespace mesher::test {

/// A line of text by printf's rules.
template <class... Values>
std::string formatted(const char* format, Values... values)
{
    char buffer[512];
    const int length = std::snprintf(buffer, sizeof buffer, format, values...);
    return {buffer, static_cast<std::size_t>(length)};
}

}  // namespace mesher::test
