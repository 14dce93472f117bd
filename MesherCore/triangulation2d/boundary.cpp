#include "triangulation2d/boundary.h"

#include <cmath>

namespace mesher {
namespace {

std::optional<SplitPlace> placeAt(const PlanarDomain& domain, const Boundary& boundary, SubcurveId s, double t)
{
    const Subcurve& subcurve = boundary.subcurves[s];
    if (!(subcurve.part.first < t && t < subcurve.part.last)) return std::nullopt;
    SplitPlace result;
    result.parameter = t;
    result.place = domain.place(subcurve.curve, t);
    if (result.place.position == boundary.from(s) || result.place.position == boundary.to(s)) return std::nullopt;
    return result;
}

/// Exponent of the next shell for the subcurve at an apex: below that of its other end, if that lies on a shell.
int nextShellExponent(const Boundary& boundary, SubcurveId s, SmallAngleId apex, BoundaryVertexId otherEnd)
{
    const BoundaryVertex& other = boundary.vertices[otherEnd];
    return other.shell == apex ? other.shellExponent - 1 : firstShellExponent(boundary.edgeLength(s));
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

BoundaryVertexId Boundary::addSample(const PlanarPlace& place, PccCurveId curve, double parameter, bool isCorner)
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
    vertices[halves.vertex].shell = place.shell;
    vertices[halves.vertex].shellExponent = place.shellExponent;
    first.isQueued = false;
    Subcurve last = first;
    first.last = last.first = halves.vertex;
    first.part.last = last.part.first = place.parameter;
    first.lastApex = last.firstApex = SmallAngleId();
    subcurves[s].isAlive = false;
    --aliveCount_;
    halves.first = addSubcurve(first);
    halves.last = addSubcurve(last);
    return halves;
}

std::optional<SplitPlace> equalVariationPlace(const PlanarDomain& domain, const Boundary& boundary, SubcurveId s)
{
    const Subcurve& subcurve = boundary.subcurves[s];
    if (boundary.edgeLength(s) < boundary.resolution) return std::nullopt;
    const double t = domain.variation(subcurve.curve).equalSplit(subcurve.part.first, subcurve.part.last);
    return placeAt(domain, boundary, s, t);
}

std::optional<SplitPlace> shellPlace(const PlanarDomain& domain, const Boundary& boundary, SubcurveId s,
                                     CurveEnd apexEnd, int exponent)
{
    constexpr int kSmallerShellsTried = 8;
    const Subcurve& subcurve = boundary.subcurves[s];
    const bool isFirst = apexEnd == CurveEnd::First;
    const BoundaryVertex& apex = boundary.vertices[isFirst ? subcurve.first : subcurve.last];
    if (boundary.edgeLength(s) < boundary.resolution) return std::nullopt;
    for (int tried = 0; tried < kSmallerShellsTried; ++tried, --exponent) {
        const double radius = std::ldexp(1.0, exponent) / domain.scale();
        const DistanceCrossing crossing =
            domain.variation(subcurve.curve).parameterAtDistance(apex.space, radius, subcurve.part, apexEnd);
        if (!crossing.parameter || !crossing.isMonotone) continue;
        auto result = placeAt(domain, boundary, s, *crossing.parameter);
        if (!result) return result;
        result->shell = isFirst ? subcurve.firstApex : subcurve.lastApex;
        result->shellExponent = exponent;
        return result;
    }
    return std::nullopt;
}

std::optional<SplitPlace> splitPlace(const PlanarDomain& domain, const Boundary& boundary, SubcurveId s)
{
    const Subcurve& subcurve = boundary.subcurves[s];
    std::optional<SplitPlace> result;
    // With an apex at both ends the ordinary place separates them.
    if (subcurve.firstApex.isValid() && !subcurve.lastApex.isValid()) {
        const int exponent = nextShellExponent(boundary, s, subcurve.firstApex, subcurve.last);
        result = shellPlace(domain, boundary, s, CurveEnd::First, exponent);
    }
    else if (subcurve.lastApex.isValid() && !subcurve.firstApex.isValid()) {
        const int exponent = nextShellExponent(boundary, s, subcurve.lastApex, subcurve.first);
        result = shellPlace(domain, boundary, s, CurveEnd::Last, exponent);
    }
    return result ? result : equalVariationPlace(domain, boundary, s);
}

int firstShellExponent(double shortestEdge)
{
    return std::ilogb(2.0 / 3.0 * shortestEdge);
}

}  // namespace mesher
