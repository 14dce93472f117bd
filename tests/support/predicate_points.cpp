#include "support/predicate_points.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace mesher::test {

namespace {

int integerBetween(Random& random, int low, int high)
{
    return low + static_cast<int>(random.below(static_cast<std::uint32_t>(high - low + 1)));
}

/// Applies one function to each coordinate of a set.
template <class Function>
void forEachCoordinate(PointSets& sets, Function function)
{
    for (Vec3& p : sets.space) p = {function(p.x), function(p.y), function(p.z)};
    for (Vec2& p : sets.plane) p = {function(p.x), function(p.y)};
}

PointSets makeRandom(Random& random)
{
    PointSets sets{std::vector<Vec3>(5), std::vector<Vec2>(4)};
    const double size = random.below(2) == 0 ? 1.0 : std::ldexp(1.0, -integerBetween(random, 1, 30));
    const double centre = random.between(-1, 1);
    forEachCoordinate(sets, [&](double) { return centre + size * random.between(-1, 1); });
    return sets;
}

PointSets makeGrid(Random& random)
{
    PointSets sets{std::vector<Vec3>(5), std::vector<Vec2>(4)};
    constexpr std::array<double, 5> steps{1.0, 0.125, 0.1, 1.0 / 3.0, 0x1p-40};
    const double step = steps[random.below(steps.size())];
    const int side = integerBetween(random, 1, 4);
    const int origin = integerBetween(random, -1000, 1000) * (random.below(2) == 0 ? 1 : 0);
    forEachCoordinate(sets, [&](double) { return (origin + integerBetween(random, 0, side)) * step; });
    return sets;
}

/// The lattice points at a squared distance with many representations; sorted, hence the same everywhere.
std::vector<Vec3> latticeSphere(int radius, int squaredRadius)
{
    std::vector<Vec3> points;
    for (int x = -radius; x <= radius; ++x) {
        for (int y = -radius; y <= radius; ++y) {
            for (int z = -radius; z <= radius; ++z) {
                if (x * x + y * y + z * z == squaredRadius)
                    points.push_back({double(x), double(y), double(z)});
            }
        }
    }
    return points;
}
std::vector<Vec2> latticeCircle(int radius, int squaredRadius)
{
    std::vector<Vec2> points;
    for (int x = -radius; x <= radius; ++x) {
        for (int y = -radius; y <= radius; ++y) {
            if (x * x + y * y == squaredRadius) points.push_back({double(x), double(y)});
        }
    }
    return points;
}

PointSets makeCospherical(Random& random)
{
    static const std::vector<Vec3> smallSphere = latticeSphere(3, 9);
    static const std::vector<Vec3> largeSphere = latticeSphere(60, 3465);
    static const std::vector<Vec2> smallCircle = latticeCircle(5, 25);
    static const std::vector<Vec2> largeCircle = latticeCircle(75, 5525);
    const bool isSmall = random.below(2) == 0;
    const std::vector<Vec3>& sphere = isSmall ? smallSphere : largeSphere;
    const std::vector<Vec2>& circle = isSmall ? smallCircle : largeCircle;
    // A large translation makes the coordinates long and the differences stay short; a large factor makes
    // both long.
    const double factor = random.below(2) == 0 ? 1.0 : double(1 + random.below(1u << 30));
    const Vec3 centre{double(random.below(1u << 20)), double(random.below(1u << 30)),
                      random.below(2) * 0x1p45};
    PointSets sets;
    for (int i = 0; i < 5; ++i) {
        sets.space.push_back(centre +
                             factor * sphere[random.below(static_cast<std::uint32_t>(sphere.size()))]);
    }
    for (int i = 0; i < 4; ++i) {
        const Vec2 p = circle[random.below(static_cast<std::uint32_t>(circle.size()))];
        sets.plane.push_back(Vec2{centre.y, centre.z} + factor * p);
    }
    const int exponent = integerBetween(random, -60, 60);
    forEachCoordinate(sets, [&](double x) { return std::ldexp(x, exponent); });
    return sets;
}

PointSets makeCoplanar(Random& random)
{
    const auto component = [&](int size) { return double(integerBetween(random, -size, size)); };
    const int size = random.below(2) == 0 ? 9 : 1 << 20;
    const Vec3 origin{component(size), component(size), component(size)};
    const Vec3 u{component(size), component(size), component(size)};
    const Vec3 v{component(size), component(size), component(size)};
    PointSets sets;
    for (int i = 0; i < 5; ++i) sets.space.push_back(origin + component(size) * u + component(size) * v);
    for (int i = 0; i < 4; ++i)
        sets.plane.push_back(Vec2{origin.x, origin.y} + component(size) * Vec2{u.x, u.y});
    // A point off the plane now and then, so that the perturbation has something to decide.
    if (random.below(2) == 0)
        sets.space[random.below(5)] = {component(size), component(size), component(size)};
    if (random.below(2) == 0) sets.plane[random.below(4)] = {component(size), component(size)};
    const int exponent = integerBetween(random, -60, 60);
    forEachCoordinate(sets, [&](double x) { return std::ldexp(x, exponent); });
    return sets;
}

/// Points of a sphere through rounded coordinates, as a CAD kernel delivers them.
PointSets makeRoundedSphere(Random& random)
{
    const Vec3 centre{random.between(-9, 9), random.between(-9, 9), random.between(-9, 9)};
    const double radius = random.between(0.1, 5.0);
    PointSets sets;
    while (sets.space.size() < 5) {
        const Vec3 p{random.between(-1, 1), random.between(-1, 1), random.between(-1, 1)};
        if (length(p) > 0.1) sets.space.push_back(centre + (radius / length(p)) * p);
    }
    while (sets.plane.size() < 4) {
        const double angle = random.between(0.0, 6.28);
        sets.plane.push_back({centre.x + radius * std::cos(angle), centre.y + radius * std::sin(angle)});
    }
    return sets;
}

PointSets makeUlp(Random& random)
{
    PointSets sets;
    switch (random.below(4)) {
        case 0: sets = makeGrid(random); break;
        case 1: sets = makeCospherical(random); break;
        case 2: sets = makeCoplanar(random); break;
        default: sets = makeRoundedSphere(random); break;
    }
    constexpr double kInfinity = std::numeric_limits<double>::infinity();
    forEachCoordinate(sets, [&](double x) {
        const std::uint32_t what = random.below(6);
        if (what > 2 || x == 0.0) return x;
        const double target = random.below(2) == 0 ? kInfinity : -kInfinity;
        for (std::uint32_t i = 0; i <= what; ++i) x = std::nextafter(x, target);
        return x;
    });
    return sets;
}

/// The exact range, but for the bits that a coordinate of 53 bits needs below its exponent.
constexpr int kSmallestExponent = -147;
constexpr int kLargestExponent = 199;

double toExactRange(double x, int exponent)
{
    int own = 0;
    const double mantissa = std::frexp(x, &own);
    return std::ldexp(mantissa, std::clamp(own + exponent, kSmallestExponent, kLargestExponent + 1));
}

PointSets makeRange(Random& random)
{
    PointSets sets;
    switch (random.below(4)) {
        case 0: sets = makeRandom(random); break;
        case 1: sets = makeGrid(random); break;
        case 2: sets = makeCospherical(random); break;
        default: sets = makeCoplanar(random); break;
    }
    // All alike; each coordinate by itself; or all alike but for a few.
    const std::uint32_t mode = random.below(3);
    const int common = integerBetween(random, kSmallestExponent, kLargestExponent);
    forEachCoordinate(sets, [&](double x) {
        const bool isOwn = mode == 1 || (mode == 2 && random.below(4) == 0);
        const int exponent = isOwn ? integerBetween(random, kSmallestExponent, kLargestExponent) : common;
        return toExactRange(x, exponent);
    });
    return sets;
}

}  // namespace

std::optional<PointKind> pointKindOf(std::string_view name)
{
    const auto* const found = std::find(kPointKindNames.begin(), kPointKindNames.end(), name);
    if (found == kPointKindNames.end()) return std::nullopt;
    return static_cast<PointKind>(found - kPointKindNames.begin());
}

PointSets makePointSets(PointKind kind, std::uint64_t seed, std::uint64_t index)
{
    Random mixer(seed * kPointKindCount + static_cast<std::uint64_t>(kind));
    Random random(mixer() + index * 0xD1342543DE82EF95u);
    switch (kind) {
        case PointKind::Random: return makeRandom(random);
        case PointKind::Grid: return makeGrid(random);
        case PointKind::Cospherical: return makeCospherical(random);
        case PointKind::Coplanar: return makeCoplanar(random);
        case PointKind::Ulp: return makeUlp(random);
        case PointKind::Range: return makeRange(random);
    }
    return {};
}

}  // namespace mesher::test
