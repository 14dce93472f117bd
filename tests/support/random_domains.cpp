#include "support/random_domains.h"

#include "base/random.h"
#include "support/planar_builder.h"

#include <array>
#include <cmath>
#include <numbers>
#include <vector>

namespace mesher::test {
namespace {

constexpr double kPi = std::numbers::pi;

class Generator
{
public:
    explicit Generator(std::uint64_t seed) : random_(seed) {}

    RandomDomain run()
    {
        const int columns = 1 + static_cast<int>(random_.below(3));
        const int rows = 1 + static_cast<int>(random_.below(3));
        addFrame(columns, rows);
        for (int row = 0; row < rows; ++row) {
            for (int column = 0; column < columns; ++column) addFeature({column + 0.5, row + 0.5});
        }
        RandomDomain result;
        result.complex = builder_.build();
        result.description = std::move(description_);
        return result;
    }

private:
    static Vec2 ray(double angle) { return {std::cos(angle), std::sin(angle)}; }
    double between(double low, double high) { return random_.between(low, high); }
    double logarithmic(double low, double high)
    {
        return low * std::exp(random_.unit() * std::log(high / low));
    }
    Vec2 near(Vec2 centre, double distance)
    {
        return centre + between(0.0, distance) * ray(between(0.0, 2.0 * kPi));
    }
    void note(const char* name) { (description_ += description_.empty() ? "" : " ") += name; }

    /// Counter-clockwise; the sides stay within 0.2 of the rectangle, outside of which no cell reaches.
    void addFrame(int columns, int rows)
    {
        const double margin = 0.25;
        const Vec2 high{columns + margin, rows + margin};
        const std::array<Vec2, 4> corners{Vec2{-margin, -margin}, Vec2{high.x, -margin}, high,
                                          Vec2{-margin, high.y}};
        std::array<PccPointId, 4> points;
        for (std::size_t i = 0; i < 4; ++i) points[i] = builder_.point(corners[i]);
        for (std::size_t i = 0; i < 4; ++i) addSide(points[i], points[(i + 1) % 4]);
    }

    void addSide(PccPointId a, PccPointId b)
    {
        const Vec2 from = builder_.position(a);
        const Vec2 along = builder_.position(b) - from;
        const Vec2 outward = (1.0 / length(along)) * Vec2{along.y, -along.x};
        const auto at = [&](double fraction, double height) {
            return from + fraction * along + height * outward;
        };
        switch (random_.below(4)) {
            case 0: builder_.line(a, b); break;
            case 1: {
                const double height = between(0.02, 0.2);
                const double half = 0.5 * length(along);
                const double radius = (half * half + height * height) / (2.0 * height);
                const Vec2 centre = at(0.5, height - radius);
                builder_.arc(a, b, centre, 2.0 * std::asin(half / radius));
                break;
            }
            case 2: {
                const Vec2 controls[] = {at(0.3, between(-0.2, 0.2)), at(0.7, between(-0.2, 0.2))};
                builder_.bezier(a, controls, b);
                break;
            }
            default: {
                std::vector<Vec2> inner;
                const int count = 2 + static_cast<int>(random_.below(6));
                for (int i = 1; i <= count; ++i) inner.push_back(at(i / (count + 1.0), between(-0.08, 0.08)));
                builder_.spline(a, inner, b);
                break;
            }
        }
    }

    /// Everything of a feature lies within 0.47 of the cell's centre.
    void addFeature(Vec2 centre)
    {
        switch (random_.below(15)) {
            case 0: note("nothing"); break;
            case 1: addCircle(centre); break;
            case 2: addEllipse(centre); break;
            case 3: addBlob(centre); break;
            case 4: addSlit(centre); break;
            case 5: addPoints(centre); break;
            case 6: addFan(centre); break;
            case 7: addTouchingCircles(centre); break;
            case 8: addNearCircles(centre); break;
            case 9: addLens(centre); break;
            case 10: addDetail(centre); break;
            case 11: addPolyline(centre); break;
            case 12: addCusp(centre); break;
            case 13: addNestedRegions(centre); break;
            default: addWedgeHole(centre); break;
        }
    }

    /// Sides of a counter-clockwise curve: a hole, or a region of its own.
    PlanarBuilder::Sides island() { return random_.below(2) == 0 ? PlanarBuilder::Sides{0, 1} : ownRegion(); }
    PlanarBuilder::Sides ownRegion() { return {++regions_, 1}; }

    void addCircle(Vec2 centre)
    {
        note("circle");
        builder_.circle(near(centre, 0.05), logarithmic(0.005, 0.4), island(), false, between(0.0, 6.0));
    }

    void addEllipse(Vec2 centre)
    {
        note("ellipse");
        const double a = between(0.1, 0.45);
        builder_.ellipse(centre, a, a * logarithmic(0.01, 1.0), between(0.0, kPi), island(),
                         between(0.0, 6.0));
    }

    void addBlob(Vec2 centre)
    {
        note("blob");
        const int samples = 5 + static_cast<int>(random_.below(12));
        std::vector<Vec2> inner;
        const double turn = between(0.0, 2.0 * kPi);
        const PccPointId start = builder_.point(centre + between(0.2, 0.4) * ray(turn));
        double radius = length(builder_.position(start) - centre);
        for (int i = 1; i < samples; ++i) {
            radius = std::min(0.4, std::max(0.15, radius + between(-0.06, 0.06)));
            inner.push_back(centre + radius * ray(turn + 2.0 * kPi * i / samples));
        }
        builder_.spline(start, inner, start, island());
    }

    void addSlit(Vec2 centre)
    {
        note("slit");
        const double angle = between(0.0, kPi);
        const double half = logarithmic(0.01, 0.45);
        const PccPointId a = builder_.point(centre - half * ray(angle));
        const PccPointId b = builder_.point(centre + half * ray(angle));
        if (random_.below(2) == 0) {
            builder_.line(a, b, {1, 1});
            return;
        }
        const Vec2 aside = ray(angle + 0.5 * kPi);
        const Vec2 controls[] = {centre - 0.3 * half * ray(angle) + between(-0.1, 0.1) * aside,
                                 centre + 0.3 * half * ray(angle) + between(-0.1, 0.1) * aside};
        builder_.bezier(a, controls, b, {1, 1});
    }

    void addPoints(Vec2 centre)
    {
        note("points");
        const int count = 1 + static_cast<int>(random_.below(4));
        const double spread = logarithmic(0.001, 0.4);
        for (int i = 0; i < count; ++i) {
            builder_.embed(centre + spread * (0.3 + 0.7 * i / count) * ray(i * 2.0 + between(0.0, 1.0)), 1);
        }
    }

    void addFan(Vec2 centre)
    {
        note("fan");
        const PccPointId apex = builder_.point(centre);
        const int count = 2 + static_cast<int>(random_.below(6));
        double angle = between(0.0, 2.0 * kPi);
        double left = 300.0;
        for (int i = 0; i < count; ++i) {
            const double gap = logarithmic(1.0, 120.0);
            left -= gap;
            if (left < 0.0) break;
            angle += gap * kPi / 180.0;
            const double reach = between(0.05, 0.45);
            const PccPointId end = builder_.point(centre + reach * ray(angle));
            if (random_.below(3) != 0) {
                builder_.line(apex, end, {1, 1});
            } else {
                // Bends by much less than a third of the angle on either side.
                const Vec2 controls[] = {centre + 0.5 * reach * ray(angle),
                                         centre + 0.8 * reach * ray(angle + between(-0.004, 0.004))};
                builder_.bezier(apex, controls, end, {1, 1});
            }
        }
    }

    void addTouchingCircles(Vec2 centre)
    {
        note("touching");
        const double turn = between(0.0, 2.0 * kPi);
        const PccPointId p = builder_.point(centre);
        const double first = logarithmic(0.02, 0.2);
        const double second = logarithmic(0.02, 0.2);
        const bool isInside = random_.below(2) == 0 && std::abs(first - second) > 0.1 * first;
        const auto sides =
            random_.below(2) == 0 ? PlanarBuilder::Sides{0, 1} : PlanarBuilder::Sides{++regions_, 1};
        builder_.arc(p, p, centre + first * ray(turn), 2.0 * kPi,
                     isInside ? nestedOuter(first, second) : sides);
        builder_.arc(p, p, centre + (isInside ? second : -second) * ray(turn), 2.0 * kPi,
                     isInside ? nestedInner(first, second) : PlanarBuilder::Sides{++regions_, 1});
    }

    /// Of two circles touching from inside: between them lies a region of its own.
    PlanarBuilder::Sides nestedOuter(double first, double second)
    {
        between_ = ++regions_;
        return first > second ? PlanarBuilder::Sides{between_, 1} : PlanarBuilder::Sides{0, between_};
    }
    [[nodiscard]] PlanarBuilder::Sides nestedInner(double first, double second) const
    {
        return first > second ? PlanarBuilder::Sides{0, between_} : PlanarBuilder::Sides{between_, 1};
    }

    void addNearCircles(Vec2 centre)
    {
        note("near");
        const double turn = between(0.0, 2.0 * kPi);
        const double first = between(0.05, 0.2);
        const double second = between(0.05, 0.2);
        const double gap = logarithmic(1e-4, 1e-2);
        builder_.circle(centre + (first + gap) * ray(turn), first, island(), false, between(0.0, 6.0));
        builder_.circle(centre - second * ray(turn), second, island(), false, between(0.0, 6.0));
    }

    /// Two arcs between the same two points, with an angle of their own.
    void addLens(Vec2 centre)
    {
        note("lens");
        const double turn = between(0.0, 2.0 * kPi);
        const double half = logarithmic(0.02, 0.4);
        const PccPointId a = builder_.point(centre - half * ray(turn));
        const PccPointId b = builder_.point(centre + half * ray(turn));
        const double opening = logarithmic(1.0, 80.0) * kPi / 180.0;
        const auto sides = island();
        const auto centreFor = [&](double angle) {
            return centre + half / std::tan(angle) * ray(turn + 0.5 * kPi);
        };
        builder_.arc(a, b, centreFor(opening), 2.0 * opening, sides);
        if (random_.below(2) == 0) {
            builder_.line(b, a, sides);
        } else {
            builder_.arc(b, a, centreFor(-opening), 2.0 * opening, sides);
        }
    }

    void addDetail(Vec2 centre)
    {
        note("detail");
        const double size = logarithmic(3e-4, 5e-3);
        const Vec2 middle = near(centre, 0.4);
        const Vec2 corners[] = {middle, middle + size * Vec2{1.0, 0.1},
                                middle + size * Vec2{0.4, between(0.1, 1.0)}};
        builder_.polygon(corners, island());
    }

    void addPolyline(Vec2 centre)
    {
        note("polyline");
        const int count = 4 + static_cast<int>(random_.below(8));
        std::vector<Vec2> inner;
        const double start = between(0.0, 6.0);
        for (int i = 1; i < count; ++i)
            inner.push_back(centre + between(0.15, 0.45) * ray(start + 2.0 * kPi * i / count));
        const PccPointId p = builder_.point(centre + between(0.15, 0.45) * ray(start));
        builder_.polyline(p, inner, p, island());
    }

    /// Two splines that leave a point with a common tangent.
    void addCusp(Vec2 centre)
    {
        note("cusp");
        const double turn = between(0.0, 2.0 * kPi);
        const Vec2 ahead = ray(turn);
        const Vec2 aside = ray(turn + 0.5 * kPi);
        const PccPointId apex = builder_.point(centre - 0.4 * ahead);
        const double width = logarithmic(0.01, 0.3);
        const PccPointId upper = builder_.point(centre + 0.3 * ahead + width * aside);
        const PccPointId lower = builder_.point(centre + 0.3 * ahead - width * aside);
        const auto sides = island();
        const Vec2 first[] = {centre + 0.0 * ahead};
        builder_.bezier(apex, first, lower, sides);
        builder_.line(lower, upper, sides);
        builder_.bezier(upper, first, apex, sides);
    }

    void addNestedRegions(Vec2 centre)
    {
        note("nested");
        const std::uint32_t outer = ++regions_;
        const std::uint32_t inner = ++regions_;
        const double radius = between(0.2, 0.4);
        const double ratio = logarithmic(0.02, 0.97);
        builder_.circle(centre, radius, {outer, 1}, false, between(0.0, 6.0));
        builder_.circle(centre + 0.5 * (1.0 - ratio) * radius * ray(between(0.0, 6.0)), ratio * radius,
                        {inner, outer}, false, between(0.0, 6.0));
    }

    void addWedgeHole(Vec2 centre)
    {
        note("wedge");
        const double opening = logarithmic(1.0, 60.0) * kPi / 180.0;
        const double turn = between(0.0, 2.0 * kPi);
        const Vec2 corners[] = {centre, centre + between(0.1, 0.45) * ray(turn),
                                centre + between(0.1, 0.45) * ray(turn + opening)};
        builder_.polygon(corners, island());
    }

    Random random_;
    PlanarBuilder builder_;
    std::string description_;
    std::uint32_t regions_ = 1;
    std::uint32_t between_ = 0;
};

}  // namespace

RandomDomain randomDomain(std::uint64_t seed) { return Generator(seed).run(); }

}  // namespace mesher::test
