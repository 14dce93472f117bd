#pragma once

#include "support/planar_figures.h"
#include "triangulation2d/planar_check.h"

#include <string>
#include <vector>

namespace mesher::test {

struct MeshedFigure
{
    PlanarFigure figure;
    PlanarResult result;
    PlanarCheck check;
};

/// The text of docs/examples.md.
[[nodiscard]] std::string figuresPage(const std::vector<MeshedFigure>& figures);

}  // namespace mesher::test
