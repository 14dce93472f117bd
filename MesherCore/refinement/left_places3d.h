#pragma once

#include "delaunay/constrained_tetrahedralization.h"
#include "refinement/delaunay_refinement3d.h"

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace mesher {

/// Tetrahedra that were left too large or bad for one reason at one place of the model.
struct LeftPlace3d
{
    LeftReason3d reason = LeftReason3d::Unfinished;
    /// At a small angle the edge and its two faces, or the vertex and its two edges; of a wall its two faces; else what is in
    /// the way or beside them, or the solid. Those that are not known stand at the end, invalid.
    std::array<EntityRef, 3> entity;
    double degrees = 0.0;  ///< of the small angle
    std::uint64_t count = 0;
    double leastDihedral = 180.0;  ///< degrees
    double largestDihedral = 0.0;
    Vec3 worst;  ///< centroid of the one with the least dihedral angle, model units
};

/// By reason and place, those with the most tetrahedra first.
[[nodiscard]] std::vector<LeftPlace3d> groupLeftTets(const ConstrainedTetrahedralization& tetrahedralization,
                                                     std::span<const LeftTet3d> left);

}  // namespace mesher
