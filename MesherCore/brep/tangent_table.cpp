#include "brep/tangent_table.h"

#include "brep/root_finding.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>

namespace mesher {

namespace {

constexpr std::size_t kCount = ChebyshevSeries::kSampleCount;
/// Per cell; radians for the variation, a share of the curve's size for the length.
constexpr double kTolerance = 1e-12;
/// Derivatives are differences of places: what these have of rounding, in units of their last digit, no halving takes away.
constexpr double kRounding = 64.0 * std::numeric_limits<double>::epsilon();
/// Narrower cells, as a share of the whole part, are not halved.
constexpr double kNarrowest = 1e-10;
/// Smaller jumps of the tangent, in radians, are rounding.
constexpr double kSmallestJump = 1e-6;
/// How far from a border, as a share of the part, its one-sided tangents are taken; small against any feature, large
/// against the tolerance within which kernels snap a parameter to a knot.
constexpr double kSideStep = 1e-7;

struct Samples
{
    std::array<double, kCount> parameters;
    std::array<double, kCount> turning;  ///< |C' x C''| / |C'|^2
    std::array<double, kCount> speed;
    std::array<Vec3, kCount> tangent;
    std::array<Vec3, kCount> binormal;
};

Vec3 binormalOf(const CurvePoint& p) { return cross(p.d1, p.d2); }

Samples sample(const Curve& curve, Interval range)
{
    Samples samples;
    for (std::size_t k = 0; k < kCount; ++k) {
        const double t = range.at(0.5 * (1.0 + ChebyshevSeries::sampleAbscissae()[k]));
        const CurvePoint p = curve.evaluate(t);
        const double speed2 = squaredLength(p.d1);
        samples.parameters[k] = t;
        samples.tangent[k] = p.d1;
        samples.binormal[k] = binormalOf(p);
        samples.speed[k] = std::sqrt(speed2);
        samples.turning[k] = speed2 > 0.0 ? length(samples.binormal[k]) / speed2 : 0.0;
    }
    return samples;
}

double angleBetween(Vec3 a, Vec3 b) { return std::atan2(length(cross(a, b)), dot(a, b)); }

Vec3 unit(Vec3 a)
{
    const double size = length(a);
    return size > 0.0 ? (1.0 / size) * a : a;
}

/// Direction of the tangent on one side of t, extrapolated from two points at distances |step| and 2 |step|.
Vec3 tangentBeside(const Curve& curve, double t, double step)
{
    const Vec3 near = unit(curve.evaluate(t + step).d1);
    const Vec3 far = unit(curve.evaluate(t + 2.0 * step).d1);
    return 2.0 * near - far;
}

class TableBuilder
{
public:
    TableBuilder(const Curve& curve, Interval part)
        : curve_(curve), whole_(part), size_(sizeOf(curve, part)), rounding_(kRounding * reachOf(curve, part))
    {
    }

    TangentTable build()
    {
        std::vector<double> borders{whole_.first};
        for (const double t : curve_.knots()) {
            if (borders.back() < t && t < whole_.last) borders.push_back(t);
        }
        borders.push_back(whole_.last);
        for (std::size_t i = 0; i + 1 < borders.size(); ++i) {
            // Two cells at the least: a feature that hides between the samples of one shows in the other.
            const double middle = 0.5 * (borders[i] + borders[i + 1]);
            const double pieceSize = sizeOf(curve_, {borders[i], borders[i + 1]});
            const double tolerance = std::max(kTolerance, pieceSize > 0.0 ? rounding_ / pieceSize : 0.0);
            addCells({borders[i], middle}, tolerance);
            addCells({middle, borders[i + 1]}, tolerance);
        }
        sumUp();
        return std::move(table_);
    }

private:
    static double sizeOf(const Curve& curve, Interval part)
    {
        constexpr int kChords = 8;
        double sum = 0.0;
        for (int i = 0; i < kChords; ++i) {
            sum += length(curve.position(part.at((i + 1.0) / kChords)) -
                          curve.position(part.at((i + 0.0) / kChords)));
        }
        return sum;
    }

    /// How far from the origin the curve gets.
    static double reachOf(const Curve& curve, Interval part)
    {
        double reach = 0.0;
        for (const double share : {0.0, 0.5, 1.0})
            reach = std::max(reach, length(curve.position(part.at(share))));
        return reach;
    }

    void addCells(Interval range, double tolerance)
    {
        std::vector<Interval> open{range};
        while (!open.empty()) {
            const Interval cell = open.back();
            open.pop_back();
            const Samples samples = sample(curve_, cell);
            const ChebyshevSeries turning = ChebyshevSeries::fitted(samples.turning);
            const ChebyshevSeries speed = ChebyshevSeries::fitted(samples.speed);
            const double half = 0.5 * cell.length();
            const bool isResolved = turning.tail() * half <= tolerance &&
                                    speed.tail() * half <= std::max(kTolerance * size_, rounding_) &&
                                    !hidesJump(samples, turning, half);
            const bool isNarrow = cell.length() <= kNarrowest * whole_.length();
            if (isResolved || isNarrow) {
                addCell(cell, isResolved, turning, speed);
                continue;
            }
            const double cut = findInflexion(samples, cell).value_or(cell.at(0.5));
            open.push_back({cut, cell.last});
            open.push_back({cell.first, cut});
        }
    }

    /// A cusp turns the tangent between two samples without a trace in the curvature beside it.
    static bool hidesJump(const Samples& samples, const ChebyshevSeries& turning, double half)
    {
        double seen = 0.0;
        for (std::size_t k = 0; k + 1 < kCount; ++k)
            seen += angleBetween(samples.tangent[k], samples.tangent[k + 1]);
        return seen > half * turning.primitive().at(1.0) + kSmallestJump;
    }

    void addCell(Interval range, bool isResolved, const ChebyshevSeries& turning,
                 const ChebyshevSeries& speed)
    {
        TangentCell cell;
        cell.range = range;
        if (isResolved) cell.variation = turning.primitive();
        cell.length = speed.primitive();
        const double half = 0.5 * range.length();
        for (double& c : cell.variation.coefficients) c *= half;
        for (double& c : cell.length.coefficients) c *= half;
        table_.cells.push_back(cell);
        isUnresolved_.push_back(!isResolved);
    }

    /// Where the binormal of a plane curve turns over, which makes a kink in its length.
    std::optional<double> findInflexion(const Samples& samples, Interval cell) const
    {
        for (std::size_t k = 0; k + 1 < kCount; ++k) {
            const Vec3 reference = samples.binormal[k];
            const double other = dot(samples.binormal[k + 1], reference);
            const bool isOpposed =
                other < -0.9 * length(reference) * length(samples.binormal[k + 1]) &&
                std::min(samples.turning[k], samples.turning[k + 1]) * cell.length() > kTolerance;
            if (!isOpposed) continue;
            const auto alongReference = [&](double t) {
                return dot(binormalOf(curve_.evaluate(t)), reference);
            };
            const double root = findRoot(alongReference, samples.parameters[k + 1], samples.parameters[k],
                                         other, squaredLength(reference), 0.0);
            const double margin = 1e-6 * cell.length();
            if (cell.first + margin < root && root < cell.last - margin) return root;
        }
        return {};
    }

    /// The jump of the tangent's direction in front of cell i. A run of unresolved cells counts as a point: its jump is
    /// in front of its first cell.
    double jumpBefore(std::size_t i) const
    {
        if (i == 0 || isUnresolved_[i - 1]) return 0.0;
        std::size_t next = i;
        while (next < table_.cells.size() && isUnresolved_[next]) ++next;
        if (next == table_.cells.size()) return 0.0;
        const Interval before = table_.cells[i - 1].range;
        const Interval after = table_.cells[next].range;
        const double step =
            std::min({kSideStep * whole_.length(), 0.25 * before.length(), 0.25 * after.length()});
        const double angle =
            angleBetween(tangentBeside(curve_, before.last, -step), tangentBeside(curve_, after.first, step));
        return angle > kSmallestJump ? angle : 0.0;
    }

    void sumUp()
    {
        double variation = 0.0, length = 0.0, jumps = 0.0;
        for (std::size_t i = 0; i < table_.cells.size(); ++i) {
            TangentCell& cell = table_.cells[i];
            const double angle = jumpBefore(i);
            if (angle > 0.0) table_.corners.push_back({cell.range.first, angle});
            jumps += angle;
            cell.variationBefore = variation;
            cell.lengthBefore = length;
            cell.jumpBefore = jumps;
            variation += std::max(0.0, cell.variation.at(1.0));
            length += cell.length.at(1.0);
        }
        table_.variation = variation + jumps;
        table_.length = length;
    }

    const Curve& curve_;
    Interval whole_;
    double size_;
    double rounding_;  ///< of places along the curve
    TangentTable table_;
    std::vector<bool> isUnresolved_;  ///< of each cell: too narrow to be halved
};

}  // namespace

TangentTable tabulateTangent(const Curve& curve, Interval part) { return TableBuilder(curve, part).build(); }

}  // namespace mesher
