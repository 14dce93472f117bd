#pragma once

#include "base/random.h"
#include "base/vec.h"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <utility>
#include <vector>

namespace mesher::test {

// Point sets that are hard for geometric code. Every generator returns exactly `count` points and depends on
// its arguments only. "Exactly" in a comment is meant: the property holds of the doubles themselves, and so
// every predicate that asks for it is zero.

/// Uniform in the unit square.
std::vector<Vec2> uniformPoints2d(std::size_t count, std::uint64_t seed);
/// The integer grid, row by row; the last row may be incomplete.
std::vector<Vec2> gridPoints2d(std::size_t count);
/// Exactly on concentric circles, 64 lattice points on each, the radius doubling; repeats itself after 6400.
std::vector<Vec2> cocircularPoints2d(std::size_t count, std::uint64_t seed);
/// On the unit circle up to rounding.
std::vector<Vec2> circlePoints2d(std::size_t count, std::uint64_t seed);
/// Exactly on one slanted line, distinct, in random order.
std::vector<Vec2> collinearPoints2d(std::size_t count, std::uint64_t seed);
/// Exactly on one slanted line but for the last point.
std::vector<Vec2> nearlyCollinearPoints2d(std::size_t count, std::uint64_t seed);
/// A tenth as many distinct points, each repeated about ten times, in random order.
std::vector<Vec2> duplicatedPoints2d(std::size_t count, std::uint64_t seed);
/// Within two units in the last place of the points of a slanted line (1 + i, 1 + i).
std::vector<Vec2> ulpPoints2d(std::size_t count, std::uint64_t seed);
/// Uniform, scaled by 2^100.
std::vector<Vec2> hugePoints2d(std::size_t count, std::uint64_t seed);
/// Uniform, scaled by 2^-100.
std::vector<Vec2> tinyPoints2d(std::size_t count, std::uint64_t seed);
/// A grid of spacing 2^-40 at (1, 1): most bits of the coordinates are common to all.
std::vector<Vec2> farOffsetGridPoints2d(std::size_t count);
/// One point, `count` times.
std::vector<Vec2> equalPoints2d(std::size_t count);
/// Clusters of 50 whose radii range over twelve powers of ten.
std::vector<Vec2> clusteredPoints2d(std::size_t count, std::uint64_t seed);

/// Uniform in the unit cube.
std::vector<Vec3> uniformPoints3d(std::size_t count, std::uint64_t seed);
/// The integer grid, row by row and layer by layer; the last layer may be incomplete.
std::vector<Vec3> gridPoints3d(std::size_t count);
/// Exactly on concentric spheres: all lattice points of each, several hundred or more.
std::vector<Vec3> cosphericalPoints3d(std::size_t count, std::uint64_t seed);
/// On the unit sphere up to rounding.
std::vector<Vec3> spherePoints3d(std::size_t count, std::uint64_t seed);
/// Exactly on one slanted plane.
std::vector<Vec3> coplanarPoints3d(std::size_t count, std::uint64_t seed);
/// A grid in a coordinate plane: exactly coplanar and cocircular.
std::vector<Vec3> coplanarGridPoints3d(std::size_t count);
/// Exactly on one slanted plane but for the last point.
std::vector<Vec3> nearlyCoplanarPoints3d(std::size_t count, std::uint64_t seed);
/// Exactly on one slanted line, distinct, in random order.
std::vector<Vec3> collinearPoints3d(std::size_t count, std::uint64_t seed);
/// A tenth as many distinct points, each repeated about ten times, in random order.
std::vector<Vec3> duplicatedPoints3d(std::size_t count, std::uint64_t seed);
/// Within two units in the last place of the corners of the cubes (1 + i)^3.
std::vector<Vec3> ulpPoints3d(std::size_t count, std::uint64_t seed);
/// Uniform, scaled by 2^100.
std::vector<Vec3> hugePoints3d(std::size_t count, std::uint64_t seed);
/// Uniform, scaled by 2^-100.
std::vector<Vec3> tinyPoints3d(std::size_t count, std::uint64_t seed);
/// A grid of spacing 2^-40 at (1, 1, 1): most bits of the coordinates are common to all.
std::vector<Vec3> farOffsetGridPoints3d(std::size_t count);
/// One point, `count` times.
std::vector<Vec3> equalPoints3d(std::size_t count);
/// On the surface of a torus of radii 1 and 0.4 up to rounding, uniform by area.
std::vector<Vec3> torusPoints3d(std::size_t count, std::uint64_t seed);
/// Clusters of 50 whose radii range over twelve powers of ten.
std::vector<Vec3> clusteredPoints3d(std::size_t count, std::uint64_t seed);

/// A named generator, for tests that run over all of them.
template <class Point>
struct PointFamily
{
    std::string name;  ///< snake_case
    /// How many dimensions the points span, once there are at least fifty of them.
    int span;
    std::function<std::vector<Point>(std::size_t count, std::uint64_t seed)> make;
};

const std::vector<PointFamily<Vec2>>& pointFamilies2d();
const std::vector<PointFamily<Vec3>>& pointFamilies3d();

/// Puts the items in an order that depends on the state of `random` only (unlike std::shuffle, on every
/// standard library the same).
template <class T>
void shuffle(std::vector<T>& items, Random& random)
{
    for (std::size_t i = items.size(); i > 1; --i) {
        std::swap(items[i - 1], items[random.below(static_cast<std::uint32_t>(i))]);
    }
}

}  // namespace mesher::test
