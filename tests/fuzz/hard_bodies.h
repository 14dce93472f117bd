#pragma once

#include "random_primitives.h"

namespace mesher::test {

/// A body about `size` across as modelling by sketches makes it: a pad with drafted walls, a sweep along a spline or a helix, a loft
/// between unlike sections, a lathe profile that meets its axis, or a stretched one whose surfaces are all splines.
/// May throw what the kernel throws.
[[nodiscard]] NamedShape hardBody(Draws& draws, const gp_Pnt& place, double size);

}  // namespace mesher::test
