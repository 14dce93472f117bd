#include "pipeline/tet_clipping.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace mesher {

namespace {

double volumeOf(const TetPoints& t)
{
    return std::abs(dot(cross(t[1] - t[0], t[2] - t[0]), t[3] - t[0])) / 6.0;
}

/// Where the line between two points with values of different sign has the value zero.
Vec3 zeroBetween(const Vec3& p, double atP, const Vec3& q, double atQ)
{
    return p + (atP / (atP - atQ)) * (q - p);
}

/// The part of a tetrahedron on the positive side of a plane, in one or three tetrahedra; values are those of the plane at its
/// corners.
void cut(TetPoints t, std::array<double, 4> value, std::vector<TetPoints>& parts)
{
    // Corners on the positive side come first.
    std::array<std::size_t, 4> order = {0, 1, 2, 3};
    std::stable_sort(order.begin(), order.end(),
                     [&](std::size_t a, std::size_t b) { return (value[a] > 0.0) > (value[b] > 0.0); });
    const TetPoints p = {t[order[0]], t[order[1]], t[order[2]], t[order[3]]};
    const std::array<double, 4> v = {value[order[0]], value[order[1]], value[order[2]], value[order[3]]};
    const auto between = [&](std::size_t i, std::size_t k) { return zeroBetween(p[i], v[i], p[k], v[k]); };
    const auto addPrism = [&](const std::array<Vec3, 3>& a, const std::array<Vec3, 3>& b) {
        parts.push_back({a[0], a[1], a[2], b[0]});
        parts.push_back({a[1], a[2], b[0], b[1]});
        parts.push_back({a[2], b[0], b[1], b[2]});
    };
    switch (std::count_if(v.begin(), v.end(), [](double x) { return x > 0.0; })) {
        case 4: parts.push_back(p); break;
        case 3: addPrism({p[0], p[1], p[2]}, {between(0, 3), between(1, 3), between(2, 3)}); break;
        case 2: addPrism({p[0], between(0, 2), between(0, 3)}, {p[1], between(1, 2), between(1, 3)}); break;
        case 1: parts.push_back({p[0], between(0, 1), between(0, 2), between(0, 3)}); break;
        default: break;
    }
}

}  // namespace

double commonVolume(const TetPoints& a, const TetPoints& b)
{
    std::vector<TetPoints> parts = {a};
    std::vector<TetPoints> next;
    for (std::size_t side = 0; side < 4 && !parts.empty(); ++side) {
        const Vec3& origin = b[(side + 1) % 4];
        Vec3 normal = cross(b[(side + 2) % 4] - origin, b[(side + 3) % 4] - origin);
        if (dot(normal, b[side] - origin) < 0.0) normal = -1.0 * normal;
        next.clear();
        for (const TetPoints& part : parts) {
            std::array<double, 4> value{};
            for (std::size_t k = 0; k < 4; ++k) value[k] = dot(normal, part[k] - origin);
            cut(part, value, next);
        }
        parts.swap(next);
    }
    double volume = 0.0;
    for (const TetPoints& part : parts) volume += volumeOf(part);
    return volume;
}

}  // namespace mesher
