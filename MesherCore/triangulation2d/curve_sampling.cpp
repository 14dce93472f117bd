#include "triangulation2d/curve_sampling.h"

#include "base/indexed_map.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace mesher {
namespace {

constexpr double kRadiansPerDegree = std::numbers::pi / 180.0;
// A quarter circle in floating point turns by a rounding error more than 90 degrees.
constexpr double kVariationSlack = 1e-9;

/// A part of a curve between corners, and into how many subcurves it is cut.
struct SmoothSpan
{
    Interval part;
    double variation = 0.0;
    int pieces = 1;
};

std::vector<SmoothSpan> smoothSpans(const TangentVariation& table, double maxVariation)
{
    std::vector<SmoothSpan> spans;
    double start = table.part().first;
    const auto add = [&](double end) {
        SmoothSpan span{{start, end}, table.variation(start, end), 1};
        span.pieces =
            std::max(1, static_cast<int>(std::ceil(span.variation / maxVariation - kVariationSlack)));
        spans.push_back(span);
        start = end;
    };
    for (const CurveCorner& corner : table.corners()) add(corner.parameter);
    add(table.part().last);
    return spans;
}

void ensureThreePieces(std::vector<SmoothSpan>& spans)
{
    int total = 0;
    for (const SmoothSpan& span : spans) total += span.pieces;
    for (; total < 3; ++total) {
        // The span whose pieces turn most; the first of equal ones.
        const auto worst =
            std::max_element(spans.begin(), spans.end(), [](const SmoothSpan& a, const SmoothSpan& b) {
                return a.variation / a.pieces < b.variation / b.pieces;
            });
        ++worst->pieces;
    }
}

class Sampler
{
public:
    Sampler(const PlanarDomain& domain, double maxVariation) : domain_(domain), maxVariation_(maxVariation) {}

    Result<Boundary> run()
    {
        for (std::uint32_t i = 0; i < domain_.complex().points.size(); ++i) {
            pointVertices_.push_back(boundary_.addPoint(domain_, PccPointId(i)));
        }
        for (std::uint32_t i = 0; i < domain_.curveCount(); ++i) sampleCurve(PccCurveId(i));
        if (auto separated = separateTwins(); !separated) return separated.error();
        return std::move(boundary_);
    }

private:
    void sampleCurve(PccCurveId id)
    {
        const PccCurve& curve = domain_.curve(id);
        const TangentVariation& table = domain_.variation(id);
        std::vector<SmoothSpan> spans = smoothSpans(table, maxVariation_);
        if (curve.first == curve.last) ensureThreePieces(spans);
        BoundaryVertexId previous = pointVertices_[curve.first.value];
        double start = curve.part.first;
        for (const SmoothSpan& span : spans) {
            for (int piece = 1; piece <= span.pieces; ++piece) {
                const bool isEnd = piece == span.pieces;
                const double t = isEnd ? span.part.last : interiorParameter(table, span, piece);
                if (!(start < t)) continue;
                const BoundaryVertexId next = t == curve.part.last
                                                  ? pointVertices_[curve.last.value]
                                                  : boundary_.addSample(domain_.place(id, t), id, t, isEnd);
                Subcurve subcurve;
                subcurve.curve = id;
                subcurve.part = {start, t};
                subcurve.first = previous;
                subcurve.last = next;
                boundary_.addSubcurve(subcurve);
                previous = next;
                start = t;
            }
        }
    }

    static double interiorParameter(const TangentVariation& table, const SmoothSpan& span, int piece)
    {
        const double fraction = piece / static_cast<double>(span.pieces);
        const double t = span.variation > 0.0
                             ? table.parameterAtVariation(span.part.first, fraction * span.variation)
                             : table.parameterAtLengthFraction(span.part.first, span.part.last, fraction);
        return std::min(t, span.part.last);
    }

    /// Two subcurves between the same vertices would have one boundary edge: the one that turns more is split.
    Result<void> separateTwins()
    {
        IndexedMap<std::pair<BoundaryVertexId, BoundaryVertexId>, SubcurveId> edges;
        const std::size_t count = boundary_.subcurves.size();
        for (std::uint32_t i = 0; i < count; ++i) {
            const SubcurveId s(i);
            const Subcurve& subcurve = boundary_.subcurves[s];
            const auto key = unorderedPair(subcurve.first, subcurve.last);
            const auto [twin, isNew] = edges.insert(key, s);
            if (isNew) continue;
            const SubcurveId other = *twin;
            const bool splitsOther = turning(other) > turning(s);
            if (!splitsOther && !(turning(s) > kVariationSlack)) return twinError(s, other);
            const SubcurveId bent = splitsOther ? other : s;
            const auto place = equalVariationPlace(domain_, boundary_, bent);
            if (!place) return twinError(s, other);
            boundary_.split(bent, *place);
            if (splitsOther) edges.insertOrAssign(key, s);
        }
        return {};
    }

    [[nodiscard]] double turning(SubcurveId s) const
    {
        const Subcurve& subcurve = boundary_.subcurves[s];
        return domain_.variation(subcurve.curve).variation(subcurve.part.first, subcurve.part.last);
    }

    [[nodiscard]] Error twinError(SubcurveId a, SubcurveId b) const
    {
        Error error;
        error.code = ErrorCode::IntersectingConstraints;
        error.entity = domain_.nameOf(boundary_.subcurves[a].curve) + " and " +
                       domain_.nameOf(boundary_.subcurves[b].curve);
        error.message = "two curves coincide";
        error.point = boundary_.vertices[boundary_.subcurves[a].first].space;
        error.remedy = "remove one of them";
        return error;
    }

    const PlanarDomain& domain_;
    double maxVariation_;
    Boundary boundary_;
    std::vector<BoundaryVertexId> pointVertices_;
};

}  // namespace

Result<Boundary> sampleCurves(const PlanarDomain& domain, const CurveSamplingOptions& options)
{
    // Relative to the domain; the coordinates of doubles resolve about 2e-16 of it.
    constexpr double kResolution = 1e-11;
    auto result = Sampler(domain, options.maxVariation * kRadiansPerDegree).run();
    if (result) result->resolution = kResolution * domain.size();
    return result;
}

}  // namespace mesher
