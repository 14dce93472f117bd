#pragma once

#include "base/run_context.h"
#include "brep/brep_model.h"
#include "brep/model_measures.h"
#include "pipeline/estimate.h"
#include "pipeline/mesh_options.h"
#include "sizing/sizing_field.h"

#include <memory>

namespace mesher {

/// For the solids of a model, without meshing anything: tetrahedra of the wanted size in their volume, and layers of finer
/// ones along faces that are curved.
/// Guarantees   a factor of about two where the sizes asked for or curvature decide; where fine details of the shape do it is
///              far too low, and without the volume where that is not known. It never takes long: a run asks it first
/// Requires     valid options; the field of solidSizes (may be null)
/// Terminates   early when the run is to end; the estimate is worth nothing then, as below
/// Cost         evaluations of faces on a grid, and of the field on at most 300,000 cells of an octree
[[nodiscard]] MeshEstimate estimateSolids(const BrepModel& model, const ModelMeasures& measures,
                                          const MeshOptions& options, const SizingField* sizes,
                                          RunContext& context);

/// The same with the facets that the shape itself needs, of a sample of its surface without sizes: what users are told.
/// Guarantees   a factor of 1.5 on ordinary parts, of two where walls are thinner than the sizes; a quarter where sizes grow by
///              more than a third of the distance, which no mesh follows, as with `refinement`. Where the surface cannot be
///              sampled, or not with 60,000 vertices, it is the estimate above
/// Cost         a sample of the surface besides, whose size does not depend on the sizes asked for
[[nodiscard]] MeshEstimate estimateSolidsBySample(const BrepModel& model, const MeshOptions& options,
                                                  std::shared_ptr<const SizingField> sizes,
                                                  RunContext& context);

}  // namespace mesher
