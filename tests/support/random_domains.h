#pragma once

#include "brep/planar_curve_complex.h"

#include <cstdint>
#include <string>

namespace mesher::test {

struct RandomDomain
{
    PlanarCurveComplex complex;
    std::string description;  ///< what it is made of, for reports
};

/// A valid planar domain drawn from a seed: a frame with straight or curved sides, divided into cells that each hold a
/// feature: holes, inner regions, slits, embedded points, fans and cusps of small angles down to 1 degree, touching and
/// nearly touching curves, lenses, details a thousandth of the domain.
[[nodiscard]] RandomDomain randomDomain(std::uint64_t seed);

}  // namespace mesher::test
