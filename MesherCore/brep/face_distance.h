#pragma once

#include "brep/brep_model.h"

#include <optional>

namespace mesher {

/// Of a place from a face as its edges trim it.
struct FaceDistance
{
    double distance = 0.0;
    double tolerance = 0.0;  ///< of what is nearest: the face, or the edge beyond which the place lies
    Vec2 parameters;         ///< of the foot on the surface; nothing of worth beyond an edge
};

/// The distance from the surface where the foot lies inside of the face's edges, else that from the nearest of the edges.
/// Guarantees   never less than the distance from the trimmed face; more where a search without a seed misses the nearest
///              point, against which the parameters of the place help
/// Cost         a search on the surface and a classification; one on each edge where the foot lies beyond them
[[nodiscard]] FaceDistance distanceFromFace(const BrepModel& model, BrepFaceId face, const Vec3& place,
                                            std::optional<Vec2> parameters = {});

}  // namespace mesher
