#include "pipeline/solid_contacts.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

namespace mesher {

namespace {

using Kind = ComponentSurface::Position::Kind;

/// Parts that are pressed into one another by less than this many tolerances touch.
constexpr double kDeep = 100.0;

bool isNear(const Vec3& p, const Box3& box, double distance)
{
    const Vec3 margin{distance, distance, distance};
    return Box3{box.low - margin, box.high + margin}.contains(p);
}

/// A place of a facet, with the exact point of its face there.
struct Sample
{
    FacetId facet;
    Vec3 place;
    Vec3 normal;  ///< du x dv, of length 1; zero where there is none
    bool isInsideFace = false;
};

/// Looks for places of one group's surface on or in the solids of the other.
class ContactSearch
{
public:
    ContactSearch(const ComponentSurface& own, const ComponentSurface& other, double tolerance,
                  RunContext& context)
        : own_(own),
          other_(other),
          tolerance_(tolerance),
          context_(context),
          clearance_(own.mesh().nodes.size()),
          known_(own.mesh().nodes.size())
    {
    }

    /// Ends at the first overlap; a contact is kept meanwhile.
    std::optional<SolidContact> search()
    {
        const SurfaceMesh& mesh = own_.mesh();
        for (std::uint32_t i = 0; i < mesh.facets.size() && !isOverlapFound(); ++i) {
            const FacetId facet(i);
            if (!mesh.facets[facet].isAlive() || !mayMeet(facet)) continue;
            if (!context_.mayGoOn()) break;
            lookAt(facet);
        }
        return found_;
    }

private:
    [[nodiscard]] bool isOverlapFound() const { return found_ && found_->isOverlap; }

    [[nodiscard]] bool mayMeet(FacetId facet) const
    {
        Box3 box;
        double longest = 0.0;
        for (const NodeId node : own_.mesh().facets[facet].node)
            box.include(own_.mesh().nodes[node].position);
        longest = length(box.extent());
        const Box3& that = other_.box();
        const double margin = tolerance_ + longest;
        return box.low.x <= that.high.x + margin && that.low.x <= box.high.x + margin &&
               box.low.y <= that.high.y + margin && that.low.y <= box.high.y + margin &&
               box.low.z <= that.high.z + margin && that.low.z <= box.high.z + margin;
    }

    void lookAt(FacetId facet)
    {
        const SurfaceFacet& f = own_.mesh().facets[facet];
        const auto at = [&](std::size_t i) { return own_.mesh().nodes[f.node[i]].position; };
        for (std::size_t i = 0; i < 3; ++i) tryNode(facet, i);
        if (liesOnFace(f)) return;
        const Vec3 middle = (1.0 / 3.0) * (at(0) + at(1) + at(2));
        // The exact point is off the middle by less than facets depart from faces.
        if (clearanceAt(facet, middle) <= reach(facet) + own_.sagOf(facet))
            tryExact(facet, middle, (1.0 / 3.0) * (f.parameters[0] + f.parameters[1] + f.parameters[2]),
                     true);
        for (std::size_t i = 0; i < 3; ++i) {
            const std::size_t j = (i + 1) % 3;
            if (isOfOtherFacet(f.node[i], f.node[j]) || touchOneFace(std::array{f.node[i], f.node[j]}))
                continue;
            if (clearance_[f.node[i]] > length(at(j) - at(i))) continue;
            const std::vector<double> shares = other_.crossings(at(i), at(j));
            for (std::size_t k = 1; k < shares.size(); ++k) {
                const double t = 0.5 * (shares[k - 1] + shares[k]);
                tryExact(facet, (1.0 - t) * at(i) + t * at(j),
                         (1.0 - t) * f.parameters[i] + t * f.parameters[j], false);
            }
        }
    }

    /// Of the two facets of a face at an edge inside of it, the one that runs along it from the smaller number asks.
    [[nodiscard]] bool isOfOtherFacet(NodeId from, NodeId to) const
    {
        return to < from && (isInsideFace(from) || isInsideFace(to));
    }
    [[nodiscard]] bool isInsideFace(NodeId node) const
    {
        return own_.mesh().nodes[node].entity.dimension == 2;
    }

    /// Whether the corners of a facet lie on one face of the other group, and one of them, inside of its own face, has told on
    /// which side the solids are: between them is nothing that they do not tell.
    [[nodiscard]] bool liesOnFace(const SurfaceFacet& facet) const
    {
        return std::any_of(facet.node.begin(), facet.node.end(),
                           [&](NodeId node) { return isInsideFace(node); }) &&
               touchOneFace(facet.node);
    }
    [[nodiscard]] bool touchOneFace(std::span<const NodeId> nodes) const
    {
        const auto touches = [&](NodeId node, BrepFaceId face) {
            if (!known_[node]) return false;
            const auto& touched = known_[node]->touched;
            return std::any_of(touched.begin(), touched.end(),
                               [&](const ComponentSurface::Touch& touch) { return touch.face == face; });
        };
        if (!known_[nodes[0]]) return false;
        const auto& candidates = known_[nodes[0]]->touched;
        return std::any_of(candidates.begin(), candidates.end(), [&](const ComponentSurface::Touch& touch) {
            return std::all_of(nodes.begin(), nodes.end(),
                               [&](NodeId node) { return touches(node, touch.face); });
        });
    }

    /// A corner; what is known of it from another facet, or from a corner beside, is not asked again.
    void tryNode(FacetId facet, std::size_t corner)
    {
        const SurfaceFacet& f = own_.mesh().facets[facet];
        const NodeId node = f.node[corner];
        const Vec3& place = own_.mesh().nodes[node].position;
        clearance_[node] = std::max(clearance_[node], clearanceAt(facet, place));
        if (clearance_[node] > reach(facet)) return;
        const bool isInside = isInsideFace(node);
        const Vec3 normal = isInside ? unitNormal(facet, f.parameters[corner]) : Vec3{};
        tryPlace({facet, place, normal, isInside}, f.parameters[corner], node);
    }

    /// About a corner of known clearance a ball is free of the other surface, and so is a smaller one about a place in it.
    [[nodiscard]] double clearanceAt(FacetId facet, const Vec3& place) const
    {
        double clearance = 0.0;
        for (const NodeId node : own_.mesh().facets[facet].node) {
            if (clearance_[node] == 0.0) continue;
            const double distance = length(place - own_.mesh().nodes[node].position);
            clearance = std::max(clearance, clearance_[node] - distance);
        }
        return clearance;
    }

    /// Farther off, nothing of the other group can matter to a place of the facet.
    [[nodiscard]] double reach(FacetId facet) const
    {
        return tolerance_ + nearness(facet) + other_.largestSag();
    }

    void tryExact(FacetId facet, const Vec3& place, Vec2 parameters, bool isInsideFace)
    {
        const std::optional<SurfaceProjection> exact = own_.onFace(facet, place, parameters);
        if (!exact) return;
        tryPlace({facet, exact->position, unitNormal(facet, exact->parameters), isInsideFace},
                 exact->parameters);
    }

    [[nodiscard]] Vec3 unitNormal(FacetId facet, Vec2 parameters) const
    {
        const Surface& surface = *own_.model().faces[own_.mesh().facets[facet].face].surface;
        const Vec3 normal = surface.evaluate(parameters).normal();
        const double size = length(normal);
        return size > 0.0 ? (1.0 / size) * normal : Vec3{};
    }

    void tryPlace(const Sample& sample, Vec2 parameters, NodeId node = NodeId())
    {
        if (isOverlapFound() || !isNear(sample.place, other_.box(), tolerance_ + nearness(sample.facet)))
            return;
        const ComponentSurface::Position position = positionOf(sample.place, node);
        if (position.kind == Kind::Inside) {
            keep(sample, position, position.depth > kDeep * tolerance_);
        } else if (position.kind == Kind::Touching) {
            keep(sample, position, isOnSameSide(sample, position));
        } else if (!found_) {
            approach(sample, parameters);
        }
    }

    ComponentSurface::Position positionOf(const Vec3& place, NodeId node)
    {
        if (!node.isValid()) return other_.positionOf(place, tolerance_);
        std::optional<ComponentSurface::Position>& known = known_[node];
        if (!known) known = other_.positionOf(place, tolerance_);
        clearance_[node] = std::max(clearance_[node], known->clearance);
        return *known;
    }

    /// Facets depart from faces by this: so near, surfaces may touch where their facets do not.
    [[nodiscard]] double nearness(FacetId facet) const { return own_.sagOf(facet); }

    /// Leads a place from surface to surface, to where they are nearest.
    void approach(const Sample& sample, Vec2 parameters)
    {
        constexpr int kMostSteps = 60;
        const ComponentSurface::Nearest near = other_.nearest(sample.place);
        if (near.distance > nearness(sample.facet) + other_.sagOf(near.facet) + tolerance_) return;
        SurfaceProjection own{parameters, sample.place, 0.0};
        SurfaceProjection other{near.parameters, near.place, near.distance};
        for (int step = 0; step < kMostSteps; ++step) {
            const auto there = other_.onFace(near.facet, own.position, other.parameters);
            if (!there) return;
            other = *there;
            const auto back = own_.onFace(sample.facet, other.position, own.parameters);
            if (!back) return;
            own = *back;
            if (own.distance > tolerance_) continue;
            const ComponentSurface::Position position = other_.positionOf(own.position, tolerance_);
            if (position.kind == Kind::Touching)
                keep({sample.facet, own.position, {}, false}, position, false);
            return;
        }
    }

    /// Whether both have material on one side of the faces that coincide there.
    [[nodiscard]] bool isOnSameSide(const Sample& sample, const ComponentSurface::Position& position) const
    {
        constexpr double kParallel = 0.999;
        if (!sample.isInsideFace) return false;
        const auto& own = own_.sides()[own_.mesh().facets[sample.facet].face];
        const auto areFilled = [](RegionId a, RegionId b) { return a.value != 0 && b.value != 0; };
        for (const ComponentSurface::Touch& touch : position.touched) {
            const double cosine = dot(sample.normal, touch.normal);
            if (std::abs(cosine) < kParallel) continue;
            const auto& that = other_.sides()[touch.face];
            const std::size_t front = cosine > 0.0 ? 0 : 1;
            if (areFilled(own[0], that[front]) || areFilled(own[1], that[1 - front])) return true;
        }
        return false;
    }

    void keep(const Sample& sample, const ComponentSurface::Position& position, bool isOverlap)
    {
        if (found_ && !isOverlap) return;
        const auto& sides = own_.sides()[own_.mesh().facets[sample.facet].face];
        const RegionId region = sides[0].value != 0 ? sides[0] : sides[1];
        found_ = SolidContact{BrepSolidId(region.value - 1), position.solid, sample.place, isOverlap};
    }

    const ComponentSurface& own_;
    const ComponentSurface& other_;
    double tolerance_;
    RunContext& context_;
    IdVector<NodeId, double> clearance_;  ///< no facet of the other group is nearer to the node; 0: not known
    IdVector<NodeId, std::optional<ComponentSurface::Position>> known_;
    std::optional<SolidContact> found_;
};

}  // namespace

std::optional<SolidContact> findContact(const ComponentSurface& first, const ComponentSurface& second,
                                        double tolerance, RunContext& context)
{
    const std::optional<SolidContact> found = ContactSearch(first, second, tolerance, context).search();
    if (found && found->isOverlap) return found;
    std::optional<SolidContact> reverse = ContactSearch(second, first, tolerance, context).search();
    if (reverse) std::swap(reverse->first, reverse->second);
    if (reverse && (reverse->isOverlap || !found)) return reverse;
    return found;
}

}  // namespace mesher
