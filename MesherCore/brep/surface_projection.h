#pragma once

#include "base/box.h"
#include "brep/surface.h"

#include <cstddef>
#include <memory>
#include <optional>
#include <vector>

namespace mesher {

/// The stationary point of the distance that Newton's method, damped where it would climb, reaches from the seed without
/// leaving `window`; periodic directions have no end.
///
/// Terminates   always: 60 steps at the most, each lowers the distance
/// Cost         one evaluation per step; 3 to 5 steps from a near seed
[[nodiscard]] SurfaceProjection projectFromSeed(const Surface& surface, const Vec3& point, Vec2 seed,
                                                Interval windowU, Interval windowV);

/// Points of a surface over a window of its parameters, dense enough to seed a search for the closest point. A line of it that is
/// one place of the surface, a pole, is one point of the search: all of its points are as near as one another, and from most of
/// them no step leads on.
class SurfaceGrid
{
public:
    /// Requires a finite window.
    SurfaceGrid(const Surface& surface, Interval windowU, Interval windowV);

    /// The closest of the points that Newton's method reaches from the grid's local minima of the distance.
    [[nodiscard]] SurfaceProjection project(const Surface& surface, const Vec3& point) const;

private:
    [[nodiscard]] std::size_t index(std::size_t i, std::size_t j) const { return i * v_.size() + j; }
    void findPoles();
    [[nodiscard]] bool isAtPole(std::size_t i, std::size_t j) const;
    [[nodiscard]] bool isLocalMinimum(const std::vector<double>& distances, std::size_t i,
                                      std::size_t j) const;
    /// The nearest point of each pole, and the local minima elsewhere.
    [[nodiscard]] std::vector<std::size_t> seedsOf(const std::vector<double>& distances) const;

    std::vector<double> u_;
    std::vector<double> v_;
    std::vector<Vec3> points_;     ///< by u, then v
    std::vector<char> isPoleOfU_;  ///< by line of u: whether all of its points are at one place
    std::vector<char> isPoleOfV_;
};

/// How a surface without a closed form finds closest points: from a seed, or from two grids, made at the first search without
/// one: of the face, which may be small on its surface, and of the whole surface, as far as it goes or a face's size beyond
/// the face. Copies share the grids; not for several threads.
class SurfaceSearch
{
public:
    /// Requires the finite bounds of the face.
    SurfaceSearch(Interval windowU, Interval windowV) : windowU_(windowU), windowV_(windowV) {}

    [[nodiscard]] SurfaceProjection project(const Surface& surface, const Vec3& point,
                                            std::optional<Vec2> seed) const;

private:
    struct Grids
    {
        SurfaceGrid face;
        SurfaceGrid whole;
    };

    Interval windowU_;
    Interval windowV_;
    mutable std::shared_ptr<const Grids> grids_;
};

}  // namespace mesher
