#include "support/degenerate_points.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

namespace mesher::test {

namespace {

constexpr double kHuge = 0x1p100;
constexpr double kTiny = 0x1p-100;
constexpr std::size_t kClusterSize = 50;

template <class Point, class Make>
std::vector<Point> pointsFrom(std::size_t count, Make make)
{
    std::vector<Point> points;
    points.reserve(count);
    for (std::size_t i = 0; i < count; ++i) points.push_back(make(i));
    return points;
}

Vec2 uniform2d(Random& random)
{
    const double x = random.unit();
    return {x, random.unit()};
}

Vec3 uniform3d(Random& random)
{
    const double x = random.unit();
    const double y = random.unit();
    return {x, y, random.unit()};
}

/// Moves by up to `steps` representable numbers up or down.
double nudged(double value, std::uint32_t steps, Random& random)
{
    const std::uint32_t draw = random.below(2 * steps + 1);
    const double target = std::numeric_limits<double>::infinity() * (draw > steps ? 1.0 : -1.0);
    const std::uint32_t moves = draw > steps ? draw - steps : steps - draw;
    for (std::uint32_t i = 0; i < moves; ++i) value = std::nextafter(value, target);
    return value;
}

std::size_t sideOfSquare(std::size_t count)
{
    auto side = static_cast<std::size_t>(std::sqrt(static_cast<double>(count)));
    while (side * side < count) ++side;
    return side;
}

std::size_t sideOfCube(std::size_t count)
{
    auto side = static_cast<std::size_t>(std::cbrt(static_cast<double>(count)));
    while (side * side * side < count) ++side;
    return side;
}

/// Distinct multiples of 2^-10, in random order; exact under multiplication by small integers.
std::vector<double> dyadicParameters(std::size_t count, Random& random)
{
    std::vector<double> parameters =
        pointsFrom<double>(count, [](std::size_t i) { return static_cast<double>(i) * 0x1p-10; });
    shuffle(parameters, random);
    return parameters;
}

/// A multiple of 2^-20 in [0, 1).
double dyadic(Random& random) { return static_cast<double>(random.below(1u << 20)) * 0x1p-20; }

std::vector<Vec3> latticePointsOfSphere(std::int64_t squaredRadius)
{
    std::vector<Vec3> points;
    const auto radius = static_cast<std::int64_t>(std::sqrt(static_cast<double>(squaredRadius)));
    for (std::int64_t x = -radius; x <= radius; ++x) {
        for (std::int64_t y = -radius; y <= radius; ++y) {
            const std::int64_t rest = squaredRadius - x * x - y * y;
            if (rest < 0) continue;
            const auto z = static_cast<std::int64_t>(std::llround(std::sqrt(static_cast<double>(rest))));
            if (z * z != rest) continue;
            const auto px = static_cast<double>(x);
            const auto py = static_cast<double>(y);
            const auto pz = static_cast<double>(z);
            points.push_back({px, py, pz});
            if (z != 0) points.push_back({px, py, -pz});
        }
    }
    return points;
}

std::vector<Vec2> latticePointsOfCircle(std::int64_t squaredRadius)
{
    std::vector<Vec2> points;
    for (const Vec3& point : latticePointsOfSphere(squaredRadius)) {
        if (point.z == 0.0) points.push_back({point.x, point.y});
    }
    return points;
}

template <class Point, class MakeCentre, class MakeOffset>
std::vector<Point> clusters(std::size_t count, Random& random, MakeCentre makeCentre, MakeOffset makeOffset)
{
    Point centre{};
    double radius = 1.0;
    return pointsFrom<Point>(count, [&](std::size_t i) {
        if (i % kClusterSize == 0) {
            centre = makeCentre(random);
            radius = std::pow(10.0, random.between(-12.0, 0.0));
        }
        return centre + radius * makeOffset(random);
    });
}

template <class Point>
std::vector<Point> repeated(const std::vector<Point>& distinct, std::size_t count, Random& random)
{
    return pointsFrom<Point>(count, [&](std::size_t i) {
        return i < distinct.size() ? distinct[i]
                                   : distinct[random.below(static_cast<std::uint32_t>(distinct.size()))];
    });
}

template <class Point>
std::vector<Point> scaled(std::vector<Point> points, double factor)
{
    for (Point& point : points) point = factor * point;
    return points;
}

}  // namespace

std::vector<Vec2> uniformPoints2d(std::size_t count, std::uint64_t seed)
{
    Random random(seed);
    return pointsFrom<Vec2>(count, [&](std::size_t) { return uniform2d(random); });
}

std::vector<Vec2> gridPoints2d(std::size_t count)
{
    const std::size_t side = sideOfSquare(count);
    return pointsFrom<Vec2>(count, [side](std::size_t i) {
        return Vec2{static_cast<double>(i % side), static_cast<double>(i / side)};
    });
}

std::vector<Vec2> cocircularPoints2d(std::size_t count, std::uint64_t seed)
{
    // A product of four different primes 4k + 1 is a sum of two squares in 64 ways. Doubling is exact.
    constexpr std::int64_t squaredRadius = 5 * 13 * 17 * 29;
    Random random(seed);
    std::vector<Vec2> ring = latticePointsOfCircle(squaredRadius);
    shuffle(ring, random);
    return pointsFrom<Vec2>(count, [&ring](std::size_t i) {
        return std::ldexp(1.0, static_cast<int>(i / ring.size() % 100)) * ring[i % ring.size()];
    });
}

std::vector<Vec2> circlePoints2d(std::size_t count, std::uint64_t seed)
{
    Random random(seed);
    return pointsFrom<Vec2>(count, [&](std::size_t) {
        const double angle = 2.0 * std::numbers::pi * random.unit();
        return Vec2{std::cos(angle), std::sin(angle)};
    });
}

std::vector<Vec2> collinearPoints2d(std::size_t count, std::uint64_t seed)
{
    Random random(seed);
    const std::vector<double> parameters = dyadicParameters(count, random);
    return pointsFrom<Vec2>(count, [&](std::size_t i) {
        return Vec2{3.0 * parameters[i] + 1.0, 5.0 * parameters[i] - 2.0};
    });
}

std::vector<Vec2> nearlyCollinearPoints2d(std::size_t count, std::uint64_t seed)
{
    std::vector<Vec2> points = collinearPoints2d(count, seed);
    if (!points.empty()) points.back().y = std::nextafter(points.back().y, 10.0);
    return points;
}

std::vector<Vec2> duplicatedPoints2d(std::size_t count, std::uint64_t seed)
{
    Random random(seed);
    std::vector<Vec2> points = repeated(uniformPoints2d(count / 10 + 1, seed + 1), count, random);
    shuffle(points, random);
    return points;
}

std::vector<Vec2> ulpPoints2d(std::size_t count, std::uint64_t seed)
{
    Random random(seed);
    return pointsFrom<Vec2>(count, [&](std::size_t) {
        const double along = 1.0 + random.below(3);
        const double x = nudged(along, 2, random);
        return Vec2{x, nudged(along, 2, random)};
    });
}

std::vector<Vec2> hugePoints2d(std::size_t count, std::uint64_t seed)
{
    return scaled(uniformPoints2d(count, seed), kHuge);
}

std::vector<Vec2> tinyPoints2d(std::size_t count, std::uint64_t seed)
{
    return scaled(uniformPoints2d(count, seed), kTiny);
}

std::vector<Vec2> farOffsetGridPoints2d(std::size_t count)
{
    std::vector<Vec2> points = gridPoints2d(count);
    for (Vec2& point : points) point = Vec2{1.0, 1.0} + 0x1p-40 * point;
    return points;
}

std::vector<Vec2> equalPoints2d(std::size_t count) { return std::vector<Vec2>(count, Vec2{0.1, 0.2}); }

std::vector<Vec2> clusteredPoints2d(std::size_t count, std::uint64_t seed)
{
    Random random(seed);
    return clusters<Vec2>(count, random, uniform2d, uniform2d);
}

std::vector<Vec3> uniformPoints3d(std::size_t count, std::uint64_t seed)
{
    Random random(seed);
    return pointsFrom<Vec3>(count, [&](std::size_t) { return uniform3d(random); });
}

std::vector<Vec3> gridPoints3d(std::size_t count)
{
    const std::size_t side = sideOfCube(count);
    return pointsFrom<Vec3>(count, [side](std::size_t i) {
        return Vec3{static_cast<double>(i % side), static_cast<double>(i / side % side),
                    static_cast<double>(i / (side * side))};
    });
}

std::vector<Vec3> cosphericalPoints3d(std::size_t count, std::uint64_t seed)
{
    // Only numbers 4^a (8 b + 7) are no sum of three squares; these are 1 or 5 modulo 8.
    constexpr std::int64_t firstSquaredRadius = 40'001;
    constexpr std::int64_t step = 4;
    Random random(seed);
    std::vector<Vec3> points;
    for (std::int64_t squaredRadius = firstSquaredRadius; points.size() < count; squaredRadius += step) {
        std::vector<Vec3> sphere = latticePointsOfSphere(squaredRadius);
        shuffle(sphere, random);
        sphere.resize(std::min(sphere.size(), count - points.size()));
        points.insert(points.end(), sphere.begin(), sphere.end());
    }
    return points;
}

std::vector<Vec3> spherePoints3d(std::size_t count, std::uint64_t seed)
{
    Random random(seed);
    return pointsFrom<Vec3>(count, [&](std::size_t) {
        const double z = random.between(-1.0, 1.0);
        const double angle = 2.0 * std::numbers::pi * random.unit();
        const double radius = std::sqrt(1.0 - z * z);
        return Vec3{radius * std::cos(angle), radius * std::sin(angle), z};
    });
}

std::vector<Vec3> coplanarPoints3d(std::size_t count, std::uint64_t seed)
{
    Random random(seed);
    return pointsFrom<Vec3>(count, [&](std::size_t) {
        const double x = dyadic(random);
        const double y = dyadic(random);
        return Vec3{x, y, x + 2.0 * y - 1.0};
    });
}

std::vector<Vec3> coplanarGridPoints3d(std::size_t count)
{
    std::vector<Vec3> points;
    for (const Vec2& point : gridPoints2d(count)) points.push_back({point.x, 0.5, point.y});
    return points;
}

std::vector<Vec3> nearlyCoplanarPoints3d(std::size_t count, std::uint64_t seed)
{
    std::vector<Vec3> points = coplanarPoints3d(count, seed);
    if (!points.empty()) points.back().z = std::nextafter(points.back().z, 10.0);
    return points;
}

std::vector<Vec3> collinearPoints3d(std::size_t count, std::uint64_t seed)
{
    Random random(seed);
    const std::vector<double> parameters = dyadicParameters(count, random);
    return pointsFrom<Vec3>(count, [&](std::size_t i) {
        return Vec3{3.0 * parameters[i] + 1.0, 5.0 * parameters[i] - 2.0, 7.0 * parameters[i]};
    });
}

std::vector<Vec3> duplicatedPoints3d(std::size_t count, std::uint64_t seed)
{
    Random random(seed);
    std::vector<Vec3> points = repeated(uniformPoints3d(count / 10 + 1, seed + 1), count, random);
    shuffle(points, random);
    return points;
}

std::vector<Vec3> ulpPoints3d(std::size_t count, std::uint64_t seed)
{
    Random random(seed);
    return pointsFrom<Vec3>(count, [&](std::size_t) {
        const double x = nudged(1.0 + random.below(2), 2, random);
        const double y = nudged(1.0 + random.below(2), 2, random);
        return Vec3{x, y, nudged(1.0 + random.below(2), 2, random)};
    });
}

std::vector<Vec3> hugePoints3d(std::size_t count, std::uint64_t seed)
{
    return scaled(uniformPoints3d(count, seed), kHuge);
}

std::vector<Vec3> tinyPoints3d(std::size_t count, std::uint64_t seed)
{
    return scaled(uniformPoints3d(count, seed), kTiny);
}

std::vector<Vec3> farOffsetGridPoints3d(std::size_t count)
{
    std::vector<Vec3> points = gridPoints3d(count);
    for (Vec3& point : points) point = Vec3{1.0, 1.0, 1.0} + 0x1p-40 * point;
    return points;
}

std::vector<Vec3> equalPoints3d(std::size_t count) { return std::vector<Vec3>(count, Vec3{0.1, 0.2, 0.3}); }

std::vector<Vec3> torusPoints3d(std::size_t count, std::uint64_t seed)
{
    constexpr double majorRadius = 1.0;
    constexpr double minorRadius = 0.4;
    Random random(seed);
    return pointsFrom<Vec3>(count, [&](std::size_t) {
        double around = 0.0;
        double radius = 0.0;
        do {
            around = 2.0 * std::numbers::pi * random.unit();
            radius = majorRadius + minorRadius * std::cos(around);
        } while ((majorRadius + minorRadius) * random.unit() > radius);
        const double along = 2.0 * std::numbers::pi * random.unit();
        return Vec3{radius * std::cos(along), radius * std::sin(along), minorRadius * std::sin(around)};
    });
}

std::vector<Vec3> clusteredPoints3d(std::size_t count, std::uint64_t seed)
{
    Random random(seed);
    return clusters<Vec3>(count, random, uniform3d, uniform3d);
}

const std::vector<PointFamily<Vec2>>& pointFamilies2d()
{
    static const std::vector<PointFamily<Vec2>> families = {
        {"uniform", 2, uniformPoints2d},
        {"grid", 2, [](std::size_t count, std::uint64_t) { return gridPoints2d(count); }},
        {"cocircular", 2, cocircularPoints2d},
        {"circle", 2, circlePoints2d},
        {"collinear", 1, collinearPoints2d},
        {"nearly_collinear", 2, nearlyCollinearPoints2d},
        {"duplicated", 2, duplicatedPoints2d},
        {"ulp", 2, ulpPoints2d},
        {"huge", 2, hugePoints2d},
        {"tiny", 2, tinyPoints2d},
        {"far_offset_grid", 2, [](std::size_t count, std::uint64_t) { return farOffsetGridPoints2d(count); }},
        {"equal", 0, [](std::size_t count, std::uint64_t) { return equalPoints2d(count); }},
        {"clustered", 2, clusteredPoints2d},
    };
    return families;
}

const std::vector<PointFamily<Vec3>>& pointFamilies3d()
{
    static const std::vector<PointFamily<Vec3>> families = {
        {"uniform", 3, uniformPoints3d},
        {"grid", 3, [](std::size_t count, std::uint64_t) { return gridPoints3d(count); }},
        {"cospherical", 3, cosphericalPoints3d},
        {"sphere", 3, spherePoints3d},
        {"coplanar", 2, coplanarPoints3d},
        {"coplanar_grid", 2, [](std::size_t count, std::uint64_t) { return coplanarGridPoints3d(count); }},
        {"nearly_coplanar", 3, nearlyCoplanarPoints3d},
        {"collinear", 1, collinearPoints3d},
        {"duplicated", 3, duplicatedPoints3d},
        {"ulp", 3, ulpPoints3d},
        {"huge", 3, hugePoints3d},
        {"tiny", 3, tinyPoints3d},
        {"far_offset_grid", 3, [](std::size_t count, std::uint64_t) { return farOffsetGridPoints3d(count); }},
        {"equal", 0, [](std::size_t count, std::uint64_t) { return equalPoints3d(count); }},
        {"torus", 3, torusPoints3d},
        {"clustered", 3, clusteredPoints3d},
    };
    return families;
}

}  // namespace mesher::test
