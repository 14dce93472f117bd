#pragma once

#include "base/vec.h"

#include <array>
#include <cstdint>
#include <optional>
#include <string_view>

namespace mesher {

using TetCorners = std::array<Vec3, 4>;

/// The corners of edge i of a tetrahedron; edge 5 - i is the opposite one.
inline constexpr std::array<std::array<std::uint8_t, 2>, 6> kTetEdgeCorners = {
    {{0, 1}, {0, 2}, {0, 3}, {1, 2}, {1, 3}, {2, 3}}};

/// Six times the volume; positive where corner 3 sees the corners 0, 1, 2 counterclockwise.
[[nodiscard]] constexpr double sixfoldVolume(const TetCorners& corners)
{
    return dot(cross(corners[1] - corners[0], corners[2] - corners[0]), corners[3] - corners[0]);
}

/// The six dihedral angles in degrees, in the order of kTetEdgeCorners; 0 or 180 at the edges of a flat tetrahedron.
[[nodiscard]] std::array<double, 6> dihedralAngles(const TetCorners& corners);

/// Twice the area times the outward unit normal of the face opposite to each corner, of a positive tetrahedron.
[[nodiscard]] std::array<Vec3, 4> doubleFaceVectors(const TetCorners& corners);

/// The angle in degrees between two faces given by such vectors.
[[nodiscard]] double dihedralAngle(const Vec3& face, const Vec3& other);

/// The measures of the thesis: 1 (q2: 0.943) for the regular tetrahedron, towards 0 for those that they find bad, exactly 0 for
/// flat and inverted ones.
/// Reference    [gosselin] section 4.5.1, appendix B.1. Its q8 is printed upside down and the index ranges of q5 and q6 are
///              garbled; q2 of the regular tetrahedron is 2 sqrt(2) / 3, not 1.
enum class TetMeasure : std::uint8_t
{
    ShortestEdgeToCircumradius,  ///< q1 = sqrt(3/8) L_min / R; does not see slivers
    MinimumDihedralSine,         ///< q2 = min sin(phi); does not see spires
    VolumeLength,                ///< q3 = 6 sqrt(2) V / L_rms^3
    RadiusRatio,                 ///< q4 = 3 r / R
    MinimumSolidAngle,           ///< q5 = min(Omega) / (3 arccos(1/3) - pi)
    MeanRatio,                   ///< q6 = 12 (3 V)^(2/3) / sum L^2
    InradiusToLargestAltitude,   ///< q7 = 4 r / h_max; sees few kinds of bad tetrahedra
    AltitudeToLongestEdge        ///< q8 = sqrt(3/2) h_min / L_max
};

struct TetMeasureInfo
{
    TetMeasure measure;
    std::string_view key;      ///< "q1" … "q8"
    std::string_view meaning;  ///< a clause for people
    double regularScore;       ///< of the regular tetrahedron, the best there is
    double threshold;          ///< [gosselin] table 4.2: a tetrahedron that scores less is refined
    /// Degrees, beyond which it is refined whatever it scores; 180 is off. The thesis has no such bound: its q2 alone allows 161.
    /// q1 and q7 do not see slivers and q5 sees large angles late: held to it they would take up to twice as many vertices and more.
    double largestDihedral;
    /// q3 below which it is refined whatever it scores; 0 is off. q2 calls spires good, which three vertices near to each other make
    /// with a fourth far off: a ball by curvature alone was a star of them around its centre.
    double leastVolumeLength = 0.0;
    /// How far below the length scale quality may refine at first: a bad tetrahedron waits if its radius is less than the scale
    /// there over about twice this.
    double lambda = 5.0;
};

inline constexpr std::array<TetMeasureInfo, 8> kTetMeasures = {{
    {TetMeasure::ShortestEdgeToCircumradius, "q1", "shortest edge to circumradius", 1.0, 0.52, 180.0},
    {TetMeasure::MinimumDihedralSine, "q2", "smallest sine of a dihedral angle", 0.94280904158206337, 0.32,
     155.0, 0.25},
    {TetMeasure::VolumeLength, "q3", "volume to edge lengths", 1.0, 0.32, 155.0},
    {TetMeasure::RadiusRatio, "q4", "inradius to circumradius", 1.0, 0.36, 155.0},
    {TetMeasure::MinimumSolidAngle, "q5", "smallest solid angle", 1.0, 0.21, 180.0},
    {TetMeasure::MeanRatio, "q6", "mean ratio", 1.0, 0.47, 155.0},
    {TetMeasure::InradiusToLargestAltitude, "q7", "inradius to largest altitude", 1.0, 0.59, 180.0},
    {TetMeasure::AltitudeToLongestEdge, "q8", "smallest altitude to longest edge", 1.0, 0.24, 155.0},
}};

[[nodiscard]] constexpr const TetMeasureInfo& infoOf(TetMeasure measure)
{
    return kTetMeasures[static_cast<std::size_t>(measure)];
}
/// The measure of that key, "q1" … "q8".
[[nodiscard]] std::optional<TetMeasure> tetMeasureOf(std::string_view key);

[[nodiscard]] double score(TetMeasure measure, const TetCorners& corners);

}  // namespace mesher
