#pragma once

#include "base/box.h"
#include "sizing/sizing_field.h"
#include "triangulation2d/triangulate_planar.h"

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace mesher::test {

/// An example with the options it is meshed with, as it is shown in docs/examples.md.
struct PlanarFigure
{
    std::string name;    ///< of its files
    std::string title;   ///< one sentence
    std::string thesis;  ///< the figure of the thesis whose kind it is of
    PlanarCurveComplex complex;
    PlanarOptions options;
    std::shared_ptr<const SizingField> field;  ///< what options.refinement.sizing.field points to, or none
    std::optional<Box2> window;                ///< a close-up

    /// Curves and points are numbered, so that the mesh can be written with its entities.
    PlanarFigure(std::string figureName, std::string figureTitle, std::string thesisFigure,
                 PlanarCurveComplex domain);
};

/// All examples of chapter 2: annulus (Fig. 2.8), NACA 0012 (2.9), special insertions (2.10 to 2.12), three-element airfoil
/// (2.16), disjoint regions (2.17), spline cavity (2.18, 2.19) and the fan of small angles (2.20).
[[nodiscard]] std::vector<PlanarFigure> planarFigures();

}  // namespace mesher::test
