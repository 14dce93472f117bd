#pragma once

#include "base/budget.h"
#include "base/result.h"
#include "base/run_context.h"
#include "base/stop_reason.h"
#include "brep/planar_curve_complex.h"
#include "triangulation2d/boundary_enrichment.h"
#include "triangulation2d/curve_sampling.h"
#include "triangulation2d/delaunay_refinement2d.h"
#include "triangulation2d/planar_triangulation.h"

#include <cstddef>
#include <limits>

namespace mesher {

struct PlanarOptions
{
    CurveSamplingOptions sampling;
    RefinementOptions2d refinement;
    /// Vertices, triangles, operations and time; the default ends runs that were going to fill the memory.
    BudgetLimits limits{.maxElements = 50'000'000};
    /// If false, the result is the initial constrained Delaunay triangulation.
    bool isRefined = true;
    /// Refinement that is expected (planar_estimate.h) to end with more triangles than this does not begin: the result is the
    /// initial triangulation, with StopReason::ElementLimit.
    double mostExpectedTriangles = std::numeric_limits<double>::infinity();
};

/// What the steps did.
struct PlanarCounts
{
    std::size_t sampleVertices = 0;    ///< after the sampling of the curves
    std::size_t smallAngleSplits = 0;  ///< subcurves cut at shells
    BoundaryEnrichment2d enrichment;
    std::size_t initialVertices = 0;
    std::size_t initialTriangles = 0;  ///< of regions
    double expectedTriangles = 0.0;    ///< before the refinement, see planar_estimate.h
    std::size_t vertices = 0;
    std::size_t triangles = 0;  ///< of regions
    std::size_t boundaryEdges = 0;
};

/// Seconds on the wall clock.
struct PlanarTimes
{
    double sampling = 0.0;
    double enrichment = 0.0;
    double initialTriangulation = 0.0;
    double refinement = 0.0;
};

struct PlanarResult
{
    PlanarTriangulation triangulation;
    StopReason stopReason = StopReason::Done;
    PlanarCounts counts;
    PlanarTimes seconds;
    Refinement2d refinement;
};

/// Meshes the regions of a planar domain bounded by curves with triangles of good quality.
/// Guarantees   a constrained Delaunay triangulation of all points and curves; each boundary vertex is its curve's exact
///              point; with StopReason::Done all angles are at least `minAngle`, except in triangles listed in
///              `refinement.left` (planar_check.h verifies it all)
/// Refuses      options out of range; see planar_domain.h, curve_sampling.h, boundary_enrichment.h and
///              constrained_delaunay2d.h for what is refused of the input
/// Terminates   see RefinementOptions2d::minAngle; always within the limits, the reason told
/// Cost         O(n log n), nearly all of it in the refinement
/// Reference    thesis chapter 2, [gosselin]
[[nodiscard]] Result<PlanarResult> triangulatePlanar(const PlanarCurveComplex& complex,
                                                     const PlanarOptions& options, RunContext& context);

}  // namespace mesher
