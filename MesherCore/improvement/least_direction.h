#pragma once

#include "base/vec.h"

#include <span>

namespace mesher {

/// The vector of least length in the convex hull of some: the direction in which the least of several functions with these
/// gradients grows fastest, by the square of its length at least. Zero, or nearly, where no direction raises all of them.
/// Guarantees   up to a fortieth of its length; the same for the same order of gradients
/// Terminates   after 64 steps of Gilbert's method
/// Reference    [freitag1997] has the question, [gilbert1966] the method
[[nodiscard]] Vec3 leastOfHull(std::span<const Vec3> gradients);

}  // namespace mesher
