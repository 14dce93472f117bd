#pragma once

#include "base/random.h"
#include "base/vec.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

namespace mesher::test {

/// Families of point sets that lead the predicates into all of their tiers.
enum class PointKind
{
    Random,       ///< uniform in a cube or in a small cluster within it
    Grid,         ///< few binary or decimal grid points: all degeneracies at once, coinciding points too
    Cospherical,  ///< lattice points of one sphere or circle, exactly
    Coplanar,     ///< exactly in one oblique plane or line
    Ulp,          ///< one of the degenerate families, with coordinates moved by a few units in the last place
    Range         ///< exponents from one end of the exact range to the other, alike or mixed
};
inline constexpr std::size_t kPointKindCount = 6;
inline constexpr std::array<std::string_view, kPointKindCount> kPointKindNames{
    "random", "grid", "cospherical", "coplanar", "ulp", "range"};

[[nodiscard]] std::optional<PointKind> pointKindOf(std::string_view name);

struct PointSets
{
    std::vector<Vec3> space;  ///< five points
    std::vector<Vec2> plane;  ///< four points
};

/// Set number `index` of a family: depends on nothing but the arguments. All points are in the exact range.
[[nodiscard]] PointSets makePointSets(PointKind kind, std::uint64_t seed, std::uint64_t index);

}  // namespace mesher::test
