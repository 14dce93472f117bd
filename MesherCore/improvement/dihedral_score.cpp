#include "improvement/dihedral_score.h"

#include <algorithm>
#include <cmath>

namespace mesher {

namespace {

/// sin = 6 V l / (2 A_k 2 A_l) for the edge of length l between the faces opposite to corners k and l.
struct SquaredSines
{
    double sixVolumes = 0.0;
    std::array<Vec3, 4> face;  ///< twice the area times the outward normal, by the corner opposite to it
    std::array<double, 4> inverseArea;  ///< of the squares of their lengths
    std::array<double, 6> value;        ///< in the order of kTetEdgeCorners, weighted

    /// Leaves all but the volume unset if that is not positive.
    explicit SquaredSines(const TetCorners& p)
    {
        const Vec3 a = p[1] - p[0];
        const Vec3 b = p[2] - p[0];
        const Vec3 c = p[3] - p[0];
        face[3] = cross(b, a);
        sixVolumes = -dot(face[3], c);
        if (!(sixVolumes > 0.0)) return;
        face[1] = cross(c, b);
        face[2] = cross(a, c);
        face[0] = -1.0 * (face[1] + face[2] + face[3]);
        for (std::size_t i = 0; i < 4; ++i) inverseArea[i] = 1.0 / squaredLength(face[i]);
        const double square = sixVolumes * sixVolumes;
        for (std::size_t e = 0; e < 6; ++e) {
            const auto& [i, j] = kTetEdgeCorners[e];
            const auto& [k, l] = kTetEdgeCorners[5 - e];
            const double sine = square * squaredLength(p[j] - p[i]) * inverseArea[k] * inverseArea[l];
            value[e] = dot(face[k], face[l]) > 0.0 ? kObtuseWeight * kObtuseWeight * sine : sine;
        }
    }
};

/// Gradient of the logarithm of the squared area of a face by corner `m`, the other corners q and r of which follow.
Vec3 logAreaGradient(const Vec3& m, const Vec3& q, const Vec3& r, double inverseArea)
{
    const Vec3 normal = cross(q - m, r - m);
    return (2.0 * inverseArea) * cross(q - r, normal);
}

}  // namespace

double dihedralScore(const TetCorners& corners)
{
    const SquaredSines sines(corners);
    if (!(sines.sixVolumes > 0.0)) return 0.0;
    double least = sines.value[0];
    for (std::size_t e = 1; e < 6; ++e) least = std::min(least, sines.value[e]);
    return std::sqrt(least);
}

ScoreGradients scoreGradients(const TetCorners& p, std::size_t moving, double ceiling)
{
    ScoreGradients result;
    const SquaredSines sines(p);
    if (!(sines.sixVolumes > 0.0)) return result;
    const Vec3 volume = (-2.0 / sines.sixVolumes) * sines.face[moving];
    std::array<Vec3, 4> area;
    for (std::size_t k = 0; k < 4; ++k) {
        if (k == moving) continue;
        std::array<std::size_t, 2> others{};
        std::size_t count = 0;
        for (std::size_t i = 0; i < 4; ++i) {
            if (i != k && i != moving) others[count++] = i;
        }
        area[k] = logAreaGradient(p[moving], p[others[0]], p[others[1]], sines.inverseArea[k]);
    }
    for (std::size_t e = 0; e < 6; ++e) {
        if (sines.value[e] > ceiling * ceiling) continue;
        const auto& [i, j] = kTetEdgeCorners[e];
        const auto& [k, l] = kTetEdgeCorners[5 - e];
        Vec3 gradient = volume;
        if (i == moving || j == moving) {
            const Vec3 along = i == moving ? p[i] - p[j] : p[j] - p[i];
            gradient = gradient + (2.0 / squaredLength(along)) * along;
        }
        if (k != moving) gradient = gradient - area[k];
        if (l != moving) gradient = gradient - area[l];
        result.gradient[result.count++] = gradient;
    }
    return result;
}

}  // namespace mesher
