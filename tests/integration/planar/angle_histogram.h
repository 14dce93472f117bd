#pragma once

#include "triangulation2d/planar_check.h"

#include <string>

namespace mesher::test {

/// A picture (SVG) of how often angles occur: bars of AngleStatistics::kBinDegrees, their heights in percent of all angles.
[[nodiscard]] std::string drawHistogram(const AngleStatistics& angles);

}  // namespace mesher::test
