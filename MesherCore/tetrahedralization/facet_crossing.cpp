#include "tetrahedralization/facet_crossing.h"

#include "predicates/orient2d.h"
#include "predicates/orient3d.h"

#include <algorithm>

namespace mesher {

namespace {

/// Whether p lies in the closed triangle, whose plane it is in, as seen along one axis; nothing if the triangle is seen
/// edge on.
enum class PlanarSide
{
    Inside,
    Outside,
    EdgeOn
};

PlanarSide planarSide(Vec2 a, Vec2 b, Vec2 c, Vec2 p)
{
    const Sign turn = orient2d(a, b, c);
    if (turn == Sign::Zero) return PlanarSide::EdgeOn;
    const bool isOutside =
        orient2d(a, b, p) == -turn || orient2d(b, c, p) == -turn || orient2d(c, a, p) == -turn;
    return isOutside ? PlanarSide::Outside : PlanarSide::Inside;
}

}  // namespace

Sign FacetCrossings::sideOf(VertexId vertex) const
{
    return orient3d(mesh_.position(facet_[0]), mesh_.position(facet_[1]), mesh_.position(facet_[2]),
                    mesh_.position(vertex));
}

bool FacetCrossings::isInside(VertexId coplanar) const
{
    const Vec3& a = mesh_.position(facet_[0]);
    const Vec3& b = mesh_.position(facet_[1]);
    const Vec3& c = mesh_.position(facet_[2]);
    const Vec3& p = mesh_.position(coplanar);
    PlanarSide side = planarSide({a.x, a.y}, {b.x, b.y}, {c.x, c.y}, {p.x, p.y});
    if (side == PlanarSide::EdgeOn) side = planarSide({a.y, a.z}, {b.y, b.z}, {c.y, c.z}, {p.y, p.z});
    if (side == PlanarSide::EdgeOn) side = planarSide({a.x, a.z}, {b.x, b.z}, {c.x, c.z}, {p.x, p.z});
    return side == PlanarSide::Inside;
}

bool FacetCrossings::isPierced(VertexId low, VertexId high) const
{
    const Vec3& p = mesh_.position(low);
    const Vec3& q = mesh_.position(high);
    for (unsigned k = 0; k < 3; ++k) {
        const Vec3& a = mesh_.position(facet_[k]);
        const Vec3& b = mesh_.position(facet_[(k + 1) % 3]);
        // From below the triangle turns clockwise.
        if (orient3d(p, q, a, b) != Sign::Positive) return false;
    }
    return true;
}

/// Lists the pierced edges of a tetrahedron; false if a vertex of it lies on the triangle.
bool FacetCrossings::visit(TetId tet, FacetCrossing& crossing)
{
    if (!visited_.insert(tet.value) || mesh_.isGhostTet(tet)) return true;
    const auto& vertices = mesh_.tet(tet).vertex;
    Sign side[4];
    for (unsigned i = 0; i < 4; ++i) {
        const bool isCorner = std::find(facet_.begin(), facet_.end(), vertices[i]) != facet_.end();
        side[i] = isCorner ? Sign::Zero : sideOf(vertices[i]);
        if (!isCorner && side[i] == Sign::Zero && isInside(vertices[i])) {
            crossing.touching = vertices[i];
            return false;
        }
    }
    bool isCrossed = false;
    for (const auto& slots : kEdgeSlots) {
        const auto i = static_cast<unsigned>(slots[0]);
        const auto j = static_cast<unsigned>(slots[1]);
        if (side[i] == Sign::Zero || side[i] * side[j] != Sign::Negative) continue;
        const VertexId low = side[i] == Sign::Negative ? vertices[i] : vertices[j];
        const VertexId high = side[i] == Sign::Negative ? vertices[j] : vertices[i];
        if (!isPierced(low, high)) continue;
        isCrossed = true;
        const std::array<VertexId, 2> edge{low, high};
        if (std::find(crossing.edges.begin(), crossing.edges.end(), edge) == crossing.edges.end())
            crossing.edges.push_back(edge);
    }
    if (isCrossed) crossing.tets.push_back(tet);
    return true;
}

void FacetCrossings::find(const std::array<VertexId, 3>& facet, FacetCrossing& crossing)
{
    facet_ = facet;
    visited_ = IdSet();
    crossing.edges.clear();
    crossing.tets.clear();
    crossing.touching = VertexId();
    const TetId start = mesh_.findEdge(facet[0], facet[1]);
    MESHER_PRECONDITION(start.isValid());
    mesh_.collectEdgeRing(start, facet[0], facet[1], ring_);
    for (const TetId tet : ring_) {
        if (mesh_.slotOf(tet, facet[2]) >= 0) return;
    }
    for (const TetId tet : ring_) {
        if (!visit(tet, crossing)) return;
    }
    for (std::size_t next = 0; next < crossing.edges.size(); ++next) {
        const auto [low, high] = crossing.edges[next];
        const auto known = std::find_if(crossing.tets.begin(), crossing.tets.end(), [&](TetId tet) {
            return mesh_.slotOf(tet, low) >= 0 && mesh_.slotOf(tet, high) >= 0;
        });
        mesh_.collectEdgeRing(*known, low, high, ring_);
        for (const TetId tet : ring_) {
            if (!visit(tet, crossing)) return;
        }
    }
}

}  // namespace mesher
