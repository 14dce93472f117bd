#pragma once

#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>

namespace mesher::detail {

/// Whether all coordinates are multiples of one power of two u and the given bound on all coordinate
/// differences is at most 2^bits * u. Then a determinant of degree n whose terms and partial sums stay below
/// 2^53 * u^n is computed without any rounding, and its sign, zero included, is right: binary grids and
/// models in short decimal or binary fractions are decided that way.
template <std::size_t Count>
bool areShort(const std::array<double, Count>& coordinates, double largestDifference, int bits)
{
    const std::uint64_t exponent = std::bit_cast<std::uint64_t>(largestDifference) >> 52;
    // 2^52 u, where u is the smallest power of two with 2^bits * u > largestDifference. All doubles of that
    // magnitude are multiples of u, so that the sum below rounds to u or coarser and comes back equal only if
    // the coordinate is such a multiple.
    const double rounder =
        std::bit_cast<double>((exponent + 1 + 52 - static_cast<std::uint64_t>(bits)) << 52);
    bool isMultiple = true;
    for (const double coordinate : coordinates) {
        const double magnitude = std::abs(coordinate);
        isMultiple &= (magnitude + rounder) - rounder == magnitude;
    }
    return isMultiple;
}

}  // namespace mesher::detail
