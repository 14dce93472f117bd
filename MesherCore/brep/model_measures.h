#pragma once

#include "base/run_context.h"
#include "brep/brep_model.h"

namespace mesher {

/// Model units cubed.
struct SolidVolume
{
    double value = 0.0;
    /// About how far off the value may be: what the vector areas of the faces, which cancel on a closed shell, leave over,
    /// times a third of the box's diagonal.
    double uncertainty = 0.0;
};

/// Volume and areas of a model, in model units.
struct ModelMeasures
{
    SolidVolume volume;                   ///< of all solids
    IdVector<BrepFaceId, double> areaOf;  ///< of each face

    [[nodiscard]] double area() const;
};

/// Integrates over all faces of a model, by Green's theorem in the parameters and the divergence theorem.
/// Guarantees   areas right to about 1e-6 on smooth faces, and so are volumes
/// Requires     closed shells for the volume; with others its uncertainty is large
/// Terminates   at once when the run is to end; the measures are worth nothing then
/// Cost         a fixed number of evaluations per coedge
[[nodiscard]] ModelMeasures measureModel(const BrepModel& model, RunContext& context);

}  // namespace mesher
