#pragma once

#include "base/vec.h"

#include <cstdint>
#include <span>
#include <vector>

namespace mesher {

/// Orders points so that neighbours in the sequence are neighbours in the plane or in space.
/// Guarantees   a permutation of 0 … n-1, the same on every platform; points in one cell of the finest level
///              (2^-32 of the bounding square, 2^-20 of the bounding cube) keep the order of their indices
/// Requires     fewer than 2^32 points; non-finite coordinates are tolerated, but their place is arbitrary
/// Cost         linear; 16 bytes of scratch per point
/// Reference    [hamilton2008] section 2 for the state machine of the Hilbert curve
std::vector<std::uint32_t> hilbertOrder(std::span<const Vec2> points);
std::vector<std::uint32_t> hilbertOrder(std::span<const Vec3> points);

/// A biased randomised insertion order: a few rounds of geometrically growing random samples, each along the
/// Hilbert curve. The early rounds make the expected cost of incremental Delaunay insertion that of a random
/// order; the curve keeps every round local in memory.
/// Guarantees   as hilbertOrder; a function of the points' order, their coordinates and the seed alone
/// Reference    [amenta2003]; we grow by 8 a round instead of 2, which is kinder to the cache
std::vector<std::uint32_t> brioOrder(std::span<const Vec2> points, std::uint64_t seed);
std::vector<std::uint32_t> brioOrder(std::span<const Vec3> points, std::uint64_t seed);

}  // namespace mesher
