#include "pipeline/component_surface.h"

#include "pipeline/facet_departures.h"
#include "sizing/distances.h"
#include "surface_sampling/triangle_intersection.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>

namespace mesher {

namespace {

/// The cosine between a face's normal and the way to a place that is above the face.
constexpr double kAbove = 0.9;

std::vector<FacetId> livingFacets(const SurfaceMesh& mesh)
{
    std::vector<FacetId> facets;
    for (std::uint32_t i = 0; i < mesh.facets.size(); ++i) {
        if (mesh.facets[FacetId(i)].isAlive()) facets.push_back(FacetId(i));
    }
    return facets;
}

std::array<Vec3, 3> cornersOf(const SurfaceMesh& mesh, FacetId facet)
{
    std::array<Vec3, 3> corners;
    for (std::size_t i = 0; i < 3; ++i) corners[i] = mesh.nodes[mesh.facets[facet].node[i]].position;
    return corners;
}

/// Of the facets, grown by their sags where there are some.
std::vector<Box3> boxesOf(const SurfaceMesh& mesh, const std::vector<FacetId>& facets,
                          const IdVector<FacetId, double>* sags)
{
    std::vector<Box3> boxes;
    boxes.reserve(facets.size());
    for (const FacetId facet : facets) {
        Box3 box;
        for (const Vec3& corner : cornersOf(mesh, facet)) box.include(corner);
        const double sag = sags == nullptr ? 0.0 : (*sags)[facet];
        box.low = box.low - Vec3{sag, sag, sag};
        box.high = box.high + Vec3{sag, sag, sag};
        boxes.push_back(box);
    }
    return boxes;
}

/// Whether the segment from a to b may meet the box.
bool mayMeet(const Vec3& a, const Vec3& b, const Box3& box)
{
    return std::max(a.x, b.x) >= box.low.x && std::min(a.x, b.x) <= box.high.x &&
           std::max(a.y, b.y) >= box.low.y && std::min(a.y, b.y) <= box.high.y &&
           std::max(a.z, b.z) >= box.low.z && std::min(a.z, b.z) <= box.high.z;
}

/// The share of the way from a to b at which the plane of the triangle is crossed.
double shareAtPlane(const Vec3& a, const Vec3& b, const std::array<Vec3, 3>& corner)
{
    const Vec3 normal = cross(corner[1] - corner[0], corner[2] - corner[0]);
    const double before = dot(a - corner[0], normal), after = dot(b - corner[0], normal);
    return before == after ? 0.5 : std::clamp(before / (before - after), 0.0, 1.0);
}

}  // namespace

ComponentSurface::ComponentSurface(const BrepModel& model, const SurfaceMesh& mesh, const RegionSides& sides)
    : model_(model),
      mesh_(mesh),
      sides_(sides),
      sag_(mesh.facets.size()),
      isFlush_(mesh.facets.size()),
      facets_(livingFacets(mesh)),
      tree_(boxesOf(mesh, facets_, nullptr)),
      faceTree_(std::span<const Box3>())
{
    for (const MeshNode& node : mesh.nodes) box_.include(node.position);
    const IdVector<FacetId, FacetDeparture> departures = facetDepartures(model, mesh);
    for (const FacetId facet : facets_) {
        sag_[facet] = departures[facet].distance;
        isFlush_[facet] = departures[facet].isFlush ? 1 : 0;
        largestSag_ = std::max(largestSag_, sag_[facet]);
    }
    faceTree_ = BoxTree(boxesOf(mesh, facets_, &sag_));
    corners_.reserve(facets_.size());
    for (const std::uint32_t item : tree_.order()) corners_.push_back(cornersOf(mesh, facets_[item]));
}

ComponentSurface::Nearest ComponentSurface::nearest(const Vec3& place) const
{
    Nearest best;
    double least = std::numeric_limits<double>::infinity(), steepest = -1.0;
    const auto look = [&](std::uint32_t item) {
        // Facets that meet at an edge or corner are equally near: the one that is seen most from above tells the side.
        constexpr double kSame = 1e-9;
        const std::array<Vec3, 3>& corner = corners_[item];
        const std::array<double, 3> w = closestWeights(place, corner);
        const double distance = length(place - (w[0] * corner[0] + w[1] * corner[1] + w[2] * corner[2]));
        if (distance > least * (1.0 + kSame)) return least * least * (1.0 + 4.0 * kSame);
        const Nearest foot = footOn(facets_[tree_.order()[item]], place);
        const Vec3 normal = cross(corner[1] - corner[0], corner[2] - corner[0]);
        const double size = length(normal);
        const double steepness = size > 0.0 ? std::abs(dot(normal, place - foot.place)) / size : 0.0;
        const bool isNearer = foot.distance < least * (1.0 - kSame);
        if (isNearer || (foot.distance <= least * (1.0 + kSame) && steepness > steepest)) {
            best = foot;
            least = std::min(least, foot.distance);
            steepest = steepness;
        }
        return least * least * (1.0 + 4.0 * kSame);
    };
    const auto bound = [&](std::uint32_t node) { return squaredDistance(place, tree_.nodes()[node].box); };
    tree_.searchSmallest(bound, look, std::numeric_limits<double>::infinity());
    return best;
}

ComponentSurface::Nearest ComponentSurface::footOn(FacetId facet, const Vec3& place) const
{
    const std::array<Vec3, 3> corner = cornersOf(mesh_, facet);
    const std::array<double, 3> w = closestWeights(place, corner);
    const Vec3 foot = w[0] * corner[0] + w[1] * corner[1] + w[2] * corner[2];
    const auto& uv = mesh_.facets[facet].parameters;
    return {facet, length(place - foot), foot, w[0] * uv[0] + w[1] * uv[1] + w[2] * uv[2]};
}

std::vector<ComponentSurface::Nearest> ComponentSurface::facesAbout(const Vec3& place, double tolerance,
                                                                    const Nearest& nearestFacet) const
{
    std::vector<Nearest> found = {nearestFacet};
    if (nearestFacet.distance > largestSag_ + tolerance) return found;
    std::vector<std::uint32_t> waiting = {0};
    while (!waiting.empty()) {
        const std::uint32_t index = waiting.back();
        waiting.pop_back();
        const BoxTree::Node& node = faceTree_.nodes()[index];
        if (squaredDistance(place, node.box) > tolerance * tolerance) continue;
        if (!node.isLeaf()) {
            waiting.push_back(index + 1);
            waiting.push_back(node.second);
            continue;
        }
        for (std::uint32_t i = node.begin; i < node.end; ++i) {
            const Nearest near = footOn(facets_[faceTree_.order()[i]], place);
            if (near.distance <= sag_[near.facet] + tolerance) found.push_back(near);
        }
    }
    const auto faceOf = [&](const Nearest& near) { return mesh_.facets[near.facet].face; };
    std::sort(found.begin(), found.end(), [&](const Nearest& a, const Nearest& b) {
        return std::tuple(faceOf(a), a.distance, a.facet) < std::tuple(faceOf(b), b.distance, b.facet);
    });
    const auto isSameFace = [&](const Nearest& a, const Nearest& b) { return faceOf(a) == faceOf(b); };
    found.erase(std::unique(found.begin(), found.end(), isSameFace), found.end());
    return found;
}

std::optional<SurfaceProjection> ComponentSurface::onFace(FacetId facet, const Vec3& place,
                                                          Vec2 parameters) const
{
    const BrepFace& face = model_.faces[mesh_.facets[facet].face];
    const SurfaceProjection exact = face.surface->project(place, parameters);
    // The kernel is slow where the boundary is near.
    if (!face.trim || isOnFacet(facet, exact.parameters)) return exact;
    if (face.trim->classify(exact.parameters) == TrimSide::Outside) return std::nullopt;
    return exact;
}

bool ComponentSurface::isOnFacet(FacetId facet, Vec2 parameters) const
{
    constexpr double kRounding = 1e-9;
    if (isFlush_[facet] == 0) return false;
    const auto& [a, b, c] = mesh_.facets[facet].parameters;
    const double area = cross(b - a, c - a);
    const double least = -kRounding * std::abs(area);
    const double sign = area < 0.0 ? -1.0 : 1.0;
    return area != 0.0 && sign * cross(b - a, parameters - a) >= least &&
           sign * cross(c - b, parameters - b) >= least && sign * cross(a - c, parameters - c) >= least;
}

BrepSolidId ComponentSurface::solidAt(BrepFaceId face, bool isInFront) const
{
    const RegionId region = sides_[face][isInFront ? 0 : 1];
    return region.value == 0 ? BrepSolidId() : BrepSolidId(region.value - 1);
}

ComponentSurface::Position ComponentSurface::positionOf(const Vec3& place, double tolerance) const
{
    using Kind = Position::Kind;
    const Nearest nearestFacet = nearest(place);
    if (!nearestFacet.facet.isValid()) return {};
    Position position;
    const auto decide = [&](BrepFaceId face, bool isInFront) {
        position.solid = solidAt(face, isInFront);
        position.kind = position.solid.isValid() ? Kind::Inside : Kind::Outside;
    };
    const std::vector<Nearest> about = facesAbout(place, tolerance, nearestFacet);
    // Beyond what facets cut off, the facets themselves tell the side.
    if (about.size() == 1 && nearestFacet.distance > sag_[nearestFacet.facet] + tolerance) {
        const std::array<Vec3, 3> corner = cornersOf(mesh_, nearestFacet.facet);
        const Vec3 normal = cross(corner[1] - corner[0], corner[2] - corner[0]);
        decide(mesh_.facets[nearestFacet.facet].face, dot(place - nearestFacet.place, normal) > 0.0);
        position.depth = nearestFacet.distance;
        if (position.kind == Kind::Outside) position.clearance = nearestFacet.distance;
        return position;
    }
    // Nearer, any of their faces may be the one at the place.
    double least = std::numeric_limits<double>::infinity();
    for (const Nearest& near : about) {
        const std::optional<SurfaceProjection> exact = onFace(near.facet, place, near.parameters);
        if (!exact) continue;
        const BrepFaceId face = mesh_.facets[near.facet].face;
        const Vec3 normal = model_.faces[face].surface->evaluate(exact->parameters).normal();
        const double size = length(normal);
        if (exact->distance <= tolerance)
            position.touched.push_back({face, size > 0.0 ? (1.0 / size) * normal : Vec3{}});
        // Off the rim of a face the face does not tell the side.
        const double height = std::abs(dot(place - exact->position, normal));
        if (exact->distance >= least || height < kAbove * exact->distance * size) continue;
        least = position.depth = exact->distance;
        decide(face, dot(place - exact->position, normal) > 0.0);
    }
    if (position.touched.empty()) return position;
    const BrepFaceId face = position.touched.front().face;
    position.solid = solidAt(face, true).isValid() ? solidAt(face, true) : solidAt(face, false);
    position.kind = Kind::Touching;
    return position;
}

std::vector<double> ComponentSurface::crossings(const Vec3& a, const Vec3& b) const
{
    std::vector<double> shares;
    std::vector<std::uint32_t> waiting = {0};
    while (!waiting.empty() && !tree_.nodes().empty()) {
        const std::uint32_t index = waiting.back();
        waiting.pop_back();
        const BoxTree::Node& node = tree_.nodes()[index];
        if (!mayMeet(a, b, node.box)) continue;
        if (!node.isLeaf()) {
            waiting.push_back(index + 1);
            waiting.push_back(node.second);
            continue;
        }
        for (std::uint32_t i = node.begin; i < node.end; ++i) {
            const std::array<Vec3, 3> corner = cornersOf(mesh_, facets_[tree_.order()[i]]);
            if (doesSegmentMeetTriangle(a, b, corner)) shares.push_back(shareAtPlane(a, b, corner));
        }
    }
    std::sort(shares.begin(), shares.end());
    return shares;
}

}  // namespace mesher
