#pragma once

#include "base/result.h"
#include "base/run_context.h"
#include "brep/planar_curve_complex.h"
#include "pipeline/mesh_options.h"
#include "sizing/sizing_field.h"

#include <memory>
#include <string>

namespace mesher {

/// What a run is going to take, told before it starts; good to a factor of about two.
struct MeshEstimate
{
    double elements = 0.0;  ///< triangles, or tetrahedra
    double bytes = 0.0;     ///< at the peak
    double seconds = 0.0;   ///< on one thread of an ordinary machine
    double forSizes = 0.0;  ///< elements that the sizes alone ask for, whatever bends
    std::string
        entity{};  ///< that most of them are at, where one has far more than all the others; else empty
    bool isLeast = false;  ///< what the shape needs is not known; it may be far more
};

/// The memory and time of so many triangles.
[[nodiscard]] MeshEstimate costOfTriangles(double triangles);

/// For a plane domain, from its initial triangulation; `fromFiles` as for meshPlanar.
/// Refuses      what meshPlanar refuses
[[nodiscard]] Result<MeshEstimate> estimatePlanar(const PlanarCurveComplex& complex,
                                                  const MeshOptions& options,
                                                  std::shared_ptr<const SizingField> fromFiles,
                                                  RunContext& context);

/// The elements up to which an estimate still lets a run begin, since it may be too high.
[[nodiscard]] double mostExpectedElements(const MeshOptions& options);

/// Refuses, with the estimate, what would surely need more elements than the options allow.
[[nodiscard]] Result<void> checkAffordable(const MeshEstimate& estimate, const MeshOptions& options);

}  // namespace mesher
