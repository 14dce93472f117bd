#include "brep/curve_crossings.h"

#include "base/box.h"
#include "brep/tangent_variation.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

namespace mesher {

namespace {

constexpr double kLargestTurn = std::numbers::pi / 8.0;
constexpr int kMostPairs = 1'000'000;

/// A part of a curve with its chord and a box that holds it.
struct Piece
{
    std::uint32_t curve = 0;
    Interval part;
    Vec2 first;
    Vec2 last;
    double turn = 0.0;
    Box2 box;

    [[nodiscard]] double size() const { return std::max(box.extent().x, box.extent().y); }
};

bool overlap(const Box2& a, const Box2& b)
{
    return a.low.x <= b.high.x && b.low.x <= a.high.x && a.low.y <= b.high.y && b.low.y <= a.high.y;
}

class CrossingSearch
{
public:
    CrossingSearch(const PlanarCurveComplex& complex, double tolerance) : complex_(complex), tolerance_(tolerance)
    {
        for (std::uint32_t c = 0; c < complex.curves.size(); ++c) {
            const PccCurve& curve = complex.curves[c];
            turning_.emplace_back(curve.curve, curve.part);
            cut(makePiece(c, curve.part));
        }
        measureEnds();
    }

    std::optional<CurveCrossing> run()
    {
        const auto isLeft = [](const Piece& a, const Piece& b) { return a.box.low.x < b.box.low.x; };
        std::stable_sort(pieces_.begin(), pieces_.end(), isLeft);
        std::vector<std::size_t> active;
        for (std::size_t i = 0; i < pieces_.size(); ++i) {
            const Piece& piece = pieces_[i];
            std::erase_if(active, [&](std::size_t k) { return pieces_[k].box.high.x < piece.box.low.x; });
            for (const std::size_t k : active) {
                pairsLeft_ = kMostPairs;
                common_ = commonPoints(piece.curve, pieces_[k].curve);
                if (const auto found = meet(piece, pieces_[k])) return found;
            }
            active.push_back(i);
        }
        return {};
    }

private:
    Vec2 position(std::uint32_t curve, double t) const
    {
        return complex_.frame.toPlane(complex_.curves[curve].curve->position(t));
    }

    Piece makePiece(std::uint32_t curve, Interval part) const
    {
        Piece piece{curve, part, position(curve, part.first), position(curve, part.last), 0.0, {}};
        piece.turn = turning_[curve].variation(part.first, part.last);
        piece.box.include(piece.first);
        piece.box.include(piece.last);
        // A piece that turns by more is cut before its box is looked at.
        const double bulge = 0.5 * length(piece.last - piece.first) * std::tan(0.5 * std::min(piece.turn, 1.5));
        const Vec2 margin{bulge, bulge};
        piece.box = {piece.box.low - margin, piece.box.high + margin};
        return piece;
    }

    std::pair<Piece, Piece> halves(const Piece& piece) const
    {
        const double middle = turning_[piece.curve].equalSplit(piece.part.first, piece.part.last);
        return {makePiece(piece.curve, {piece.part.first, middle}), makePiece(piece.curve, {middle, piece.part.last})};
    }

    bool canBeCut(const Piece& piece) const
    {
        return std::nextafter(piece.part.first, piece.part.last) < piece.part.last;
    }

    void cut(const Piece& whole)
    {
        // A closed curve has no chord: it is cut whatever it turns.
        std::vector<Piece> open{whole};
        while (!open.empty()) {
            const Piece piece = open.back();
            open.pop_back();
            const bool isWholeLoop = piece.part == whole.part && complex_.curves[whole.curve].first == complex_.curves[whole.curve].last;
            if ((piece.turn <= kLargestTurn && !isWholeLoop) || !canBeCut(piece)) {
                pieces_.push_back(piece);
                continue;
            }
            const auto [left, right] = halves(piece);
            open.push_back(right);
            open.push_back(left);
        }
    }

    void measureEnds()
    {
        reach_.assign(complex_.points.size(), 2.0 * tolerance_);
        for (std::uint32_t c = 0; c < complex_.curves.size(); ++c) {
            const PccCurve& curve = complex_.curves[c];
            include(curve.first, position(c, curve.part.first));
            include(curve.last, position(c, curve.part.last));
        }
    }

    void include(PccPointId point, Vec2 end)
    {
        const double miss = length(end - complex_.points[point.value].position);
        reach_[point.value] = std::max(reach_[point.value], 2.0 * (miss + tolerance_));
    }

    /// A point that two curves share, and how far around it they count as meeting in it.
    struct CommonPoint
    {
        PccPointId point;
        double reach = 0.0;
    };

    std::vector<CommonPoint> commonPoints(std::uint32_t a, std::uint32_t b) const
    {
        const PccCurve& ca = complex_.curves[a];
        const PccCurve& cb = complex_.curves[b];
        std::vector<CommonPoint> common;
        for (const PccPointId p : {ca.first, ca.last}) {
            if (p == cb.first || p == cb.last) common.push_back({p, reach_[p.value]});
        }
        return common;
    }

    bool isWithinReach(const Box2& box) const
    {
        const auto covers = [&](const CommonPoint& common) {
            const Vec2 p = complex_.points[common.point.value].position;
            const Vec2 far{std::max(std::abs(box.low.x - p.x), std::abs(box.high.x - p.x)),
                           std::max(std::abs(box.low.y - p.y), std::abs(box.high.y - p.y))};
            return length(far) <= common.reach;
        };
        return std::any_of(common_.begin(), common_.end(), covers);
    }

    /// Curves that are tangent to each other in a common point are nearer than the tolerance for a while: is the place of
    /// the pieces within that while? If so the point's reach grows to it.
    bool isStillCommon(const Piece& a, const Piece& b)
    {
        constexpr double kLongestWhile = 0.05;  // of a curve; beyond it the curves coincide
        for (CommonPoint& common : common_) {
            const double along = std::max(lengthFrom(common.point, a), lengthFrom(common.point, b));
            const double whole = std::min(turning_[a.curve].totalLength(), turning_[b.curve].totalLength());
            if (along > kLongestWhile * whole || !runBesideEachOther(common.point, a, b)) continue;
            common.reach = std::max(common.reach, along);
            return true;
        }
        return false;
    }

    /// Arc length from the piece to that end of its curve which is the point.
    double lengthFrom(PccPointId point, const Piece& piece) const
    {
        const PccCurve& curve = complex_.curves[piece.curve];
        const TangentVariation& turning = turning_[piece.curve];
        const double toFirst = turning.arcLength(curve.part.first, piece.part.last);
        const double toLast = turning.arcLength(piece.part.first, curve.part.last);
        if (curve.first != point) return toLast;
        return curve.last == point ? std::min(toFirst, toLast) : toFirst;
    }

    bool runBesideEachOther(PccPointId point, const Piece& a, const Piece& b) const
    {
        constexpr int kSamples = 8;
        const PccCurve& ca = complex_.curves[a.curve];
        const PccCurve& cb = complex_.curves[b.curve];
        const bool isFromFirst = ca.first == point && (ca.last != point || a.part.first - ca.part.first < ca.part.last - a.part.last);
        const Interval between = isFromFirst ? Interval{ca.part.first, a.part.first} : Interval{a.part.last, ca.part.last};
        for (int i = 1; i < kSamples; ++i) {
            const Vec3 p = ca.curve->position(between.at(static_cast<double>(i) / kSamples));
            if (cb.curve->project(p, cb.part).distance > 8.0 * tolerance_ + reach_[point.value]) return false;
        }
        return true;
    }

    bool areNeighbours(const Piece& a, const Piece& b) const
    {
        return a.curve == b.curve && (a.part.last == b.part.first || b.part.last == a.part.first);
    }

    /// Neighbours on one curve that together turn by less than a right angle cannot meet again.
    bool cannotMeetAgain(const Piece& a, const Piece& b) const
    {
        if (!areNeighbours(a, b)) return false;
        const double first = std::min(a.part.first, b.part.first), last = std::max(a.part.last, b.part.last);
        return turning_[a.curve].variation(first, last) < 0.5 * std::numbers::pi;
    }

    /// Parts of one curve with next to nothing between them, as at a sharp corner.
    bool areNextOnOneCurve(const Piece& a, const Piece& b) const
    {
        if (a.curve != b.curve) return false;
        const Piece& before = a.part.first < b.part.first ? a : b;
        const Piece& after = a.part.first < b.part.first ? b : a;
        if (!(before.part.last < after.part.first)) return true;
        return turning_[a.curve].arcLength(before.part.last, after.part.first) <= 100.0 * tolerance_;
    }

    std::optional<CurveCrossing> meet(const Piece& a, const Piece& b)
    {
        if (!overlap(a.box, b.box) || cannotMeetAgain(a, b)) return {};
        if (isWithinReach(a.box) && isWithinReach(b.box)) return {};
        const bool isSmall = std::max(a.size(), b.size()) <= tolerance_;
        if (isSmall || --pairsLeft_ < 0 || (!canBeCut(a) && !canBeCut(b))) {
            if (areNextOnOneCurve(a, b) || isStillCommon(a, b)) return {};
            const Vec2 where = 0.25 * (a.first + a.last + b.first + b.last);
            return CurveCrossing{PccCurveId(std::min(a.curve, b.curve)), PccCurveId(std::max(a.curve, b.curve)), where};
        }
        const bool cutsA = canBeCut(a) && (a.size() >= b.size() || !canBeCut(b));
        const auto [left, right] = halves(cutsA ? a : b);
        const Piece& other = cutsA ? b : a;
        if (const auto found = meet(left, other)) return found;
        return meet(right, other);
    }

    const PlanarCurveComplex& complex_;
    double tolerance_;
    std::vector<TangentVariation> turning_;
    std::vector<Piece> pieces_;
    std::vector<double> reach_;  ///< of each point: within it curves count as meeting in the point
    std::vector<CommonPoint> common_;  ///< of the pair at hand
    int pairsLeft_ = kMostPairs;
};

}  // namespace

std::optional<CurveCrossing> findCurveCrossing(const PlanarCurveComplex& complex, double tolerance)
{
    return CrossingSearch(complex, tolerance).run();
}

}  // namespace mesher
