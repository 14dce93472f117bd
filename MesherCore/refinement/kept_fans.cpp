#include "refinement/kept_fans.h"

#include "base/indexed_map.h"

#include <algorithm>
#include <cmath>

namespace mesher {

namespace {

// Of the ring's side, which a vertex keeps from the plane of the ring: tetrahedra on three neighbours of six have 25 degrees then.
constexpr double kLeastHeight = 0.4;
// Of half the angle at the tip: fans that are wider have flat angles with the plane of their ring.
constexpr double kLeastCosine = 0.5;

/// What the ball around one fan is made of.
struct Fan
{
    Vec3 tip;
    Vec3 sumOfRing;
    double sumOfSides = 0.0;
    double sumOfSpokes = 0.0;
    double facets = 0.0;
    std::vector<VertexId> ring;
};

}  // namespace

KeptFans::KeptFans(const ConstrainedTetrahedralization& t, const SurfaceSplitter& splitter)
{
    const SurfaceMesh& surface = splitter.mesh();
    IndexedMap<NodeId, std::uint32_t> fanOf;
    std::vector<Fan> fans;
    for (std::uint32_t i = 0; i < surface.facets.size(); ++i) {
        const SurfaceFacet& facet = surface.facets[FacetId(i)];
        if (!facet.isAlive() || !splitter.isHeld(FacetId(i))) continue;
        std::size_t k = 0;
        while (k < 2 && surface.nodes[facet.node[k]].entity.dimension != 0) ++k;
        const VertexId tip = t.vertexOf[facet.node[k]];
        const VertexId a = t.vertexOf[facet.node[(k + 1) % 3]], b = t.vertexOf[facet.node[(k + 2) % 3]];
        const auto next = static_cast<std::uint32_t>(fans.size());
        const std::uint32_t at = *fanOf.insert(facet.node[k], next).first;
        if (at == next) fans.push_back({t.mesh().position(tip), {}, 0.0, 0.0, 0.0, {}});
        Fan& fan = fans[at];
        const Vec3 &pa = t.mesh().position(a), &pb = t.mesh().position(b);
        fan.sumOfRing = fan.sumOfRing + 0.5 * (pa - fan.tip) + 0.5 * (pb - fan.tip);
        fan.sumOfSides += length(pb - pa);
        fan.sumOfSpokes += 0.5 * (length(pa - fan.tip) + length(pb - fan.tip));
        fan.facets += 1.0;
        fan.ring.push_back(a);
        fan.ring.push_back(b);
    }
    for (const Fan& fan : fans) {
        const double depth = length(fan.sumOfRing) / fan.facets;
        const double cosine = depth * fan.facets / fan.sumOfSpokes;
        if (cosine < kLeastCosine) continue;
        const double radius = depth + kLeastHeight * fan.sumOfSides / fan.facets;
        for (const VertexId v : fan.ring) {
            if (ballOf_.size() <= v.value) ballOf_.resize(v.value + 1u, kNone);
            ballOf_[v] = static_cast<std::uint32_t>(balls_.size());
        }
        const Vec3 centre = fan.tip + (1.0 / fan.facets) * fan.sumOfRing;
        balls_.push_back({fan.tip, centre, radius * radius, cosine, false});
    }
}

std::optional<std::uint32_t> KeptFans::crowdedBy(const Vec3& point, std::span<const VertexId> beside) const
{
    for (const VertexId v : beside) {
        if (v.value >= ballOf_.size() || ballOf_[v] == kNone) continue;
        const Ball& ball = balls_[ballOf_[v]];
        const Vec3 away = point - ball.tip, axis = ball.centre - ball.tip;
        if (!(squaredLength(away) < ball.squaredRadius)) continue;
        if (dot(away, axis) >= ball.leastCosine * length(away) * length(axis)) return ballOf_[v];
    }
    return {};
}

std::optional<std::uint32_t> KeptFans::withRingThrough(std::span<const VertexId> vertices) const
{
    const auto ballAt = [&](VertexId v) { return v.value < ballOf_.size() ? ballOf_[v] : kNone; };
    const std::uint32_t ball = ballAt(vertices.front());
    const bool isOne = ball != kNone && std::all_of(vertices.begin(), vertices.end(),
                                                    [&](VertexId v) { return ballAt(v) == ball; });
    return isOne ? std::optional<std::uint32_t>(ball) : std::nullopt;
}

std::optional<Vec3> KeptFans::freeCentre(std::uint32_t fan) const
{
    return balls_[fan].isTaken ? std::nullopt : std::optional<Vec3>(balls_[fan].centre);
}

}  // namespace mesher
