#pragma once

#include "base/error.h"
#include "base/run_context.h"
#include "base/stop_reason.h"
#include "brep/brep_model.h"
#include "mesh/region_sides.h"
#include "sizing/sizing_field.h"
#include "surface_sampling/sample_surface.h"

#include <memory>
#include <optional>

namespace mesher {

/// Sizes by the features of a shape, or why there are none.
struct FeatureSizes
{
    std::shared_ptr<const SizingField> field;  ///< null without a shape that could be sampled
    StopReason stopReason = StopReason::Done;
    std::optional<Error> failure;
};

/// The local feature size over R on curves and faces, linear between the vertices of a mesh that is as coarse as the shape
/// allows, growing by distance / G on them and off them. Which sizes the user asks for does not count: they are no features.
/// Walls that are kept flat, as `shape.walls` says, are no features: nothing is to be as small as they are thick.
/// Guarantees   sizes at R are R times smaller than at 1
/// Requires     `shape` without sizes; sides of solids, or of none: then distances are those on the faces alone
/// Cost         a coarse surface mesh and its tetrahedralization
/// Reference    [gosselin] section 4.4
[[nodiscard]] FeatureSizes featureSizes(const BrepModel& model, const RegionSides& sides,
                                        const SurfaceSamplingOptions& shape, double refinement,
                                        double grading, RunContext& context);

}  // namespace mesher
