#pragma once

#include "base/result.h"
#include "base/run_context.h"
#include "pipeline/model_components.h"

#include <array>
#include <optional>
#include <vector>

namespace mesher {

/// A triangle that stands for a piece of a face.
struct CoarseFacet
{
    std::array<Vec3, 3> corner;
    double departure = 0.0;  ///< about how far the face goes from it
};

/// The faces of a part of a model as few triangles, for purposes that need no mesh, such as the distance from a face by which
/// sizes grow. Those of a solid are closed.
/// Guarantees   on average the faces depart from them by at most `sag`; the same for any number of threads
/// Refuses      faces that cannot be sampled, by their names in the whole model
/// Terminates   early when the run is to end: the triangles are coarser then
[[nodiscard]] Result<std::vector<CoarseFacet>> coarseFaces(const ModelComponent& part, double sag,
                                                           RunContext& context);

/// A context that shares threads and cancellation with another, whose progress is that of the stage "sizes".
[[nodiscard]] RunSettings sizesSettings(RunContext& context);

}  // namespace mesher
