#include "pipeline/facet_departures.h"

#include "base/indexed_map.h"

#include <algorithm>
#include <array>
#include <cstdint>

namespace mesher {

namespace {

/// Of an edge: its middle, where what bends one way departs the most, and two more for what bends both ways.
constexpr std::array<double, 3> kShares = {0.25, 0.5, 0.75};
/// Over a facet a quadric departs by at most 4/3 of what it does in the middles of the edges; the rest is for what is not one.
constexpr double kBetweenPlaces = 1.5;

std::uint64_t keyOf(NodeId a, NodeId b)
{
    return std::uint64_t{std::min(a, b).value} << 32 | std::max(a, b).value;
}

Vec3 between(const Vec3& a, const Vec3& b, double share) { return (1.0 - share) * a + share * b; }
Vec2 between(Vec2 a, Vec2 b, double share) { return (1.0 - share) * a + share * b; }

/// Points of the curve of a segment, at the shares of the way from its node of the smaller number.
using CurvePoints = std::array<Vec3, kShares.size()>;

/// By the nodes of the segment.
IndexedMap<std::uint64_t, CurvePoints> pointsOfSegments(const BrepModel& model, const SurfaceMesh& mesh)
{
    IndexedMap<std::uint64_t, CurvePoints> points;
    for (const SurfaceSegment& segment : mesh.segments) {
        if (!segment.isAlive() || model.edges[segment.edge].isDegenerate) continue;
        auto [from, to] = segment.parameter;
        if (segment.node[1] < segment.node[0]) std::swap(from, to);
        CurvePoints curve;
        for (std::size_t k = 0; k < curve.size(); ++k) {
            curve[k] = model.edges[segment.edge].curve->position((1.0 - kShares[k]) * from + kShares[k] * to);
        }
        points.insert(keyOf(segment.node[0], segment.node[1]), curve);
    }
    return points;
}

/// The departure of one facet: the largest over its centre and over points of its edges.
class FacetMeasure
{
public:
    FacetMeasure(const BrepFace& face, const SurfaceMesh& mesh, const SurfaceFacet& facet)
        : face_(face), facet_(facet)
    {
        for (std::size_t i = 0; i < 3; ++i) corner_[i] = mesh.nodes[facet.node[i]].position;
    }

    [[nodiscard]] FacetDeparture measure(const IndexedMap<std::uint64_t, CurvePoints>& segments)
    {
        const auto& uv = facet_.parameters;
        ask((1.0 / 3.0) * (corner_[0] + corner_[1] + corner_[2]), (1.0 / 3.0) * (uv[0] + uv[1] + uv[2]));
        for (std::size_t i = 0; i < 3; ++i) {
            const std::size_t j = (i + 1) % 3;
            const CurvePoints* curve = segments.find(keyOf(facet_.node[i], facet_.node[j]));
            if (curve != nullptr) {
                followCurve(facet_.node[i] < facet_.node[j] ? i : j, facet_.node[i] < facet_.node[j] ? j : i,
                            *curve);
                continue;
            }
            for (const double share : kShares)
                ask(between(corner_[i], corner_[j], share), between(uv[i], uv[j], share));
        }
        projectLargest();
        departure_.distance *= kBetweenPlaces;
        return departure_;
    }

private:
    /// A place of the facet; the surface is no farther from it than its point of these parameters.
    struct Place
    {
        Vec3 position;
        Vec2 parameters;
        double bound = 0.0;
    };

    void ask(const Vec3& position, Vec2 parameters)
    {
        places_[count_++] = {position, parameters, length(face_.surface->position(parameters) - position)};
    }

    /// An edge of the facet that is a segment: beyond it the face goes on to the curve.
    void followCurve(std::size_t first, std::size_t last, const CurvePoints& curve)
    {
        for (std::size_t k = 0; k < curve.size(); ++k) {
            const Vec3 chord = between(corner_[first], corner_[last], kShares[k]);
            departure_.distance = std::max(departure_.distance, length(chord - curve[k]));
            const Vec2 uv = between(facet_.parameters[first], facet_.parameters[last], kShares[k]);
            departure_.isFlush =
                departure_.isFlush && length(face_.surface->position(uv) - curve[k]) <= face_.tolerance;
        }
    }

    /// In the order of the bounds, so that most facets need one projection only.
    void projectLargest()
    {
        const auto end = places_.begin() + static_cast<std::ptrdiff_t>(count_);
        std::sort(places_.begin(), end, [](const Place& a, const Place& b) { return a.bound > b.bound; });
        for (auto place = places_.begin(); place != end && place->bound > departure_.distance; ++place) {
            const SurfaceProjection exact = face_.surface->project(place->position, place->parameters);
            departure_.distance = std::max(departure_.distance, std::min(exact.distance, place->bound));
        }
    }

    const BrepFace& face_;
    const SurfaceFacet& facet_;
    std::array<Vec3, 3> corner_;
    std::array<Place, 1 + 3 * kShares.size()> places_;
    std::size_t count_ = 0;
    FacetDeparture departure_;
};

}  // namespace

IdVector<FacetId, FacetDeparture> facetDepartures(const BrepModel& model, const SurfaceMesh& mesh)
{
    const IndexedMap<std::uint64_t, CurvePoints> segments = pointsOfSegments(model, mesh);
    IdVector<FacetId, FacetDeparture> departures(mesh.facets.size());
    for (std::uint32_t f = 0; f < mesh.facets.size(); ++f) {
        const SurfaceFacet& facet = mesh.facets[FacetId(f)];
        if (!facet.isAlive()) continue;
        departures[FacetId(f)] = FacetMeasure(model.faces[facet.face], mesh, facet).measure(segments);
    }
    return departures;
}

}  // namespace mesher
