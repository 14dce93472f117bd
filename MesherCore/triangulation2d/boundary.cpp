#include "triangulation2d/boundary.h"

namespace mesher {
namespace {

std::optional<SplitPlace> placeAt(const PlanarDomain& domain, const Boundary& boundary, SubcurveId s,
                                  double t)
{
    const Subcurve& subcurve = boundary.subcurves[s];
    if (!(subcurve.part.first < t && t < subcurve.part.last)) return std::nullopt;
    SplitPlace result;
    result.parameter = t;
    result.place = domain.place(subcurve.curve, t);
    if (result.place.position == boundary.from(s) || result.place.position == boundary.to(s))
        return std::nullopt;
    return result;
}

}  // namespace

BoundaryVertexId Boundary::addPoint(const PlanarDomain& domain, PccPointId point)
{
    BoundaryVertex vertex;
    const PlanarPlace place = domain.place(point);
    vertex.position = place.position;
    vertex.space = place.space;
    vertex.point = point;
    vertex.isCorner = true;
    return vertices.push_back(vertex);
}

BoundaryVertexId Boundary::addSample(const PlanarPlace& place, PccCurveId curve, double parameter,
                                     bool isCorner)
{
    BoundaryVertex vertex;
    vertex.position = place.position;
    vertex.space = place.space;
    vertex.curve = curve;
    vertex.parameter = parameter;
    vertex.isCorner = isCorner;
    return vertices.push_back(vertex);
}

SubcurveId Boundary::addSubcurve(const Subcurve& subcurve)
{
    ++aliveCount_;
    return subcurves.push_back(subcurve);
}

Boundary::Halves Boundary::split(SubcurveId s, const SplitPlace& place)
{
    MESHER_PRECONDITION(subcurves[s].isAlive);
    Halves halves;
    Subcurve first = subcurves[s];
    halves.vertex = addSample(place.place, first.curve, place.parameter, false);
    vertices[halves.vertex].shell = place.wedge;
    vertices[halves.vertex].spoke = first.spoke;
    vertices[halves.vertex].shellRadius = place.radius;
    first.isQueued = false;
    if (!place.wedge.isValid()) first.wedge = SmallAngleId();
    Subcurve last = first;
    first.last = last.first = halves.vertex;
    first.part.last = last.part.first = place.parameter;
    if (place.wedge.isValid()) {
        const bool isFirstNear = first.nearEnd == CurveEnd::First;
        (isFirstNear ? first : last).farRadius = place.radius;
        (isFirstNear ? last : first).nearRadius = place.radius;
    }
    subcurves[s].isAlive = false;
    --aliveCount_;
    halves.first = addSubcurve(first);
    halves.last = addSubcurve(last);
    return halves;
}

std::optional<SplitPlace> equalVariationPlace(const PlanarDomain& domain, const Boundary& boundary,
                                              SubcurveId s)
{
    const Subcurve& subcurve = boundary.subcurves[s];
    if (boundary.edgeLength(s) < boundary.resolution) return std::nullopt;
    const double t = domain.variation(subcurve.curve).equalSplit(subcurve.part.first, subcurve.part.last);
    return placeAt(domain, boundary, s, t);
}

std::optional<SplitPlace> shellPlace(const PlanarDomain& domain, const Boundary& boundary, SubcurveId s,
                                     CurveEnd nearEnd, const Vec3& apex, double radius)
{
    const Subcurve& subcurve = boundary.subcurves[s];
    if (boundary.edgeLength(s) < boundary.resolution) return std::nullopt;
    const DistanceCrossing crossing =
        domain.variation(subcurve.curve)
            .parameterAtDistance(apex, radius / domain.scale(), subcurve.part, nearEnd);
    if (!crossing.parameter || !crossing.isMonotone) return std::nullopt;
    auto result = placeAt(domain, boundary, s, *crossing.parameter);
    if (result) result->radius = radius;
    return result;
}

std::optional<SplitPlace> splitPlace(const PlanarDomain& domain, const Boundary& boundary, SubcurveId s)
{
    const Subcurve& subcurve = boundary.subcurves[s];
    if (subcurve.wedge.isValid()) {
        const double radius = 0.5 * (subcurve.nearRadius + subcurve.farRadius);
        const Vec3& apex = boundary.apexes[subcurve.wedge.value];
        auto result = shellPlace(domain, boundary, s, subcurve.nearEnd, apex, radius);
        if (result) result->wedge = subcurve.wedge;
        if (result) return result;
    }
    return equalVariationPlace(domain, boundary, s);
}

}  // namespace mesher
