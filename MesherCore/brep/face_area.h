#pragma once

#include "brep/brep_model.h"

namespace mesher {

/// Area of a face from its loops by Green's theorem in the parameters, model units squared; positive.
/// Guarantees   right to about 1e-6 on smooth faces, by a fixed number of evaluations per coedge
[[nodiscard]] double areaOf(const BrepModel& model, const BrepFace& face);

}  // namespace mesher
