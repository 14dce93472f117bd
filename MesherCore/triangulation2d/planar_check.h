#pragma once

#include "triangulation2d/triangulate_planar.h"

#include <array>
#include <cstddef>
#include <string>
#include <vector>

namespace mesher {

/// Angles of all meshed triangles, degrees.
struct AngleStatistics
{
    static constexpr double kBinDegrees = 10.0;

    double smallest = 180.0;
    double largest = 0.0;
    std::array<std::size_t, 18> histogram{};
    /// Without the triangles that span a small angle of the input.
    double smallestElsewhere = 180.0;
    double largestElsewhere = 0.0;
};

/// What one region's triangles are, and what its curves say they should be.
struct RegionStatistics
{
    std::size_t triangles = 0;
    double area = 0.0;         ///< of the triangles, model units squared
    double curveArea = 0.0;    ///< enclosed by the curves, by Green's theorem
    double segmentArea = 0.0;  ///< between the curves and their boundary edges, by the same integral
    int eulerCharacteristic = 0;
};

struct PlanarCheck
{
    std::vector<std::string> violations;
    AngleStatistics angles;
    std::vector<RegionStatistics> regions;  ///< of region i + 1
    double largestCurveDistance = 0.0;      ///< of a boundary vertex from its curve, model units

    [[nodiscard]] bool isClean() const { return violations.empty(); }
};

/// Checks a result against its input, sharing nothing with the steps but the mesh.
/// Verifies     the exact constrained Delaunay property; that all subcurves are constrained edges, chains run along their
///              curve without gaps with ascending parameters, vertices lie on their curves; regions on both sides of each
///              curve; areas; with `isRefined` that angles keep the bounds but in triangles that span small input angles
/// Cost         linear, with a projection for each boundary vertex
[[nodiscard]] PlanarCheck checkPlanar(const PlanarCurveComplex& complex, const PlanarResult& result,
                                      const PlanarOptions& options);

}  // namespace mesher
