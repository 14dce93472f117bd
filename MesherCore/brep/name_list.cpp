#include "brep/name_list.h"

#include <algorithm>
#include <cstddef>
#include <sstream>

namespace mesher {

std::string listOf(const std::vector<std::string>& names)
{
    constexpr std::size_t kMost = 20;
    const std::size_t shown = std::min(names.size(), kMost);
    std::string list;
    for (std::size_t i = 0; i < shown; ++i) {
        const bool isLast = i + 1 == names.size();
        if (i > 0) list += isLast ? " and " : ", ";
        list += names[i];
    }
    if (shown < names.size()) list += " and " + std::to_string(names.size() - shown) + " more";
    return list;
}

std::string roughNumber(double value)
{
    std::ostringstream text;
    text.precision(3);
    text << value;
    return text.str();
}

}  // namespace mesher
