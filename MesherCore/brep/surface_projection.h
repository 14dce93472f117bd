#pragma once

#include "base/box.h"
#include "brep/surface.h"

#include <cstddef>
#include <vector>

namespace mesher {

/// The stationary point of the distance that Newton's method, damped where it would climb, reaches from the seed without
/// leaving `window`; periodic directions have no end.
///
/// Terminates   always: 60 steps at the most, each lowers the distance
/// Cost         one evaluation per step; 3 to 5 steps from a near seed
[[nodiscard]] SurfaceProjection projectFromSeed(const Surface& surface, const Vec3& point, Vec2 seed, Interval windowU,
                                                Interval windowV);

/// Points of a surface over a window of its parameters, dense enough to seed a search for the closest point.
class SurfaceGrid
{
public:
    /// Requires a finite window.
    SurfaceGrid(const Surface& surface, Interval windowU, Interval windowV);

    /// The closest of the points that Newton's method reaches from the grid's local minima of the distance.
    [[nodiscard]] SurfaceProjection project(const Surface& surface, const Vec3& point) const;

private:
    [[nodiscard]] bool isLocalMinimum(const std::vector<double>& distances, std::size_t i, std::size_t j) const;

    std::vector<double> u_;
    std::vector<double> v_;
    std::vector<Vec3> points_;  ///< by u, then v
};

}  // namespace mesher
