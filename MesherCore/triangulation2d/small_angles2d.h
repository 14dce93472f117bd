#pragma once

#include "base/id_vector.h"
#include "triangulation2d/boundary.h"

#include <cstddef>
#include <vector>

namespace mesher {

/// An angle below the limit between two neighbouring curves of the input, over a meshed region.
struct InputAngle
{
    PccCurveId first;  ///< the curves in counter-clockwise order
    PccCurveId last;
    double degrees = 0.0;
};

/// A small angle complex: curves that form contiguous small angles at an apex.
struct SmallAngleComplex
{
    BoundaryVertexId apex;
    std::vector<InputAngle> angles;  ///< angle i lies between spokes i and i + 1; the last may close the turn
    int firstShell = 0;              ///< exponent of the shell that protects it

    [[nodiscard]] double smallestAngle() const;
    /// Which angle lies between two neighbouring spokes, in either order.
    [[nodiscard]] std::uint32_t angleBetween(std::uint32_t spoke, std::uint32_t other) const;
};

struct SmallAngles2d
{
    /// Any input angle below it is small.
    static constexpr double kLimitDegrees = 60.0;

    IdVector<SmallAngleId, SmallAngleComplex> complexes;
    std::size_t splits = 0;
    /// Subcurves that could not be cut at the shell because their distance from the apex is not monotone.
    std::size_t unprotected = 0;
};

/// Finds the small angle complexes and cuts their subcurves at a shell around the apex, so that the edges at the apex
/// have one length and no cascade of splits can start there.
/// Guarantees   the edges of a complex at its apex are all 2^k long, up to rounding and `unprotected`; an unmeshed wedge
///              is no small angle, because nothing sees across it
/// Cost         linear, but for the sorting of the curves around each point
/// Reference    thesis section 2.5; [miller2003]
[[nodiscard]] SmallAngles2d protectSmallAngles(const PlanarDomain& domain, Boundary& boundary);

}  // namespace mesher
