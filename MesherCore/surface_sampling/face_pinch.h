#pragma once

#include "base/error.h"
#include "brep/brep_model.h"

#include <optional>

namespace mesher {

/// Refuses a face that holds a point at which its surface meets itself (Surface::pinchesV) in its inside: no mesh of triangles
/// around it is that of a surface.
/// Cost         none for most surfaces, else a few questions to the trim
[[nodiscard]] std::optional<Error> refusePinch(const BrepModel& model, BrepFaceId f);

}  // namespace mesher
