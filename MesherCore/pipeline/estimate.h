#pragma once

#include "base/result.h"
#include "brep/brep_model.h"
#include "pipeline/mesh_options.h"

#include <cstdint>

namespace mesher {

/// What a run is going to take, told before it starts; good to a factor of about two.
struct MeshEstimate
{
    double elements = 0.0;  ///< triangles
    double bytes = 0.0;     ///< at the peak
    double seconds = 0.0;   ///< on one thread of an ordinary machine
};

/// For the plane faces of a model: N = area / (0.433 h^2) where a size is asked for, never fewer than the boundary needs.
[[nodiscard]] MeshEstimate estimatePlanar(const BrepModel& model, const MeshOptions& options);

/// Refuses, with the estimate, what would surely need more elements than the options allow.
[[nodiscard]] Result<void> checkAffordable(const MeshEstimate& estimate, const MeshOptions& options);

}  // namespace mesher
