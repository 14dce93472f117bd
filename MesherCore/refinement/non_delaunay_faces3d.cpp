#include "refinement/non_delaunay_faces3d.h"

#include "predicates/orient3d.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <utility>

namespace mesher {

namespace {

using Entities = std::array<EntityRef, 2>;

class Explainer
{
public:
    Explainer(RefinementState3d& state, bool isFinished) : state_(state), isFinished_(isFinished) {}

    [[nodiscard]] NonDelaunayFaces3d explain(TetFace face)
    {
        NonDelaunayFaces3d found;
        found.count = 1;
        found.place = placeOf(face);
        if (!isFinished_) return found;
        if (const auto entities = boundaryThatBlocks(face)) found.entity = *entities;
        if (isTie(face))
            found.reason = NonDelaunayReason3d::Tie;
        else if (found.entity[0].index != EntityRef::kNone)
            found.reason = NonDelaunayReason3d::Boundary;
        else
            found.reason = NonDelaunayReason3d::Interlocked;
        return found;
    }

private:
    /// Of the radius: how far a vertex is inside of a sphere that rounding alone may put there.
    static constexpr double kRounding = 1e-9;

    [[nodiscard]] Vec3 placeOf(TetFace face) const
    {
        Vec3 middle;
        for (const VertexId v : state_.mesh.faceVertices(face)) middle = middle + state_.mesh.position(v);
        return (1.0 / (3.0 * state_.t.scale)) * middle;
    }

    [[nodiscard]] bool isTie(TetFace face) const
    {
        const std::optional<Vec3> centre = state_.criteria.circumcentre(face.tet());
        if (!centre) return false;
        const TetFace other = state_.mesh.neighbour(face);
        const double radius = length(state_.mesh.position(state_.mesh.vertex(face.tet(), 0)) - *centre);
        const double distance =
            length(state_.mesh.position(state_.mesh.vertex(other.tet(), other.face())) - *centre);
        return radius - distance <= kRounding * radius;
    }

    /// What is at an edge that would have to be flipped since the two tetrahedra bend there, or are in one plane.
    [[nodiscard]] std::optional<Entities> boundaryThatBlocks(TetFace face)
    {
        const Triangulation3d& mesh = state_.mesh;
        const TetFace other = mesh.neighbour(face);
        const VertexId above = mesh.vertex(face.tet(), face.face());
        const VertexId below = mesh.vertex(other.tet(), other.face());
        const auto corner = mesh.faceVertices(face);
        for (unsigned k = 0; k < 3; ++k) {
            const VertexId a = corner[k];
            const VertexId b = corner[(k + 1) % 3];
            const bool isConvex = orient3d(mesh.position(a), mesh.position(b), mesh.position(below),
                                           mesh.position(above)) == Sign::Positive;
            if (isConvex) continue;
            if (const auto entities = boundaryAt(a, b)) return entities;
        }
        return {};
    }

    [[nodiscard]] std::optional<Entities> boundaryAt(VertexId a, VertexId b)
    {
        if (const SegmentId* segment = state_.segmentAt(a, b)) return Entities{state_.entityOf(*segment)};
        const Triangulation3d& mesh = state_.mesh;
        mesh.collectEdgeRing(mesh.findEdge(a, b), a, b, ring_);
        Entities found;
        std::size_t count = 0;
        for (const TetId tet : ring_) {
            for (const VertexId end : mesh.tet(tet).vertex) {
                const TetFace side(tet, mesh.slotOf(tet, end));
                if (end == a || end == b || !mesh.isFaceConstrained(side)) continue;
                const FacetId* facet = state_.facetAt(side);
                if (facet == nullptr || count == found.size()) continue;
                const EntityRef entity = state_.entityOf(*facet);
                if (count == 0 || !(found[0] == entity)) found[count++] = entity;
            }
        }
        if (count == 0) return {};
        if (count == 2 && found[1] < found[0]) std::swap(found[0], found[1]);
        return found;
    }

    RefinementState3d& state_;
    bool isFinished_;
    std::vector<TetId> ring_;
};

}  // namespace

std::vector<NonDelaunayFaces3d> explainNonDelaunayFaces(RefinementState3d& state, bool isFinished)
{
    Explainer explainer(state, isFinished);
    std::map<std::pair<NonDelaunayReason3d, Entities>, NonDelaunayFaces3d> groups;
    for (std::uint32_t i = 0; i < state.mesh.tetLimit(); ++i) {
        if (!state.isMeshed(TetId(i))) continue;
        for (int f = 0; f < 4; ++f) {
            const TetFace face(TetId(i), f);
            if (state.mesh.neighbour(face).tet() < face.tet() || !state.flips.isNotDelaunay(face)) continue;
            const NonDelaunayFaces3d found = explainer.explain(face);
            const auto [group, isNew] = groups.emplace(std::pair(found.reason, found.entity), found);
            if (!isNew) ++group->second.count;
        }
    }
    std::vector<NonDelaunayFaces3d> sorted;
    for (const auto& [key, group] : groups) sorted.push_back(group);
    std::stable_sort(sorted.begin(), sorted.end(),
                     [](const auto& a, const auto& b) { return a.count > b.count; });
    return sorted;
}

}  // namespace mesher
