#include "triangulation2d/small_angles2d.h"

#include "brep/curve_cuts.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

namespace mesher {
namespace {

constexpr double kDegreesPerRadian = 180.0 / std::numbers::pi;
constexpr double kFullTurn = 2.0 * std::numbers::pi;

struct CurveEndAt
{
    SubcurveId subcurve;
    CurveEnd end = CurveEnd::First;
    double tangentAngle = 0.0;
    double orderAngle =
        0.0;  ///< of the curve's point on a common circle around the apex: curves do not cross there
};

double angleOf(Vec2 v) { return std::atan2(v.y, v.x); }

/// The ends of subcurves at each corner vertex, flat and in order of the subcurves.
class EndsByVertex
{
public:
    explicit EndsByVertex(const Boundary& boundary) : start_(boundary.vertices.size() + 1, 0)
    {
        forEachEnd(boundary, [&](BoundaryVertexId v, CurveEndAt) { ++start_[v.value + 1]; });
        for (std::size_t i = 1; i < start_.size(); ++i) start_[i] += start_[i - 1];
        ends_.resize(start_.back());
        std::vector<std::size_t> next(start_.begin(), start_.end() - 1);
        forEachEnd(boundary, [&](BoundaryVertexId v, CurveEndAt end) { ends_[next[v.value]++] = end; });
    }

    [[nodiscard]] std::vector<CurveEndAt> at(BoundaryVertexId v) const
    {
        return {ends_.begin() + static_cast<std::ptrdiff_t>(start_[v.value]),
                ends_.begin() + static_cast<std::ptrdiff_t>(start_[v.value + 1])};
    }

private:
    template <class Visit>
    static void forEachEnd(const Boundary& boundary, Visit&& visit)
    {
        for (std::uint32_t i = 0; i < boundary.subcurves.size(); ++i) {
            const Subcurve& subcurve = boundary.subcurves[SubcurveId(i)];
            if (!subcurve.isAlive) continue;
            if (boundary.vertices[subcurve.first].isCorner) {
                visit(subcurve.first, CurveEndAt{SubcurveId(i), CurveEnd::First});
            }
            if (boundary.vertices[subcurve.last].isCorner) {
                visit(subcurve.last, CurveEndAt{SubcurveId(i), CurveEnd::Last});
            }
        }
    }

    std::vector<std::size_t> start_;
    std::vector<CurveEndAt> ends_;
};

/// The complexes a subcurve takes part in, at either end.
struct Enrolment
{
    SmallAngleId first;
    SmallAngleId last;
    std::uint32_t firstSpoke = 0;
    std::uint32_t lastSpoke = 0;

    [[nodiscard]] SmallAngleId only() const { return first.isValid() ? first : last; }
};

class Protection
{
public:
    Protection(const PlanarDomain& domain, Boundary& boundary) : domain_(domain), boundary_(boundary) {}

    SmallAngles2d run()
    {
        const EndsByVertex endsByVertex(boundary_);
        const std::size_t vertexCount = boundary_.vertices.size();
        for (std::uint32_t i = 0; i < vertexCount; ++i) {
            if (!boundary_.vertices[BoundaryVertexId(i)].isCorner) continue;
            std::vector<CurveEndAt> ends = endsByVertex.at(BoundaryVertexId(i));
            if (ends.size() >= 2) findComplexes(BoundaryVertexId(i), ends);
        }
        enrolments_.resize(boundary_.subcurves.size());
        splitBetweenApexes();
        cutAtShells();
        return std::move(result_);
    }

private:
    void sortAround(BoundaryVertexId apex, std::vector<CurveEndAt>& ends) const
    {
        double shortest = std::numeric_limits<double>::infinity();
        for (const CurveEndAt& end : ends) shortest = std::min(shortest, boundary_.edgeLength(end.subcurve));
        const double radius = 0.5 * shortest / domain_.scale();
        const BoundaryVertex& centre = boundary_.vertices[apex];
        for (CurveEndAt& end : ends) {
            const Subcurve& subcurve = boundary_.subcurves[end.subcurve];
            end.tangentAngle = angleOf(domain_.directionInto(subcurve.curve, subcurve.part, end.end));
            const DistanceCrossing crossing =
                domain_.variation(subcurve.curve)
                    .parameterAtDistance(centre.space, radius, subcurve.part, end.end);
            end.orderAngle =
                crossing.parameter
                    ? angleOf(domain_.place(subcurve.curve, *crossing.parameter).position - centre.position)
                    : end.tangentAngle;
        }
        std::stable_sort(ends.begin(), ends.end(), [](const CurveEndAt& a, const CurveEndAt& b) {
            return a.orderAngle < b.orderAngle;
        });
    }

    /// From one end counter-clockwise to the next; the tangents' angle, which for touching curves is zero and not a turn.
    static double wedgeAngle(const CurveEndAt& from, const CurveEndAt& to, bool isWrapped)
    {
        const double order = to.orderAngle - from.orderAngle + (isWrapped ? kFullTurn : 0.0);
        const double tangents = to.tangentAngle - from.tangentAngle;
        const double turns = std::round((order - tangents) / kFullTurn);
        return std::max(0.0, tangents + turns * kFullTurn);
    }

    [[nodiscard]] RegionId regionLeftOf(const CurveEndAt& end) const
    {
        const PccCurve& curve = domain_.curve(boundary_.subcurves[end.subcurve].curve);
        return end.end == CurveEnd::First ? curve.left : curve.right;
    }

    void findComplexes(BoundaryVertexId apex, std::vector<CurveEndAt>& ends)
    {
        sortAround(apex, ends);
        const std::size_t count = ends.size();
        std::vector<double> wedges(count);
        std::vector<bool> isSmall(count);
        for (std::size_t i = 0; i < count; ++i) {
            wedges[i] = wedgeAngle(ends[i], ends[(i + 1) % count], i + 1 == count) * kDegreesPerRadian;
            isSmall[i] =
                wedges[i] < SmallAngles2d::kLimitDegrees - kAngleSlack && regionLeftOf(ends[i]).value != 0;
        }
        // Start behind a wedge that is not small, so that no complex is met in its middle.
        const auto large = std::find(isSmall.begin(), isSmall.end(), false);
        const std::size_t start =
            large == isSmall.end() ? 0 : static_cast<std::size_t>(large - isSmall.begin()) + 1;
        SmallAngleId open;
        for (std::size_t k = 0; k < count; ++k) {
            const std::size_t i = (start + k) % count;
            if (!isSmall[i]) {
                open = SmallAngleId();
                continue;
            }
            if (!open.isValid()) open = result_.complexes.push_back({apex, {}, 0});
            const CurveEndAt& next = ends[(i + 1) % count];
            result_.complexes[open].angles.push_back({boundary_.subcurves[ends[i].subcurve].curve,
                                                      boundary_.subcurves[next.subcurve].curve, wedges[i]});
            const auto spokes = static_cast<std::uint32_t>(result_.complexes[open].angles.size());
            enrol(ends[i], open, spokes - 1);
            enrol(next, open, spokes);
        }
    }

    /// A curve between two angles comes twice, and keeps the number it had first where the angles close the turn.
    void enrol(const CurveEndAt& end, SmallAngleId complex, std::uint32_t spoke)
    {
        enrolments_.resize(boundary_.subcurves.size());
        Enrolment& enrolment = enrolments_[end.subcurve.value];
        const bool isFirst = end.end == CurveEnd::First;
        if ((isFirst ? enrolment.first : enrolment.last) == complex) return;
        (isFirst ? enrolment.first : enrolment.last) = complex;
        (isFirst ? enrolment.firstSpoke : enrolment.lastSpoke) = spoke;
    }

    /// A subcurve between two apexes is split at its ordinary place; either half then has one.
    void splitBetweenApexes()
    {
        for (std::uint32_t i = 0; i < enrolments_.size(); ++i) {
            const Enrolment whole = enrolments_[i];
            if (!whole.first.isValid() || !whole.last.isValid()) continue;
            const auto place = equalVariationPlace(domain_, boundary_, SubcurveId(i));
            if (!place) {
                result_.unprotected += 2;
                enrolments_[i] = {};
                continue;
            }
            const Boundary::Halves halves = boundary_.split(SubcurveId(i), *place);
            ++result_.splits;
            enrolments_.resize(boundary_.subcurves.size());
            enrolments_[i] = {};
            enrolments_[halves.first.value].first = whole.first;
            enrolments_[halves.first.value].firstSpoke = whole.firstSpoke;
            enrolments_[halves.last.value].last = whole.last;
            enrolments_[halves.last.value].lastSpoke = whole.lastSpoke;
        }
    }

    void cutAtShells()
    {
        IdVector<SmallAngleId, double> shortest(result_.complexes.size(),
                                                std::numeric_limits<double>::infinity());
        for (std::uint32_t i = 0; i < enrolments_.size(); ++i) {
            const SmallAngleId complex = enrolments_[i].only();
            if (complex.isValid())
                shortest[complex] = std::min(shortest[complex], boundary_.edgeLength(SubcurveId(i)));
        }
        for (std::uint32_t i = 0; i < result_.complexes.size(); ++i) {
            SmallAngleComplex& complex = result_.complexes[SmallAngleId(i)];
            complex.firstShell = firstShellExponent(shortest[SmallAngleId(i)]);
            boundary_.apexes.push_back(boundary_.vertices[complex.apex].space);
        }
        for (std::uint32_t i = 0; i < enrolments_.size(); ++i) {
            if (enrolments_[i].only().isValid()) cutAtShell(SubcurveId(i), enrolments_[i]);
        }
    }

    void cutAtShell(SubcurveId s, const Enrolment& enrolment)
    {
        const SmallAngleId complex = enrolment.only();
        const CurveEnd end = enrolment.first.isValid() ? CurveEnd::First : CurveEnd::Last;
        const double radius = std::ldexp(1.0, result_.complexes[complex].firstShell);
        auto place = shellPlace(domain_, boundary_, s, end, boundary_.apexes[complex.value], radius);
        if (!place) {
            ++result_.unprotected;
            return;
        }
        Subcurve& subcurve = boundary_.subcurves[s];
        subcurve.nearEnd = end;
        subcurve.wedge = complex;
        subcurve.spoke = end == CurveEnd::First ? enrolment.firstSpoke : enrolment.lastSpoke;
        place->wedge = complex;
        const Boundary::Halves halves = boundary_.split(s, *place);
        // Beyond the first shell the curves go their own ways.
        boundary_.subcurves[end == CurveEnd::First ? halves.last : halves.first].wedge = SmallAngleId();
        ++result_.splits;
    }

    // Hexagonal figures have angles of 60 degrees up to rounding, which are not small.
    static constexpr double kAngleSlack = 1e-6;

    const PlanarDomain& domain_;
    Boundary& boundary_;
    SmallAngles2d result_;
    std::vector<Enrolment> enrolments_;  // by subcurve
};

}  // namespace

double SmallAngleComplex::smallestAngle() const
{
    double smallest = SmallAngles2d::kLimitDegrees;
    for (const InputAngle& angle : angles) smallest = std::min(smallest, angle.degrees);
    return smallest;
}

std::uint32_t SmallAngleComplex::angleBetween(std::uint32_t spoke, std::uint32_t other) const
{
    const auto [low, high] = std::minmax(spoke, other);
    MESHER_PRECONDITION(low + 1 == high || (low == 0 && high + 1 == angles.size()));
    return low + 1 == high ? low : high;
}

SmallAngles2d protectSmallAngles(const PlanarDomain& domain, Boundary& boundary)
{
    return Protection(domain, boundary).run();
}

}  // namespace mesher
