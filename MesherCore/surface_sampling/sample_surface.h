#pragma once

#include "base/budget.h"
#include "base/error.h"
#include "base/result.h"
#include "base/run_context.h"
#include "base/stop_reason.h"
#include "brep/brep_model.h"
#include "surface_sampling/certificate.h"
#include "surface_sampling/curve_chains.h"
#include "surface_sampling/initial_face_mesh.h"
#include "surface_sampling/narrow_strips.h"
#include "surface_sampling/sampled_surface.h"
#include "surface_sampling/surface_refinement.h"
#include "surface_sampling/wall_refinement.h"
#include "surface_sampling/wall_survey.h"

#include <cstddef>
#include <memory>
#include <utility>
#include <vector>

namespace mesher {

struct SurfaceSamplingOptions
{
    CurveChainOptions curves;
    InitialFaceMeshOptions initial;
    FacetCriteriaOptions facets;
    /// See FacetSplitOptions, degrees in [90, 150].
    double encroachmentAngle = 90.0;
    /// Neither angles nor encroachment make edges shorter than this, model units; 0 for a 20,000th of the model's diagonal, or
    /// a 20th of the largest size if that is less. Never below ten times the tolerance of the face or edge.
    double minSize = 0.0;
    WallRefinementOptions walls;
    /// For the model as a whole; faces are stopped when one of them alone, or all together, have so many vertices.
    BudgetLimits limits{.maxVertices = 20'000'000};
    /// Rounds in which faces wait for each other's splits of segments.
    int maxRounds = 1000;
    /// Rounds in which intersecting facets are split; -1 does without the search for them.
    int maxCertificateRounds = 20;
};

struct SurfaceSamplingCounts
{
    std::size_t curveNodes = 0;       ///< after the sampling of the curves, model vertices included
    std::size_t initialVertices = 0;  ///< of the first meshes
    std::size_t initialFacets = 0;
    std::size_t initialLeftAlone = 0;  ///< of these, InitialFaceMesh::leftAlone
    std::size_t openTips = 0;          ///< InitialFaceMesh::openTips
    std::size_t vertices = 0;
    std::size_t segments = 0;
    std::size_t facets = 0;
    std::size_t unprotectedAngles = 0;
    SamplingRounds rounds;
    FaceRefinementCounts refinement;
    std::vector<BrepFaceId> facesWithoutAngle;  ///< on which the least angle asked for is out of reach
    std::vector<SurveyedWall> surveyedWalls;
    std::vector<SurveyedStrip> surveyedStrips;
    WallRefinement walls;
    SurfaceCertificate certificate;
};

/// Seconds on the wall clock.
struct SurfaceSamplingTimes
{
    double curves = 0.0;
    double initial = 0.0;
    double refinement = 0.0;
    double walls = 0.0;
    double certificate = 0.0;
};

struct SurfaceSample
{
    std::unique_ptr<SampledSurface> surface;  ///< null where the run ended before there were first facets
    StopReason stopReason = StopReason::Done;
    SurfaceSamplingCounts counts;
    SurfaceSamplingTimes seconds;
    /// Faces that have no facets, and why.
    std::vector<std::pair<BrepFaceId, Error>> failures;
};

/// Samples the curves and faces of a model: chains, first meshes, refinement for size and quality, then for thin walls, and the
/// certificate that facets do not intersect, whose errors are in the counts.
/// Guarantees   a surface mesh as mesh/surface_mesh.h says, of all faces that did not fail (surface_check.h verifies it); with
///              StopReason::Done each facet is as asked, but for those counted as left; the same for any number of threads
/// Refuses      options out of range, and what curve_chains.h refuses
/// Terminates   by the limits; see face refinement for what may need them
/// Reference    thesis §3.3.1, §3.3.2
[[nodiscard]] Result<SurfaceSample> sampleSurface(const BrepModel& model,
                                                  const SurfaceSamplingOptions& options, RunContext& context);

}  // namespace mesher
