#pragma once

#include "mesh/classified_mesh.h"
#include "quality/tet_measures.h"
#include "quality/triangle_measures.h"

#include <array>
#include <cstddef>
#include <cstdint>

namespace mesher {

/// Least, largest and mean of what was added.
class RangeStatistics
{
public:
    void add(double value);

    [[nodiscard]] std::uint64_t count() const { return count_; }
    /// 0 of nothing, as are the others.
    [[nodiscard]] double least() const { return least_; }
    [[nodiscard]] double largest() const { return largest_; }
    [[nodiscard]] double mean() const { return count_ == 0 ? 0.0 : sum_ / static_cast<double>(count_); }

private:
    std::uint64_t count_ = 0;
    double least_ = 0.0;
    double largest_ = 0.0;
    double sum_ = 0.0;
};

/// Angles from 0 to 180 degrees in 18 bins of ten degrees; 180 itself is in the last.
using AngleHistogram = std::array<std::uint64_t, 18>;

void addAngle(AngleHistogram& histogram, double degrees);

struct TriangleQuality
{
    RangeStatistics angle;  ///< all three of all triangles, degrees
    AngleHistogram angleHistogram{};
    RangeStatistics radiusRatio;  ///< 2 r / R
    RangeStatistics area;
    double shortestEdge = 0.0;
    double longestEdge = 0.0;
    std::size_t worst = 0;  ///< index of the triangle that has the smallest angle
};

/// Least and largest of angles in degrees; 0 of none.
class AngleRange
{
public:
    void add(double degrees);

    [[nodiscard]] double least() const { return isEmpty_ ? 0.0 : least_; }
    [[nodiscard]] double largest() const { return largest_; }

private:
    bool isEmpty_ = true;
    double least_ = 0.0;
    double largest_ = 0.0;
};

struct TetQuality
{
    AngleRange dihedral;  ///< all six of all tets
    AngleHistogram dihedralHistogram{};
    RangeStatistics radiusRatio;  ///< 3 r / R
    RangeStatistics volumeRatio;  ///< 6 sqrt(2) V / L_rms^3
    RangeStatistics volume;       ///< signed
    std::size_t worst = 0;        ///< index of the tet that has the smallest dihedral angle
};

/// Of all triangles; of all tets.
[[nodiscard]] TriangleQuality triangleQualityOf(const ClassifiedMesh& mesh);
[[nodiscard]] TetQuality tetQualityOf(const ClassifiedMesh& mesh);

[[nodiscard]] TriangleCorners cornersOf(const ClassifiedMesh& mesh, const MeshElement<3>& triangle);
[[nodiscard]] TetCorners cornersOf(const ClassifiedMesh& mesh, const MeshElement<4>& tet);

}  // namespace mesher
