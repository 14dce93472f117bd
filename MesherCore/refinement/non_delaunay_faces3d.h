#pragma once

#include "refinement/delaunay_refinement3d.h"
#include "refinement/refinement_state3d.h"

#include <vector>

namespace mesher {

/// The unconstrained faces of solids that are not locally Delaunay, grouped by reason and place, those with the most faces
/// first. `isFinished`: flips and refinement have left them, instead of having been ended.
/// Cost         linear in the tetrahedra
/// Reference    [gosselin] §3.3.3: a constrained Delaunay tetrahedralization need not exist
[[nodiscard]] std::vector<NonDelaunayFaces3d> explainNonDelaunayFaces(RefinementState3d& state,
                                                                      bool isFinished);

}  // namespace mesher
