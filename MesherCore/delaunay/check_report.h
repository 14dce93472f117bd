#pragma once

#include <cstdint>
#include <string>

namespace mesher {

/// The verdict of a checker. `problem` tells the first violation found, empty when there is none.
struct CheckReport
{
    std::string problem;
    std::uint64_t violations = 0;

    [[nodiscard]] bool isValid() const { return violations == 0; }

    void add(const std::string& violation)
    {
        if (violations++ == 0) problem = violation;
    }
};

}  // namespace mesher
