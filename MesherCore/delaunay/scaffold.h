#pragma once

#include "base/vec.h"

#include <cstdint>
#include <span>
#include <vector>

namespace mesher {

/// How the octree that places scaffold points is refined.
struct ScaffoldOptions
{
    /// A cell with more points is split. Ratio to the local spacing h of a surface sample: a cell of edge s has about
    /// (s/h)² points, so 36 means cells of about 6 h. Range 4 to 10,000.
    std::uint32_t pointsPerCell = 36;
    /// Splits at most this deep; 21 levels fill a 64-bit key.
    std::uint32_t maxLevel = 20;
    /// How far a point may be off the centre of its cell along each axis, in edges of the cell. Exact centres would be
    /// cospherical by the dozen, and every one of them a case for exact arithmetic. Range 0 to 0.25.
    double jitter = 0.1;
};

/// Points to insert together with a sample of surfaces, so that its Delaunay tetrahedralization has few tetrahedra:
/// without them the vertices of a surface see far across the empty space on both sides, and cavities are large.
/// The points lie near the centres of the empty cells of a graded octree around the sample.
///
/// Guarantees   none nearer to the sample than 0.5 - jitter edges of its cell; cells next to the sample are those that hold at most
///              pointsPerCell points of it; neighbouring cells differ by a factor of two at most; all in the exact range;
///              deterministic
/// Requires     finite points
/// Cost         n log n; for random samples of a torus 5 to 12 % further points
std::vector<Vec3> scaffoldPoints(std::span<const Vec3> points, const ScaffoldOptions& options = {});

/// Whether the points fill surfaces or curves rather than a volume: by how the number of occupied cells grows from one
/// octree level to the next (4 for a surface, 8 for a volume; the line is drawn at 2^2.5).
bool isSurfaceLike(std::span<const Vec3> points);

}  // namespace mesher
