#pragma once

#include "brep/brep_model.h"

namespace mesher {

/// Model units cubed.
struct SolidVolume
{
    double value = 0.0;
    /// About how far off the value may be: what the vector areas of the faces, which cancel on a closed shell, leave over,
    /// times a third of the box's diagonal.
    double uncertainty = 0.0;
};

/// The volume of all solids, by the divergence theorem over their faces.
/// Requires     closed shells; with others the uncertainty is large
/// Cost         a fixed number of evaluations per coedge
[[nodiscard]] SolidVolume volumeOf(const BrepModel& model);

}  // namespace mesher
