#pragma once

#include "refinement/refinement_state3d.h"

#include <vector>

namespace mesher {

/// The meshed tetrahedra that are too large or bad still, each with the reason; `isStopped` tells that the run was ended
/// before. Nothing changes but scratch memory.
/// Reference    [gosselin] section 4.3 for what small angles spoil
[[nodiscard]] std::vector<LeftTet3d> collectLeftTets(RefinementState3d& state, bool isStopped);

}  // namespace mesher
