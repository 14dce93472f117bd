#pragma once

#include "base/budget.h"
#include "base/run_context.h"
#include "base/stop_reason.h"
#include "triangulation2d/length_scale2d.h"
#include "triangulation2d/planar_triangulation.h"
#include "triangulation2d/subcurve_split2d.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace mesher {

struct RefinementOptions2d
{
    /// Smallest angle wanted, degrees. Up to 25.7 the algorithm is proven to end and to grade the mesh well, provided that
    /// input curves meet at 60 degrees or more (smaller angles are protected); in practice it ends up to about 33. What is
    /// beyond the reach of a domain is given up for the default. 0 asks for no quality.
    double minAngle = 30.0;
    PlanarSizing sizing;
};

/// Why a triangle was left though its shape or size is not what was asked for.
enum class LeftReason2d
{
    SmallInputAngle,  ///< its shortest edge spans a small angle of the input between two vertices of one shell
    Resolution,  ///< the boundary beside it is too short to be split, or its circumcentre cannot be told apart
    Unfinished   ///< the run stopped before
};

struct LeftTriangle2d
{
    TriangleId triangle;
    LeftReason2d reason = LeftReason2d::Unfinished;
    SmallAngleId smallAngle;       ///< for SmallInputAngle
    std::uint32_t inputAngle = 0;  ///< for SmallInputAngle: which of the complex's angles it lies beside
    double smallestAngle = 0.0;
    double largestAngle = 0.0;
};

/// An angle that more vertices did not bring nearer.
struct UnreachableAngle2d
{
    double kept = 0.0;            ///< that was kept in its place, degrees
    std::uint64_t bad = 0;        ///< triangles with smaller ones when it was given up
    std::uint64_t triangles = 0;  ///< of regions, then
};

struct Refinement2d
{
    StopReason stopReason = StopReason::Done;
    std::size_t sizeInsertions = 0;
    std::size_t qualityInsertions = 0;
    std::size_t rejectedCircumcenters = 0;
    std::size_t sizeSplits = 0;
    std::size_t encroachmentSplits = 0;
    std::size_t lostWalks = 0;
    std::size_t sweeps = 0;
    SubcurveSplitCounters2d splitting;
    std::vector<LeftTriangle2d> left;
    std::optional<UnreachableAngle2d> unreachable;
};

/// Refines a constrained Delaunay triangulation until no triangle is too large or has too small an angle: Shewchuk's
/// hybrid of the algorithms of Ruppert and Chew, with diametral lenses, on curves.
/// Guarantees   with StopReason::Done every triangle of a region meets the bound and the size, except those in `left`,
///              each with its reason; the triangulation stays constrained Delaunay
/// Requires     an initial triangulation without visible vertices in diametral circles (constrained_delaunay2d.h), with
///              length scales (length_scale2d.h) if the sizing is active
/// Terminates   see RefinementOptions2d::minAngle; always with a budget
/// Cost         O(n log n) worst, linear in practice
/// Reference    thesis sections 2.3, 2.4.4, 2.5, appendix A; [shewchuk2002] [chew1993] [ruppert1995] [miller2003]
[[nodiscard]] Refinement2d refine(const PlanarDomain& domain, const RefinementOptions2d& options,
                                  RunContext& context, Budget& budget, PlanarTriangulation& triangulation);

}  // namespace mesher
