#include "brep/surface_projection.h"

#include "brep/analytic/periodic.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <span>

namespace mesher {

namespace {

constexpr double kRounding = 4.0 * std::numeric_limits<double>::epsilon();

/// Solves (a b; b c) move = -gradient; nothing if the matrix is not safely positive.
std::optional<Vec2> solve(double a, double b, double c, Vec2 gradient)
{
    const double determinant = a * c - b * b;
    if (!(a > 0.0) || !(determinant > 1e-8 * a * c)) return {};
    return Vec2{(b * gradient.y - c * gradient.x) / determinant,
                (b * gradient.x - a * gradient.y) / determinant};
}

/// Newton's step where the distance is convex, else that of Gauss and Newton, else down the gradient; a parameter at an end
/// of its window that would go on is held.
Vec2 descentStep(const SurfacePoint& p, Vec3 d, bool isHeldU, bool isHeldV)
{
    const double e = squaredLength(p.du), f = dot(p.du, p.dv), g = squaredLength(p.dv);
    const Vec2 gradient{dot(d, p.du), dot(d, p.dv)};
    const double a = e + dot(d, p.duu), b = f + dot(d, p.duv), c = g + dot(d, p.dvv);
    if (isHeldU && isHeldV) return {};
    const auto alone = [](double slope, double newton, double gauss) {
        const double curvature = newton > 0.1 * gauss ? newton : gauss;
        return curvature > 0.0 ? -slope / curvature : 0.0;
    };
    if (isHeldU) return {0.0, alone(gradient.y, c, g)};
    if (isHeldV) return {alone(gradient.x, a, e), 0.0};
    if (const std::optional<Vec2> newton = solve(a, b, c, gradient)) return *newton;
    if (const std::optional<Vec2> gauss = solve(e, f, g, gradient)) return *gauss;
    return {e > 0.0 ? -gradient.x / e : 0.0, g > 0.0 ? -gradient.y / g : 0.0};
}

bool isHeld(double value, double slope, Interval window, double period)
{
    if (period > 0.0) return false;
    return (value <= window.first && slope > 0.0) || (value >= window.last && slope < 0.0);
}

double bounded(double value, Interval window, double period)
{
    return period > 0.0 ? value : window.clamp(value);
}

/// Window cut at the knots, each piece in equal steps.
std::vector<double> gridLines(Interval window, std::span<const double> knots)
{
    constexpr std::size_t kFewest = 20, kMost = 400, kPerPiece = 5;
    std::vector<double> borders{window.first};
    for (const double knot : knots) {
        if (borders.back() < knot && knot < window.last) borders.push_back(knot);
    }
    borders.push_back(window.last);
    const std::size_t pieces = borders.size() - 1;
    const std::size_t perPiece =
        std::clamp((kFewest + pieces - 1) / pieces, pieces * kPerPiece > kMost ? 2 : kPerPiece, kFewest);
    std::vector<double> lines;
    for (std::size_t i = 0; i < pieces; ++i) {
        const Interval piece{borders[i], borders[i + 1]};
        for (std::size_t k = 0; k < perPiece; ++k) {
            lines.push_back(piece.at(static_cast<double>(k) / static_cast<double>(perPiece)));
        }
    }
    lines.push_back(window.last);
    return lines;
}

/// The range where it ends, the window where it does not.
Interval searchWindow(Interval range, Interval window, double period)
{
    if (period > 0.0) return {range.first, range.first + period};
    const double margin = window.length();
    return {std::isfinite(range.first) ? range.first : window.first - margin,
            std::isfinite(range.last) ? range.last : window.last + margin};
}

}  // namespace

SurfaceProjection projectFromSeed(const Surface& surface, const Vec3& point, Vec2 seed, Interval windowU,
                                  Interval windowV)
{
    constexpr int kMostSteps = 60;
    constexpr double kUnmeasurable = 1e-7;
    const double periodU = surface.periodU(), periodV = surface.periodV();
    Vec2 uv{bounded(seed.x, windowU, periodU), bounded(seed.y, windowV, periodV)};
    SurfacePoint p = surface.evaluate(uv);
    double distance = length(p.position - point);
    for (int step = 0; step < kMostSteps; ++step) {
        const Vec3 d = p.position - point;
        Vec2 move = descentStep(p, d, isHeld(uv.x, dot(d, p.du), windowU, periodU),
                                isHeld(uv.y, dot(d, p.dv), windowV, periodV));
        double motion = length(move.x * p.du + move.y * p.dv);
        // Below rounding of the point no step can be told from none.
        const double least =
            kRounding * (std::abs(p.position.x) + std::abs(p.position.y) + std::abs(p.position.z));
        if (motion <= least) break;
        const auto stepBy = [&](Vec2 by) {
            return Vec2{bounded(uv.x + by.x, windowU, periodU), bounded(uv.y + by.y, windowV, periodV)};
        };
        if (motion <= kUnmeasurable * distance) {
            // The distance changes by less than its own rounding: the last step of a quadratic convergence.
            uv = stepBy(move);
            p = surface.evaluate(uv);
            distance = length(p.position - point);
            break;
        }
        bool isLower = false;
        for (; motion > least && !isLower; motion *= 0.5) {
            const Vec2 next = stepBy(move);
            if (next == uv) break;
            const SurfacePoint q = surface.evaluate(next);
            const double reached = length(q.position - point);
            isLower = reached < distance;
            if (isLower) {
                uv = next;
                p = q;
                distance = reached;
            }
            move = 0.5 * move;
        }
        if (!isLower) break;
    }
    return {uv, p.position, distance};
}

SurfaceGrid::SurfaceGrid(const Surface& surface, Interval windowU, Interval windowV)
    : u_(gridLines(windowU, surface.breaksU())), v_(gridLines(windowV, surface.breaksV()))
{
    points_.reserve(u_.size() * v_.size());
    for (const double u : u_) {
        for (const double v : v_) points_.push_back(surface.position({u, v}));
    }
    findPoles();
}

void SurfaceGrid::findPoles()
{
    // Poles of files have an extent of their tolerance.
    constexpr double kShort = 1e-3;
    std::vector<double> alongV(u_.size(), 0.0), alongU(v_.size(), 0.0);
    for (std::size_t i = 0; i < u_.size(); ++i) {
        for (std::size_t j = 0; j < v_.size(); ++j) {
            if (j > 0) alongV[i] += length(points_[index(i, j)] - points_[index(i, j - 1)]);
            if (i > 0) alongU[j] += length(points_[index(i, j)] - points_[index(i - 1, j)]);
        }
    }
    const auto shortOnes = [](const std::vector<double>& lengths) {
        const double longest = *std::max_element(lengths.begin(), lengths.end());
        std::vector<char> are(lengths.size(), 0);
        for (std::size_t k = 0; k < lengths.size(); ++k) are[k] = lengths[k] < kShort * longest ? 1 : 0;
        return are;
    };
    isPoleOfU_ = shortOnes(alongV);
    isPoleOfV_ = shortOnes(alongU);
}

bool SurfaceGrid::isAtPole(std::size_t i, std::size_t j) const
{
    return isPoleOfU_[i] != 0 || isPoleOfV_[j] != 0;
}

bool SurfaceGrid::isLocalMinimum(const std::vector<double>& distances, std::size_t i, std::size_t j) const
{
    const double here = distances[index(i, j)];
    for (std::size_t a = i > 0 ? i - 1 : 0; a <= std::min(i + 1, u_.size() - 1); ++a) {
        for (std::size_t b = j > 0 ? j - 1 : 0; b <= std::min(j + 1, v_.size() - 1); ++b) {
            if (!isAtPole(a, b) && distances[index(a, b)] < here) return false;
        }
    }
    return true;
}

std::vector<std::size_t> SurfaceGrid::seedsOf(const std::vector<double>& distances) const
{
    std::vector<std::size_t> seeds;
    const auto isNearer = [&](std::size_t a, std::size_t b) { return distances[a] < distances[b]; };
    for (std::size_t i = 0; i < u_.size(); ++i) {
        if (isPoleOfU_[i] == 0) continue;
        std::size_t best = index(i, 0);
        for (std::size_t j = 1; j < v_.size(); ++j) best = std::min(best, index(i, j), isNearer);
        seeds.push_back(best);
    }
    for (std::size_t j = 0; j < v_.size(); ++j) {
        if (isPoleOfV_[j] == 0) continue;
        std::size_t best = index(0, j);
        for (std::size_t i = 1; i < u_.size(); ++i) best = std::min(best, index(i, j), isNearer);
        seeds.push_back(best);
    }
    for (std::size_t i = 0; i < u_.size(); ++i) {
        for (std::size_t j = 0; j < v_.size(); ++j) {
            if (!isAtPole(i, j) && isLocalMinimum(distances, i, j)) seeds.push_back(index(i, j));
        }
    }
    std::stable_sort(seeds.begin(), seeds.end(), isNearer);
    return seeds;
}

SurfaceProjection SurfaceGrid::project(const Surface& surface, const Vec3& point) const
{
    constexpr std::size_t kMostSeeds = 12;
    std::vector<double> distances(points_.size());
    for (std::size_t k = 0; k < points_.size(); ++k) distances[k] = length(points_[k] - point);
    std::vector<std::size_t> seeds = seedsOf(distances);
    seeds.resize(std::min(seeds.size(), kMostSeeds));
    SurfaceProjection best;
    best.distance = std::numeric_limits<double>::infinity();
    for (const std::size_t k : seeds) {
        const Vec2 seed{u_[k / v_.size()], v_[k % v_.size()]};
        const SurfaceProjection found =
            projectFromSeed(surface, point, seed, {u_.front(), u_.back()}, {v_.front(), v_.back()});
        if (found.distance < best.distance) best = found;
    }
    return best;
}

SurfaceProjection SurfaceSearch::project(const Surface& surface, const Vec3& point,
                                         std::optional<Vec2> seed) const
{
    if (seed) return projectFromSeed(surface, point, *seed, surface.rangeU(), surface.rangeV());
    const double periodU = surface.periodU(), periodV = surface.periodV();
    if (!grids_) {
        grids_ = std::make_shared<const Grids>(
            Grids{SurfaceGrid(surface, windowU_, windowV_),
                  SurfaceGrid(surface, searchWindow(surface.rangeU(), windowU_, periodU),
                              searchWindow(surface.rangeV(), windowV_, periodV))});
    }
    SurfaceProjection found = grids_->face.project(surface, point);
    const SurfaceProjection elsewhere = grids_->whole.project(surface, point);
    if (elsewhere.distance < found.distance) found = elsewhere;
    if (periodU > 0.0) found.parameters.x = wrapInto(found.parameters.x, surface.rangeU().first, periodU);
    if (periodV > 0.0) found.parameters.y = wrapInto(found.parameters.y, surface.rangeV().first, periodV);
    return found;
}

}  // namespace mesher
