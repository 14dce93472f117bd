#include "support/surface_contract.h"

#include "base/random.h"

#include <algorithm>
#include <cmath>
#include <sstream>

namespace mesher::test {

namespace {

constexpr int kGrid = 50;

class SurfaceTrial
{
public:
    SurfaceTrial(const Surface& surface, Interval u, Interval v, double size)
        : surface_(surface), u_(u), v_(v), size_(size)
    {
        for (int i = 0; i <= kGrid; ++i) {
            for (int j = 0; j <= kGrid; ++j) {
                grid_.push_back(surface.position({u.at(static_cast<double>(i) / kGrid), v.at(static_cast<double>(j) / kGrid)}));
            }
        }
        for (const Vec3& p : grid_) reach_ = std::max(reach_, length(p - grid_.front()));
    }

    std::vector<std::string> run(int trials)
    {
        for (int i = 0; i < trials; ++i) {
            const Vec2 uv{u_.at(random_.unit()), v_.at(random_.unit())};
            tryDerivatives(uv);
            tryPeriods(uv);
            tryPointOnSurface(uv);
            tryPointBeside(uv);
        }
        return std::move(broken_);
    }

private:
    template <class... Words>
    void complain(const Words&... words)
    {
        std::ostringstream text;
        text.precision(6);
        (text << ... << words);
        broken_.push_back(text.str());
    }

    static bool isNear(std::span<const double> knots, double value, double margin)
    {
        return std::any_of(knots.begin(), knots.end(), [&](double k) { return std::abs(k - value) <= margin; });
    }

    void compareWithDifferences(Vec2 uv, bool isAlongU)
    {
        const SurfacePoint p = surface_.evaluate(uv);
        const double range = isAlongU ? u_.length() : v_.length();
        double best1 = INFINITY, best2 = INFINITY, bestMixed = INFINITY;
        for (double share = 1e-2; share > 1e-6; share *= 0.25) {
            const double h = share * range;
            const Vec2 step = isAlongU ? Vec2{h, 0.0} : Vec2{0.0, h};
            const Vec2 low = uv - step, high = uv + step;
            if (!u_.contains(low.x) || !u_.contains(high.x) || !v_.contains(low.y) || !v_.contains(high.y)) continue;
            if (isAlongU ? isNear(surface_.breaksU(), uv.x, h) : isNear(surface_.breaksV(), uv.y, h)) continue;
            const SurfacePoint before = surface_.evaluate(low), after = surface_.evaluate(high);
            const auto slope = [&](Vec3 a, Vec3 b) { return (0.5 / h) * (b - a); };
            best1 = std::min(best1, length(slope(before.position, after.position) - (isAlongU ? p.du : p.dv)));
            best2 = std::min(best2, isAlongU ? length(slope(before.du, after.du) - p.duu)
                                             : length(slope(before.dv, after.dv) - p.dvv));
            bestMixed = std::min(bestMixed, isAlongU ? length(slope(before.dv, after.dv) - p.duv)
                                                     : length(slope(before.du, after.du) - p.duv));
        }
        if (best1 == INFINITY) return;
        const double other = isAlongU ? v_.length() : u_.length();
        const double unit = reach_ / range;
        const char* name = isAlongU ? "u" : "v";
        if (best1 > 1e-4 * (unit + length(isAlongU ? p.du : p.dv))) complain("d", name, " is wrong by ", best1);
        if (best2 > 2e-3 * (unit / range + length(isAlongU ? p.duu : p.dvv))) {
            complain("d", name, name, " is wrong by ", best2);
        }
        if (bestMixed > 2e-3 * (unit / other + length(p.duv))) complain("duv along ", name, " is wrong by ", bestMixed);
    }

    void tryDerivatives(Vec2 uv)
    {
        if (length(surface_.evaluate(uv).position - surface_.position(uv)) > 1e-12 * size_) {
            complain("position is not evaluate at ", uv.x, " ", uv.y);
        }
        compareWithDifferences(uv, true);
        compareWithDifferences(uv, false);
        if (const auto frame = surface_.planeFrame()) {
            if (length(frame->toSpace(uv) - surface_.position(uv)) > 1e-12 * size_) complain("the plane's frame is not its own");
            if (length(cross(frame->xAxis, frame->yAxis) - frame->normal) > 1e-12) complain("the plane's frame is left-handed");
        }
    }

    void tryPeriods(Vec2 uv)
    {
        const Vec3 p = surface_.position(uv);
        const Vec2 byU{uv.x + surface_.periodU(), uv.y}, byV{uv.x, uv.y - surface_.periodV()};
        if (length(surface_.position(byU) - p) > 1e-11 * size_) complain("u is not periodic");
        if (length(surface_.position(byV) - p) > 1e-11 * size_) complain("v is not periodic");
    }

    void tryPointOnSurface(Vec2 uv)
    {
        const Vec3 p = surface_.position(uv);
        const SurfaceProjection free = surface_.project(p);
        if (free.distance > 1e-10 * size_) {
            complain("without a seed, the point at ", uv.x, " ", uv.y, " is projected ", free.distance, " away");
        }
        if (length(surface_.position(free.parameters) - p) > 2e-10 * size_) complain("the parameters found are others'");
        const Vec2 seed{u_.clamp(uv.x + 1e-3 * u_.length()), v_.clamp(uv.y - 1e-3 * v_.length())};
        const SurfaceProjection seeded = surface_.project(p, seed);
        if (seeded.distance > 1e-9 * size_) {
            complain("with a seed, the point at ", uv.x, " ", uv.y, " is projected ", seeded.distance, " away");
        }
        if (surface_.periodU() > 0.0 && std::abs(seeded.parameters.x - seed.x) > 0.51 * surface_.periodU()) {
            complain("u is not the image nearest to its seed");
        }
    }

    void tryPointBeside(Vec2 uv)
    {
        const double far = 0.3 * reach_ * random_.unit();
        const Vec3 point = surface_.position(uv) +
                           Vec3{random_.between(-far, far), random_.between(-far, far), random_.between(-far, far)};
        const SurfaceProjection found = surface_.project(point);
        if (length(surface_.position(found.parameters) - found.position) > 1e-12 * size_) complain("a projection is off the surface");
        if (std::abs(length(found.position - point) - found.distance) > 1e-12 * size_) complain("a distance is wrong");
        double brute = INFINITY;
        for (const Vec3& p : grid_) brute = std::min(brute, length(p - point));
        if (found.distance > brute + 1e-10 * size_) {
            complain("a projection is ", found.distance - brute, " farther than a sample of the surface");
        }
    }

    const Surface& surface_;
    Interval u_;
    Interval v_;
    double size_;
    double reach_ = 0.0;
    std::vector<Vec3> grid_;
    Random random_{30};
    std::vector<std::string> broken_;
};

}  // namespace

std::vector<std::string> findBrokenPromises(const Surface& surface, Interval u, Interval v, double size, int trials)
{
    return SurfaceTrial(surface, u, v, size).run(trials);
}

}  // namespace mesher::test
