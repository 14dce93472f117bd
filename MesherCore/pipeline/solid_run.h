#pragma once

#include "base/run_context.h"
#include "brep/brep_model.h"
#include "mesh/region_sides.h"
#include "pipeline/mesh_options.h"
#include "pipeline/mesh_outcome.h"
#include "pipeline/wall_budget.h"
#include "sizing/sizing_field.h"
#include "surface_sampling/sample_surface.h"
#include "tetrahedralization/tetrahedralize.h"

#include <memory>

namespace mesher {

/// The stages of one component in their order, surfaces first and volumes later: in between, solids can be compared with those of
/// other components. Each step returns whether the next one may follow; why not is in the report.
/// Requires     model, options and context outlive it
/// Terminates   by the limits of the options, and of the context on time
class SolidRun
{
public:
    SolidRun(const BrepModel& model, const MeshOptions& options, std::shared_ptr<const SizingField> sizes,
             const WallBudget& budget, RunContext& context);

    bool sampleSurfaces();

    /// Of sampleSurfaces, null if that failed.
    [[nodiscard]] const SurfaceMesh* surface() const;
    [[nodiscard]] const RegionSides& sides() const { return sides_; }

    [[nodiscard]] MeshOutcome meshVolumes();
    /// What there is of a run that goes no further.
    [[nodiscard]] MeshOutcome keepSurface();
    /// Instead of all the others: faces alone, as surfaces in space.
    [[nodiscard]] MeshOutcome meshFaces();

private:
    bool findSides();
    bool findFeatures();
    bool sample();
    bool boundsVolumes();
    bool tetrahedralizeSample();
    bool refine();
    template <class Classify>
    bool classify(Classify make);
    void improve();

    [[nodiscard]] SurfaceSamplingOptions samplingOfShape() const;
    [[nodiscard]] MeshReport& report() { return outcome_.report; }
    bool failed(Error error);
    bool mayGoOn(StopReason reason);

    const BrepModel& model_;
    const MeshOptions& options_;
    WallBudget budget_;
    RunContext& context_;
    RegionSides sides_;
    std::shared_ptr<const SizingField> wishes_;  ///< the sizes that the user asks for
    std::shared_ptr<const SizingField> sizes_;  ///< these and the features' of the shape, on curves and faces
    SurfaceSample sample_;
    bool isSampled_ = false;
    Tetrahedralization tetrahedralization_;
    MeshOutcome outcome_;
};

}  // namespace mesher
