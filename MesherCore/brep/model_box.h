#pragma once

#include "base/box.h"
#include "brep/brep_model.h"

namespace mesher {

/// The box of the exact vertices, edges and faces of a model.
/// Guarantees   tight to rounding: an extreme place of a curve is where its tangent has no share of the axis, one inside of a face
///              where its normal is along the axis. Faces of straight lines that run on to the boundary have none inside of them:
///              planes, cylinders, cones and extrusions
/// Cost         some ten evaluations for each span of an edge and some twenty for each patch of a face of another kind; the trim
///              is asked only of places beyond what is known
[[nodiscard]] Box3 boxOf(const BrepModel& model);

}  // namespace mesher
