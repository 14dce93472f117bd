#include "surface_sampling/curve_division.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

namespace mesher {

namespace {

/// Counts of pieces that are whole but for rounding.
constexpr double kCountSlack = 1e-9;
/// Chords of curves that should be straight, radians.
constexpr double kStraight = 1e-9;
constexpr double kMostStations = 4096.0;
/// Sizes whose inverse is still a number.
constexpr double kLeastSize = 1e-200;

/// Mean of the densities along a step from their values at its ends: between sizes that differ by much the size goes evenly, and
/// near one of nearly nothing the mean of the densities would be that of its end alone.
double meanDensity(double first, double last)
{
    constexpr double kSteep = 8.0;
    const double ratio = first / last;
    if (!(ratio >= kSteep || ratio <= 1.0 / kSteep)) return 0.5 * (first + last);
    return std::log(ratio) / (1.0 / last - 1.0 / first);
}

/// The whole number of pieces whose length is nearest to the one asked for, as a factor.
double nearestWhole(double count)
{
    const double below = std::max(1.0, std::floor(count));
    return count * count < below * (below + 1.0) ? below : below + 1.0;
}

/// A curve between two corners: the number of pieces that is wanted up to each of its stations.
class SmoothPart
{
public:
    SmoothPart(const TangentVariation& table, Interval part, const CurveWishes& wishes)
        : table_(table),
          part_(part),
          wishes_(wishes),
          arc_(table.arcLength(part.first, part.last)),
          variation_(table.variation(part.first, part.last))
    {
        constexpr double kFewest = 16.0;
        const bool isSized = wishes_.sizes != nullptr && arc_ > wishes_.floor;
        count(isSized ? kFewest : 1.0, isSized);
        const double wanted = std::min(4.0 * stations_.back().sized, kMostStations);
        if (isSized && wanted > kFewest) count(std::floor(wanted), true);
        pieces_ = std::max(nearestWhole(stations_.back().sized), std::ceil(bound_ - kCountSlack));
        pieces_ = std::min(pieces_, std::max(1.0, std::floor(arc_ / wishes_.floor)));
    }

    [[nodiscard]] double pieces() const { return pieces_; }
    [[nodiscard]] double variationOfPiece() const { return variation_ / pieces_; }
    [[nodiscard]] double lengthOfPiece() const { return arc_ / pieces_; }
    void addPiece() { pieces_ += 1.0; }

    /// Appends the ends of the pieces, but for the first.
    void appendEnds(std::vector<double>& ends, StepWatch& watch) const
    {
        for (double i = 1.0; i <= pieces_ && watch.mayGoOn(); i += 1.0) {
            const double t = i < pieces_ ? parameterAtShare(i / pieces_) : part_.last;
            appendWithin({ends.back(), t}, ends);
        }
    }

private:
    struct Station
    {
        double parameter = 0.0;
        double sized = 0.0;          ///< pieces up to here
        bool isByVariation = false;  ///< in the interval before
    };

    /// Equal steps of the arc length, and of the turning, which may be all in one of those.
    [[nodiscard]] std::vector<double> parametersOf(double steps) const
    {
        std::vector<double> parameters{part_.first, part_.last};
        for (double i = 1.0; i < steps; i += 1.0)
            parameters.push_back(table_.parameterAtLengthFraction(part_.first, part_.last, i / steps));
        const double turns = std::ceil(std::min(kMostStations, 4.0 * variation_ / wishes_.maxVariation));
        for (double i = 1.0; i < turns; i += 1.0)
            parameters.push_back(table_.parameterAtVariation(part_.first, i / turns * variation_));
        std::sort(parameters.begin(), parameters.end());
        parameters.erase(std::unique(parameters.begin(), parameters.end()), parameters.end());
        return parameters;
    }

    void count(double steps, bool isSized)
    {
        const auto densityAt = [&](double t) {
            if (!isSized) return 0.0;
            return 1.0 / std::max(kLeastSize, wishes_.sizes->sizeAt(table_.curve().position(t)));
        };
        stations_.assign(1, {part_.first, 0.0, false});
        bound_ = 0.0;
        double density = densityAt(part_.first);
        for (const double t : parametersOf(steps)) {
            if (!(stations_.back().parameter < t)) continue;
            const double next = densityAt(t);
            const double arc = table_.arcLength(stations_.back().parameter, t);
            const double byShape = boundOf({stations_.back().parameter, t});
            const double bySize = meanDensity(density, next) * arc;
            bound_ += byShape;
            stations_.push_back({t, stations_.back().sized + std::max(byShape, bySize), byShape >= bySize});
            density = next;
        }
    }

    /// The pieces that turning and sag need at least.
    [[nodiscard]] double boundOf(Interval piece) const
    {
        const double turning = table_.variation(piece.first, piece.last);
        double bound = turning / wishes_.maxVariation;
        if (wishes_.maxSag > 0.0) {
            const double arc = table_.arcLength(piece.first, piece.last);
            bound = std::max(bound, std::sqrt(arc * turning / (8.0 * wishes_.maxSag)));
        }
        return bound;
    }

    /// Up to where there is that share of the pieces.
    [[nodiscard]] double parameterAtShare(double shareOfAll) const
    {
        const double count = shareOfAll * stations_.back().sized;
        if (!(count > 0.0)) return table_.parameterAtLengthFraction(part_.first, part_.last, shareOfAll);
        const auto isAbove = [](double value, const Station& station) { return value < station.sized; };
        const auto above = std::upper_bound(stations_.begin(), stations_.end(), count, isAbove);
        if (above == stations_.end()) return part_.last;
        const Station& before = *(above - 1);
        const double share = (count - before.sized) / (above->sized - before.sized);
        if (!above->isByVariation)
            return table_.parameterAtLengthFraction(before.parameter, above->parameter, share);
        return parameterAtTurningShare({before.parameter, above->parameter}, share);
    }

    [[nodiscard]] double parameterAtTurningShare(Interval piece, double share) const
    {
        const double turning = table_.variation(piece.first, piece.last);
        return turning > kStraight ? table_.parameterAtVariation(piece.first, share * turning)
                                   : table_.parameterAtLengthFraction(piece.first, piece.last, share);
    }

    /// One piece, or more where sizes have made it too long for its turning.
    void appendWithin(Interval piece, std::vector<double>& ends) const
    {
        constexpr double kSlack = 1e-6;
        if (!(piece.first < piece.last)) return;
        const double arc = table_.arcLength(piece.first, piece.last);
        const double most = std::max(1.0, std::floor(arc / wishes_.floor));
        const double parts = std::min(most, std::ceil(boundOf(piece) - kSlack));
        for (double i = 1.0; i < parts; i += 1.0) {
            const double t = parameterAtTurningShare(piece, i / parts);
            if (ends.back() < t && t < piece.last) ends.push_back(t);
        }
        ends.push_back(piece.last);
    }

    const TangentVariation& table_;
    Interval part_;
    const CurveWishes& wishes_;
    double arc_;
    double variation_;
    std::vector<Station> stations_;
    double bound_ = 0.0;
    double pieces_ = 1.0;
};

std::vector<SmoothPart> smoothPartsOf(const TangentVariation& table, const CurveWishes& wishes)
{
    std::vector<SmoothPart> parts;
    double start = table.part().first;
    for (const CurveCorner& corner : table.corners()) {
        parts.emplace_back(table, Interval{start, corner.parameter}, wishes);
        start = corner.parameter;
    }
    parts.emplace_back(table, Interval{start, table.part().last}, wishes);
    return parts;
}

double piecesOf(const std::vector<SmoothPart>& parts)
{
    double total = 0.0;
    for (const SmoothPart& part : parts) total += part.pieces();
    return total;
}

/// The part whose pieces turn most gets one more, or whose pieces are longest if all are straight; the first of equal ones.
void ensurePieces(std::vector<SmoothPart>& parts, int leastPieces)
{
    for (double total = piecesOf(parts); total < leastPieces; total += 1.0) {
        const auto isLess = [](const SmoothPart& a, const SmoothPart& b) {
            return std::pair(a.variationOfPiece(), a.lengthOfPiece()) <
                   std::pair(b.variationOfPiece(), b.lengthOfPiece());
        };
        std::max_element(parts.begin(), parts.end(), isLess)->addPiece();
    }
}

}  // namespace

std::vector<double> divideCurve(const TangentVariation& table, const CurveWishes& wishes, StepWatch& watch)
{
    std::vector<SmoothPart> parts = smoothPartsOf(table, wishes);
    ensurePieces(parts, wishes.leastPieces);
    if (!(piecesOf(parts) < wishes.mostPieces)) return {};
    std::vector<double> ends{table.part().first};
    for (const SmoothPart& part : parts) part.appendEnds(ends, watch);
    return ends;
}

}  // namespace mesher
