#include "surface_sampling/facet_measures.h"
#include "surface_sampling/surface_refinement.h"

#include <algorithm>
#include <cmath>

/// The part of FaceRefiner that leaves flat facets on the rims of walls and across strips.
namespace mesher {
namespace {

/// Cosine between segments of two edges, above which these run side by side: beyond, a face is narrow in a corner only, where good
/// facets are soon as large as wanted.
constexpr double kSideBySide = 0.94;

/// The cosine between two segments, or 0 where the one does not pass beside the other but goes on behind its end.
double sideBySide(const FaceMesh& mesh, EdgeLink first, EdgeLink second)
{
    constexpr double kLeastOverlap = 0.1;
    const Vec3& a = mesh.position(mesh.from(first));
    const Vec3 along = mesh.position(mesh.to(first)) - a;
    const Vec3 &c = mesh.position(mesh.from(second)), &d = mesh.position(mesh.to(second));
    const double squared = squaredLength(along);
    const auto [from, to] = std::minmax({dot(c - a, along) / squared, dot(d - a, along) / squared});
    const double overlap = std::min(to, 1.0) - std::max(from, 0.0);
    if (overlap < kLeastOverlap * std::min(to - from, 1.0)) return 0.0;
    return std::abs(dot(along, d - c)) / std::sqrt(squared * squaredLength(d - c));
}

}  // namespace

/// By the sizes asked for alone where facets run across a strip: that they bend across it does not matter along it.
bool FaceRefiner::isTooLong(EdgeLink side) const
{
    if (!criteria_.isTooLong(mesh_, side)) return false;
    if (rims_ == nullptr || criteria_.isTooLongForSizes(mesh_, side)) return true;
    const std::optional<RimPlace> place = rimPlaceAt(side);
    return !place || !place->isStrip;
}

/// True if it is left as it is.
bool FaceRefiner::leaveOnRim(TriangleId t)
{
    if (rims_ == nullptr) return false;
    const std::optional<RimPlace> place = rimPlaceOf(t);
    if (!place || criteria_.hidesSurface(mesh_, t)) return false;
    mesh_.triangle(t).left = place->isStrip && rims_->isDecided() ? FacetLeft::Strip : FacetLeft::Rim;
    return true;
}

/// Of the facet over a segment, if it is narrow from there to its corner beyond.
std::optional<RimPlace> FaceRefiner::rimPlaceAt(EdgeLink side) const
{
    const SegmentId segment = mesh_.segment(side);
    const VertexId apex = mesh_.apex(side);
    if (rims_ == nullptr || !segment.isValid() || mesh_.vertex(apex).isFree) return std::nullopt;
    const Vec3 &a = mesh_.position(mesh_.from(side)), &b = mesh_.position(mesh_.to(side)),
               &c = mesh_.position(apex);
    const double base = length(b - a);
    const double width = length(cross(b - a, c - a)) / base;
    // Not by its base: a facet of a fan between long and short segments is narrow as well. Nor by segments that were split for
    // the sake of angles: good facets beside it would eat their way in.
    const double longest =
        std::max(std::sqrt(std::max({squaredLength(b - a), squaredLength(c - b), squaredLength(a - c)})),
                 boundary_.wholeLengthOf(segment));
    if (!(width < kFlatFacet * longest)) return std::nullopt;
    std::optional<RimPlace> place = placeBetween(side);
    if (!place) return std::nullopt;
    place->length = base;
    place->width = width;
    return place;
}

/// Between the edge of a segment and one that ends or passes in the corner beyond: a wall's rim rather than a strip.
std::optional<RimPlace> FaceRefiner::placeBetween(EdgeLink side) const
{
    const BrepEdgeId edge = boundary_.edgeOf(mesh_.segment(side));
    std::optional<RimPlace> place;
    double best = kSideBySide;
    mesh_.forEachTriangleAround(mesh_.apex(side), [&](EdgeLink opposite) {
        for (unsigned i = 1; i < 3; ++i) {
            const EdgeLink next(opposite.triangle(), (opposite.edge() + i) % 3);
            if ((place && !place->isStrip) || !mesh_.segment(next).isValid()) continue;
            const BrepEdgeId other = boundary_.edgeOf(mesh_.segment(next));
            if (other == edge) continue;
            if (rims_->isBetween(mesh_.face(), edge, other)) {
                place.emplace();
                place->edge = {edge, other};
                continue;
            }
            const double parallel = sideBySide(mesh_, side, next);
            if (!(parallel > best) || !rims_->isStrip(mesh_.face(), edge, other)) continue;
            best = parallel;
            place.emplace();
            place->edge = {edge, other};
            place->isStrip = true;
        }
    });
    return place;
}

std::optional<RimPlace> FaceRefiner::rimPlaceOf(TriangleId t) const
{
    for (const VertexId v : mesh_.triangle(t).v) {
        if (mesh_.vertex(v).isFree) return std::nullopt;
    }
    for (unsigned k = 0; k < 3; ++k) {
        if (const std::optional<RimPlace> place = rimPlaceAt(EdgeLink(t, k))) return place;
    }
    return std::nullopt;
}

/// Facets that have waited and still are on a rim or strip get to know which.
bool FaceRefiner::hasFormerRim()
{
    bool isAny = false;
    for (std::uint32_t i = 0; i < mesh_.triangleSlots(); ++i) {
        FaceTriangle& record = mesh_.triangle(TriangleId(i));
        if (!record.isAlive || (record.left != FacetLeft::Rim && record.left != FacetLeft::Strip)) continue;
        const std::optional<RimPlace> place = rimPlaceOf(TriangleId(i));
        if (place && place->isStrip) record.left = FacetLeft::Strip;
        isAny = isAny || !place;
    }
    return isAny;
}

}  // namespace mesher
