#pragma once

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

namespace mesher {

/// Adds to the entry of that name, which comes last if it is new.
template <typename Number>
void addToEntry(std::vector<std::pair<std::string, Number>>& entries, const std::string& name, Number amount)
{
    const auto found =
        std::find_if(entries.begin(), entries.end(), [&](const auto& e) { return e.first == name; });
    if (found == entries.end()) {
        entries.emplace_back(name, amount);
    } else {
        found->second += amount;
    }
}

}  // namespace mesher
