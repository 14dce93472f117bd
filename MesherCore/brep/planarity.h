#pragma once

#include "base/result.h"
#include "brep/brep_model.h"
#include "brep/plane_frame.h"

#include <span>
#include <vector>

namespace mesher {

/// Points of the edges of a face, in the order of its loops.
[[nodiscard]] std::vector<Vec3> sampleBoundary(const BrepModel& model, const BrepFace& face);

/// The plane of a face: of its surface, or one through its boundary from which the face departs by no more than its tolerance.
/// The normal is on the side of du x dv. An Error tells how far from a plane the face is.
[[nodiscard]] Result<PlaneFrame> planeOfFace(const BrepModel& model, BrepFaceId face);

/// Whether the faces have one plane in common, within their tolerances. What is wrong with their edges does not count.
[[nodiscard]] bool lieInOnePlane(const BrepModel& model, std::span<const BrepFaceId> faces);

}  // namespace mesher
