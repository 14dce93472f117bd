#include "triangulation2d/curve_sampling.h"

#include "base/indexed_map.h"
#include "brep/curve_cuts.h"

#include <numbers>
#include <utility>

namespace mesher {
namespace {

constexpr double kRadiansPerDegree = std::numbers::pi / 180.0;
// Of curves that should be straight.
constexpr double kVariationSlack = 1e-9;

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
        BoundaryVertexId previous = pointVertices_[curve.first.value];
        double start = curve.part.first;
        for (const CurveCut& cut : cutByVariation(table, maxVariation_, curve.first == curve.last ? 3 : 1)) {
            const double t = cut.parameter;
            const BoundaryVertexId next =
                t == curve.part.last ? pointVertices_[curve.last.value]
                                     : boundary_.addSample(domain_.place(id, t), id, t, cut.isCorner);
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
