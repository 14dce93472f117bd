#pragma once

#include "base/run_context.h"
#include "brep/brep_model.h"
#include "brep/planar_curve_complex.h"
#include "pipeline/classify_planar.h"
#include "pipeline/mesh_options.h"
#include "pipeline/mesh_report.h"
#include "sizing/sizing_field.h"
#include "triangulation2d/triangulate_planar.h"

#include <memory>
#include <optional>

namespace mesher {

struct PlanarMeshOutcome
{
    /// What was meshed; also when a limit ended the run, but not when it failed.
    std::optional<PlanarMesh> result;
    MeshReport report;
};

/// Meshes the regions of a plane domain: samples, enriches, triangulates, refines, classifies and reports.
/// Guarantees   those of triangulatePlanar; the report says why there is no mesh, or not the whole one
/// Requires     `fromFiles`: the sizes of options.background and options.sizePoints, or none; `model`: that of the complex, or
///              none, and then nodes are left with the rounding of their evaluation (settleNodes)
/// Refuses      options out of range; a mesh that is expected to exceed the limit on elements twice; what planarSizes refuses; elements of second order, which are not there yet
/// Terminates   see PlanarOptions; the limits on elements and time of the options hold
[[nodiscard]] PlanarMeshOutcome meshPlanar(const PlanarCurveComplex& complex, const MeshOptions& options,
                                           std::shared_ptr<const SizingField> fromFiles, int boundaryOrder,
                                           RunContext& context, const BrepModel* model = nullptr);

/// The options of triangulatePlanar that these stand for; `field` must outlive the run.
[[nodiscard]] PlanarOptions planarOptionsOf(const MeshOptions& options, const SizingField* field);

}  // namespace mesher
