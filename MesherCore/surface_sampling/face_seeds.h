#pragma once

#include "brep/brep_model.h"

#include <vector>

namespace mesher {

/// Parameters of a grid over a face's bounds, with a line wherever the surface's normal has turned by about 45 degrees since
/// the last one. Empty for faces that are straight one way: their outlines show all of their turning.
/// Cost         a few evaluations per break of the surface; no more than 65,536 points
[[nodiscard]] std::vector<Vec2> seedsOf(const BrepFace& face);

}  // namespace mesher
