#pragma once

#include "brep/planar_curve_complex.h"

#include <string>
#include <vector>

namespace mesher::test {

/// Domains of the kind of the thesis' figures, made anew.
PlanarCurveComplex annulus();         ///< Fig. 2.8: radii 1 and 2
PlanarCurveComplex nacaInFarField();  ///< Fig. 2.9: NACA 0012, chord 1, in a circle of radius 20
PlanarCurveComplex
threeElementAirfoil();  ///< Fig. 2.16: slat, main element and flap, each one or two splines
PlanarCurveComplex manyDisjointRegions();  ///< Fig. 2.17: regions side by side that do not see each other
PlanarCurveComplex splineCavity();         ///< Figs. 2.18, 2.19: one region, several splines, small angles
PlanarCurveComplex smallAngleFan();  ///< Fig. 2.20: a fan of lines and curves with angles down to 0.5 degrees
PlanarCurveComplex
overlappingHulls();  ///< Fig. 2.10: two arcs close to each other, one inside the other's hull
PlanarCurveComplex
bulgeOutsideOfCircles();  ///< Fig. 2.11: a bulge whose split point lies outside of all circles
PlanarCurveComplex thinHoleBetweenArcs();  ///< Fig. 2.12: two arcs with an unmeshed region between them
/// A square with corners (0, 0) and (1, 1).
PlanarCurveComplex unitSquare();

struct PlanarExample
{
    std::string name;
    PlanarCurveComplex complex;
};
[[nodiscard]] std::vector<PlanarExample> allPlanarExamples();

}  // namespace mesher::test
