#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace compare {

/// What compare_delaunay was asked for on its command line.
struct Options
{
    std::vector<std::uint32_t> dimensions = {2, 3};
    std::vector<std::string> sets;  ///< names of tests/support/degenerate_points.h; empty for the usual ones
    std::vector<std::string> programs = {"mesher", "cgal", "tetgen"};
    std::size_t points = 1'000'000;
    std::size_t repeats = 3;
    std::uint64_t seed = 1;

    [[nodiscard]] std::vector<std::string> setsOf(std::uint32_t dimension) const;
};

/// None, with the reason and the usage on stderr, if the arguments make no sense.
std::optional<Options> parseOptions(const std::vector<std::string>& arguments);

}  // namespace compare
