#pragma once

#include "base/id_vector.h"
#include "base/ids.h"
#include "base/result.h"
#include "brep/brep_model.h"

#include <array>

namespace mesher {

/// The regions on the two sides of each face: first the one that du x dv of its surface points into, then the one behind.
/// Region 0 is outside of all solids, i + 1 is solid i.
using RegionSides = IdVector<BrepFaceId, std::array<RegionId, 2>>;

/// The sides of all faces as the shells of the solids tell them: voids, faces between two solids and faces inside of one
/// included. A face of no solid has region 0 on both sides.
/// Errors   two solids on one side of a face (InvalidArgument, names the face)
Result<RegionSides> regionSidesOf(const BrepModel& model);

}  // namespace mesher
