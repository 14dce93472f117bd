#pragma once

#include "base/vec.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>

namespace mesher {

class Triangulation3d;

/// A bijective mix of 64 bits (the finaliser of splitmix64).
constexpr std::uint64_t mixBits(std::uint64_t x)
{
    x = (x ^ (x >> 30)) * 0xBF58476D1CE4E5B9u;
    x = (x ^ (x >> 27)) * 0x94D049BB133111EBu;
    return x ^ (x >> 31);
}

/// Hash of a place. Coordinates must not be -0.
constexpr std::uint64_t placeHash(Vec3 p)
{
    std::uint64_t h = mixBits(std::bit_cast<std::uint64_t>(p.x) + 0x9E3779B97F4A7C15u);
    h = mixBits(h ^ std::bit_cast<std::uint64_t>(p.y));
    return mixBits((h + 0x632BE59BD9B4E019u) ^ std::bit_cast<std::uint64_t>(p.z));
}

/// Hash of a simplex from those of its vertices, whatever their order; `kind` tells apart what is hashed.
template <std::size_t N>
constexpr std::uint64_t simplexHash(std::array<std::uint64_t, N> vertices, std::uint64_t kind)
{
    std::sort(vertices.begin(), vertices.end());
    std::uint64_t h = mixBits(kind);
    for (const std::uint64_t v : vertices) h = mixBits(h * 3 + v);
    return h;
}

/// A hash of the set of finite tetrahedra by the coordinates of their vertices, and of the constrained faces and edges:
/// equal for equal meshes whatever the numbering and the order of construction.
/// Cost: linear.
std::uint64_t meshHash3d(const Triangulation3d& mesh);

}  // namespace mesher
