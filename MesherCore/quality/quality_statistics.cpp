#include "quality/quality_statistics.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace mesher {

namespace {

/// Tells the bins and the range of angles by their cosines: arc tangents of all would take longer than all else that is measured.
/// An angle itself is asked for where its cosine is near the limit of a bin or beyond those of the range so far.
class DihedralTally
{
public:
    DihedralTally()
    {
        for (std::size_t i = 0; i < kCells; ++i) {
            const int first = binOf(lowerEnd(i + 1) + kRounding);
            binOfCell_[i] = first == binOf(lowerEnd(i) - kRounding) ? first : kMixed;
        }
    }

    /// Of the tetrahedron with these face vectors; whether it has the smallest angle so far.
    bool add(const std::array<Vec3, 4>& face, TetQuality& quality)
    {
        std::array<double, 4> inverse{};
        for (std::size_t i = 0; i < 4; ++i) inverse[i] = 1.0 / length(face[i]);
        bool isSmallest = false;
        for (const auto& [k, l] : kTetEdgeCorners) {
            const double cosine = -dot(face[k], face[l]) * inverse[k] * inverse[l];
            const int bin = cosine > -1.0 && cosine < 1.0 ? binOfCell_[cellOf(cosine)] : kMixed;
            const bool isExtreme = cosine > largestCosine_ - kRounding || cosine < leastCosine_ + kRounding;
            if (bin != kMixed && !isExtreme) {
                ++quality.dihedralHistogram[static_cast<std::size_t>(bin)];
                continue;
            }
            const double angle = dihedralAngle(face[k], face[l]);
            addAngle(quality.dihedralHistogram, angle);
            isSmallest = isSmallest || angle < smallest_;
            smallest_ = std::min(smallest_, angle);
            quality.dihedral.add(angle);
            if (cosine > -2.0 && cosine < 2.0) {
                largestCosine_ = std::max(largestCosine_, cosine);
                leastCosine_ = std::min(leastCosine_, cosine);
            }
        }
        return isSmallest;
    }

private:
    static constexpr std::size_t kCells = 2048;
    static constexpr double kRounding = 1e-9;  ///< of a cosine, and far more
    static constexpr int kMixed = -1;

    static double lowerEnd(std::size_t cell) { return 2.0 * static_cast<double>(cell) / kCells - 1.0; }
    static std::size_t cellOf(double cosine)
    {
        return static_cast<std::size_t>((cosine + 1.0) * (0.5 * static_cast<double>(kCells)));
    }
    static int binOf(double cosine)
    {
        return static_cast<int>(std::acos(std::clamp(cosine, -1.0, 1.0)) * (18.0 / std::numbers::pi));
    }

    std::array<int, kCells> binOfCell_{};
    double largestCosine_ = -2.0;
    double leastCosine_ = 2.0;
    double smallest_ = 360.0;
};

}  // namespace

void AngleRange::add(double degrees)
{
    least_ = isEmpty_ ? degrees : std::min(least_, degrees);
    largest_ = isEmpty_ ? degrees : std::max(largest_, degrees);
    isEmpty_ = false;
}

void RangeStatistics::add(double value)
{
    least_ = count_ == 0 ? value : std::min(least_, value);
    largest_ = count_ == 0 ? value : std::max(largest_, value);
    sum_ += value;
    ++count_;
}

void addAngle(AngleHistogram& histogram, double degrees)
{
    const int bin = std::clamp(static_cast<int>(degrees / 10.0), 0, static_cast<int>(histogram.size()) - 1);
    ++histogram[static_cast<std::size_t>(bin)];
}

TriangleCorners cornersOf(const ClassifiedMesh& mesh, const MeshElement<3>& triangle)
{
    const auto& n = triangle.node;
    return {mesh.nodes[n[0]].position, mesh.nodes[n[1]].position, mesh.nodes[n[2]].position};
}

TetCorners cornersOf(const ClassifiedMesh& mesh, const MeshElement<4>& tet)
{
    const auto& n = tet.node;
    return {mesh.nodes[n[0]].position, mesh.nodes[n[1]].position, mesh.nodes[n[2]].position,
            mesh.nodes[n[3]].position};
}

TriangleQuality triangleQualityOf(const ClassifiedMesh& mesh)
{
    TriangleQuality quality;
    double smallestAngle = 360.0;
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
        const TriangleShape shape = shapeOf(cornersOf(mesh, mesh.triangles[i]));
        for (const double angle : shape.angle) {
            quality.angle.add(angle);
            addAngle(quality.angleHistogram, angle);
        }
        quality.radiusRatio.add(shape.radiusRatio);
        quality.area.add(shape.area);
        quality.shortestEdge =
            i == 0 ? shape.shortestEdge : std::min(quality.shortestEdge, shape.shortestEdge);
        quality.longestEdge = std::max(quality.longestEdge, shape.longestEdge);
        if (shape.minAngle < smallestAngle) {
            smallestAngle = shape.minAngle;
            quality.worst = i;
        }
    }
    return quality;
}

TetQuality tetQualityOf(const ClassifiedMesh& mesh)
{
    TetQuality quality;
    DihedralTally tally;
    for (std::size_t i = 0; i < mesh.tets.size(); ++i) {
        const TetCorners corners = cornersOf(mesh, mesh.tets[i]);
        if (tally.add(doubleFaceVectors(corners), quality)) quality.worst = i;
        quality.radiusRatio.add(score(TetMeasure::RadiusRatio, corners));
        quality.volumeRatio.add(score(TetMeasure::VolumeLength, corners));
        quality.volume.add(sixfoldVolume(corners) / 6.0);
    }
    return quality;
}

}  // namespace mesher
