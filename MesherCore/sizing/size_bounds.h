#pragma once

#include <numbers>

namespace mesher {

/// The largest circumradii of facets and tetrahedra by the size wanted, above which they are split.
struct SizeBounds
{
    double facet = 0.0;
    double tet = 0.0;
};

/// For the edge length that a user asks for. It is the mean edge on curves and surfaces; inside of solids, where tetrahedra lie as
/// they come, edges are longer by three tenths, as other meshers have them. Edges come out below such a bound by a share which has no
/// formula, so these were measured (docs/algorithms/surface_refinement.md): at the bounds of the thesis edges on surfaces are
/// 0.9 sizes in the mean and those inside 1.0, and there are 2.1 to 2.4 times the tetrahedra that others make for the same size.
inline constexpr SizeBounds kEdgeSizeBounds{.facet = 0.8, .tet = 1.3};

/// For length scales by the local feature size.
/// Reference    [gosselin] section 4.4, with lambda = 1
inline constexpr SizeBounds kFeatureSizeBounds{.facet = 0.5 * std::numbers::sqrt2,
                                               .tet = 0.5 * std::numbers::sqrt3};

/// The edge length asked for where the length scale by the local feature size is one. The thesis splits edges that are longer than the
/// sum of the scales of their ends, and so has edges of one to two scales. With this one no more vertices come out than by its rules.
inline constexpr double kEdgeOfFeatureScale = 1.2;

/// The halves of a segment longer than that many sizes are nearer to the size than the whole.
inline constexpr double kSegmentBound = std::numbers::sqrt2;

}  // namespace mesher
