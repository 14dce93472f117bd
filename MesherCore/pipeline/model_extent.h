#pragma once

#include "base/result.h"
#include "brep/brep_model.h"

namespace mesher {

/// Whether lengths of the model can be told apart by the tolerances of CAD kernels, 1e-7, and by numbers of 16 digits.
/// Refuses      a model that is smaller than 1e-5 across, larger than 1e9, or so far from the origin that its own coordinates
///              have fewer than 4 digits that differ
[[nodiscard]] Result<void> checkExtent(const BrepModel& model);

}  // namespace mesher
