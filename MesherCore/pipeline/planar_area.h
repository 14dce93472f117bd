#pragma once

#include "brep/brep_model.h"

#include <optional>

namespace mesher {

/// Area of a plane face from its exact boundary curves by Green's theorem, model units squared; nothing if the face is not plane.
/// Cost         a Gauss rule of five points on sixteen panels between the knots of each edge
[[nodiscard]] std::optional<double> planarArea(const BrepModel& model, BrepFaceId face);

/// Length of an edge, by the same rule.
[[nodiscard]] double edgeLength(const BrepEdge& edge);

}  // namespace mesher
