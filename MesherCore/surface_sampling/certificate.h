#pragma once

#include "base/budget.h"
#include "base/error.h"
#include "base/run_context.h"
#include "surface_sampling/sampled_surface.h"

#include <cstddef>
#include <vector>

namespace mesher {

struct SurfaceCertificate
{
    int rounds = 0;
    std::size_t found = 0;   ///< intersections in the first round
    std::size_t shared = 0;  ///< edges inside of two faces between the same nodes, in the first round
    std::size_t left = 0;    ///< in the last one
    SamplingRounds refinement;
    /// For what is left, one for each pair of faces: both faces, the point, a remedy.
    std::vector<Error> errors;
};

/// Verifies that the facets of a surface bound volumes: no two have more in common than nodes and segments. Where they have, the
/// larger one is split, and the faces are refined again.
/// Guarantees   with no errors, exactly that (findFacetIntersections says so); shapes and sizes as sampleSurface has them
/// Terminates   after `maxRounds`, or when no facet in question can be split, or splitting them does not lower the number of
///              intersections of their faces
/// Cost         a search for intersections per round
/// Reference    [gosselin] Fig. 3.10 is where it is needed; the test of pairs of faces is our own
[[nodiscard]] SurfaceCertificate certify(SampledSurface& surface, const BudgetLimits& limits, int maxRounds,
                                         RunContext& context);

}  // namespace mesher
