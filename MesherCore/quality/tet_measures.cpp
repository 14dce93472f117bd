#include "quality/tet_measures.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace mesher {

namespace {

constexpr double kDegrees = 180.0 / std::numbers::pi;
constexpr double kRegularSolidAngle = 0.55128559843253086;  // 3 arccos(1/3) - pi
constexpr double kSqrt2 = std::numbers::sqrt2;

struct EdgeLengths
{
    double shortest = 0.0;
    double longest = 0.0;
    double sumOfSquares = 0.0;
};

EdgeLengths edgeLengths(const TetCorners& p)
{
    double least = squaredLength(p[1] - p[0]);
    double most = least;
    double sum = 0.0;
    for (const auto& [i, j] : kTetEdgeCorners) {
        const double square = squaredLength(p[j] - p[i]);
        least = std::min(least, square);
        most = std::max(most, square);
        sum += square;
    }
    return {std::sqrt(least), std::sqrt(most), sum};
}

/// 1 / R times six volumes, times two: the length of the vector from corner 0 to the circumcentre without its denominator.
double circumradiusNumerator(const TetCorners& p)
{
    const Vec3 a = p[1] - p[0];
    const Vec3 b = p[2] - p[0];
    const Vec3 c = p[3] - p[0];
    return length(squaredLength(a) * cross(b, c) + squaredLength(b) * cross(c, a) +
                  squaredLength(c) * cross(a, b));
}

struct FaceAreas
{
    double smallest = 0.0;
    double largest = 0.0;
    double sum = 0.0;
};

FaceAreas faceAreas(const TetCorners& p)
{
    FaceAreas areas;
    bool isFirst = true;
    for (const Vec3& face : doubleFaceVectors(p)) {
        const double area = 0.5 * length(face);
        areas.smallest = isFirst ? area : std::min(areas.smallest, area);
        areas.largest = std::max(areas.largest, area);
        areas.sum += area;
        isFirst = false;
    }
    return areas;
}

double minimumDihedralSine(const TetCorners& p, double sixVolumes)
{
    const std::array<Vec3, 4> face = doubleFaceVectors(p);
    std::array<double, 4> doubleArea{};
    for (std::size_t i = 0; i < 4; ++i) doubleArea[i] = length(face[i]);
    double least = 1.0;
    for (std::size_t e = 0; e < 6; ++e) {
        const auto& [i, j] = kTetEdgeCorners[e];
        const auto& [k, l] = kTetEdgeCorners[5 - e];
        // The faces that meet in edge ij are opposite to k and l: sin = 3 V L / (2 A_k A_l).
        least = std::min(least, sixVolumes * length(p[j] - p[i]) / (doubleArea[k] * doubleArea[l]));
    }
    return least;
}

/// [vanoosterom1983]
double minimumSolidAngle(const TetCorners& p, double sixVolumes)
{
    double least = 4.0 * std::numbers::pi;
    for (std::size_t apex = 0; apex < 4; ++apex) {
        const Vec3 a = p[(apex + 1) % 4] - p[apex];
        const Vec3 b = p[(apex + 2) % 4] - p[apex];
        const Vec3 c = p[(apex + 3) % 4] - p[apex];
        const double la = length(a);
        const double lb = length(b);
        const double lc = length(c);
        const double denominator = la * lb * lc + dot(a, b) * lc + dot(a, c) * lb + dot(b, c) * la;
        least = std::min(least, 2.0 * std::atan2(sixVolumes, denominator));
    }
    return least;
}

}  // namespace

std::array<Vec3, 4> doubleFaceVectors(const TetCorners& p)
{
    const Vec3 a = p[1] - p[0];
    const Vec3 b = p[2] - p[0];
    const Vec3 c = p[3] - p[0];
    return {cross(p[2] - p[1], p[3] - p[1]), cross(c, b), cross(a, c), cross(b, a)};
}

double dihedralAngle(const Vec3& face, const Vec3& other)
{
    return std::atan2(length(cross(face, other)), -dot(face, other)) * kDegrees;
}

std::array<double, 6> dihedralAngles(const TetCorners& p)
{
    const std::array<Vec3, 4> face = doubleFaceVectors(p);
    std::array<double, 6> angles{};
    for (std::size_t e = 0; e < 6; ++e) {
        const auto& [k, l] = kTetEdgeCorners[5 - e];
        angles[e] = dihedralAngle(face[k], face[l]);
    }
    return angles;
}

std::optional<TetMeasure> tetMeasureOf(std::string_view key)
{
    for (const TetMeasureInfo& info : kTetMeasures) {
        if (info.key == key) return info.measure;
    }
    return std::nullopt;
}

double score(TetMeasure measure, const TetCorners& p)
{
    const double sixVolumes = sixfoldVolume(p);
    if (!(sixVolumes > 0.0)) return 0.0;
    const double volume = sixVolumes / 6.0;
    switch (measure) {
        case TetMeasure::ShortestEdgeToCircumradius:
            return std::sqrt(3.0 / 8.0) * edgeLengths(p).shortest * 2.0 * sixVolumes /
                   circumradiusNumerator(p);
        case TetMeasure::MinimumDihedralSine: return minimumDihedralSine(p, sixVolumes);
        case TetMeasure::VolumeLength:
            return 6.0 * kSqrt2 * volume / std::pow(edgeLengths(p).sumOfSquares / 6.0, 1.5);
        case TetMeasure::RadiusRatio:  // r = 3 V / sum A
            return 3.0 * (3.0 * volume / faceAreas(p).sum) * 2.0 * sixVolumes / circumradiusNumerator(p);
        case TetMeasure::MinimumSolidAngle: return minimumSolidAngle(p, sixVolumes) / kRegularSolidAngle;
        case TetMeasure::MeanRatio:
            return 12.0 * std::pow(3.0 * volume, 2.0 / 3.0) / edgeLengths(p).sumOfSquares;
        case TetMeasure::InradiusToLargestAltitude: {  // the largest altitude stands on the smallest face
            const FaceAreas areas = faceAreas(p);
            return 4.0 * areas.smallest / areas.sum;
        }
        case TetMeasure::AltitudeToLongestEdge:
            return std::sqrt(1.5) * 3.0 * volume / (faceAreas(p).largest * edgeLengths(p).longest);
    }
    return 0.0;
}

}  // namespace mesher
