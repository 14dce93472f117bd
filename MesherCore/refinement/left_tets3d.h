#pragma once

#include "refinement/refinement_state3d.h"

#include <span>
#include <vector>

namespace mesher {

/// The meshed tetrahedra that are too large or bad still, each with the reason; `isStopped` tells that a limit has ended the
/// run before, `costliest` where it has spent its work if it was ended for want of headway. Nothing changes but scratch memory.
/// Reference    [gosselin] section 4.3 for what small angles spoil
[[nodiscard]] std::vector<LeftTet3d> collectLeftTets(RefinementState3d& state, bool isStopped,
                                                     std::span<const WorkLedger3d::Entry> costliest);

}  // namespace mesher
