#pragma once

#include "predicates/fixed_integer.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>

namespace mesher::detail {

/// Coordinates as integers on the finest grid that `Limbs` limbs allow.
template <std::size_t Limbs, std::size_t Count>
using GridCoordinates = std::array<FixedInteger<Limbs>, Count>;

/// All coordinates have magnitudes below 2^(64 * Limbs - 3) in units of their grid, so that their differences
/// have two bits to spare: the widths of integer_determinants.h count on that.
template <std::size_t Limbs>
inline constexpr int kGridBits = static_cast<int>(64 * Limbs) - 3;

/// The power of two that takes the largest coordinate just below 2^bits; exact, since the exact range keeps
/// all exponents within +-200.
template <std::size_t Count>
double gridScale(const std::array<double, Count>& coordinates, int bits)
{
    // Four running maxima, because one would wait for itself at every step.
    std::array<double, 4> partial{0x1p-200, 0.0, 0.0, 0.0};
    for (std::size_t i = 0; i < Count; ++i)
        partial[i % 4] = std::max(partial[i % 4], std::abs(coordinates[i]));
    const double largest = std::max(std::max(partial[0], partial[1]), std::max(partial[2], partial[3]));
    const auto biasedExponent = static_cast<int>(std::bit_cast<std::uint64_t>(largest) >> 52);
    return std::bit_cast<double>(static_cast<std::uint64_t>(2 * 1023 + bits - 1 - biasedExponent) << 52);
}

/// The integer coordinates, or nothing if some coordinate is finer than the grid.
template <std::size_t Count>
std::optional<GridCoordinates<1, Count>> toGrid64(const std::array<double, Count>& coordinates)
{
    const double scale = gridScale(coordinates, kGridBits<1>);
    GridCoordinates<1, Count> grid;
    bool isExact = true;
    for (std::size_t i = 0; i < Count; ++i) {
        const double scaled = coordinates[i] * scale;
        const auto integer = static_cast<std::int64_t>(scaled);
        isExact &= static_cast<double>(integer) == scaled;
        grid[i] = FixedInteger<1>::fromInt64(integer);
    }
    if (!isExact) return std::nullopt;
    return grid;
}

/// The same with twice the width: all coordinates of 53 bits whose exponents differ by no more than 72 fit.
template <std::size_t Count>
std::optional<GridCoordinates<2, Count>> toGrid128(const std::array<double, Count>& coordinates)
{
    const double scale = gridScale(coordinates, kGridBits<2>);
    GridCoordinates<2, Count> grid;
    bool isExact = true;
    for (std::size_t i = 0; i < Count; ++i) {
        const double scaled = coordinates[i] * scale;
        const auto high = static_cast<std::int64_t>(scaled * 0x1p-62);
        const double rest = scaled - static_cast<double>(high) * 0x1p62;
        const auto low = static_cast<std::int64_t>(rest);
        isExact &= static_cast<double>(low) == rest;
        grid[i] = FixedInteger<2>::fromParts(high, low);
    }
    if (!isExact) return std::nullopt;
    return grid;
}

}  // namespace mesher::detail
