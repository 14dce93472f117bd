#include "refinement/left_tets3d.h"

#include "refinement/encroachment3d.h"
#include "refinement/insert_circumcentre.h"

#include <algorithm>
#include <optional>

namespace mesher {

namespace {

EntityRef boundaryInTheWay(RefinementState3d& state, TetId tet)
{
    const std::optional<Vec3> centre = state.criteria.circumcentre(tet);
    if (!centre) return {};
    Delaunay3d& delaunay = *state.t.delaunay;
    const Encroached3d encroached = findInTheWay(delaunay, tet, onGrid(*centre));
    if (encroached.segment[0].isValid()) {
        const SegmentId* segment = state.segmentAt(encroached.segment[0], encroached.segment[1]);
        if (segment != nullptr) return {1, state.splitter.mesh().segments[*segment].edge.value};
    }
    TetFace face = encroached.facet;
    if (!face.isValid()) face = firstConstraintTowards(state.mesh, tet, onGrid(*centre), delaunay.filter());
    if (!face.isValid()) return {};
    const FacetId* facet = state.facetAt(face);
    return facet == nullptr ? EntityRef{} : EntityRef{2, state.splitter.mesh().facets[*facet].face.value};
}

/// The vertex, edge or face that a corner is on, the lowest; else the solid.
EntityRef entityBeside(const RefinementState3d& state, TetId tet)
{
    EntityRef found{3, state.mesh.region(tet).value - 1};
    for (const VertexId v : state.mesh.tet(tet).vertex) {
        const NodeId node = v.value < state.t.nodeOf.size() ? state.t.nodeOf[v] : NodeId();
        if (node.isValid()) found = std::min(found, state.splitter.mesh().nodes[node].entity);
    }
    return found;
}

LeftTet3d explain(RefinementState3d& state, TetId tet, const TetVerdict& verdict, bool isStopped,
                  std::span<const WorkLedger3d::Entry> costliest)
{
    LeftTet3d left;
    left.tet = tet;
    if (isStopped) return left;
    if (const ThinWall* wall = state.walls.wallBeside(tet)) {
        left.reason = LeftReason3d::ThinWall;
        left.entity = {2, wall->face[0].value};
        left.other = {2, wall->face[1].value};
        return left;
    }
    if (const std::optional<BrepFaceId> face = state.strips.faceBeside(tet)) {
        left.reason = LeftReason3d::NarrowFace;
        left.entity = {2, face->value};
        return left;
    }
    left.angle = state.smallAngleNear(tet);
    if (left.angle) {
        left.reason = LeftReason3d::SmallInputAngle;
    } else if (verdict.need == TetNeed::HeldBack) {
        left.reason = LeftReason3d::LengthScale;
        left.entity = entityBeside(state, tet);
    } else if (!costliest.empty()) {
        left.reason = LeftReason3d::NoHeadway;
        left.entity = costliest[0].entity;
        if (costliest.size() > 1) left.other = costliest[1].entity;
    } else {
        left.entity = boundaryInTheWay(state, tet);
        left.reason =
            left.entity.index != EntityRef::kNone ? LeftReason3d::Boundary : LeftReason3d::Resolution;
        if (left.reason == LeftReason3d::Resolution) left.entity = entityBeside(state, tet);
    }
    return left;
}

}  // namespace

std::vector<LeftTet3d> collectLeftTets(RefinementState3d& state, bool isStopped,
                                       std::span<const WorkLedger3d::Entry> costliest)
{
    std::vector<LeftTet3d> left;
    state.guard.collectPlaces(state.splitter.mesh());
    for (std::uint32_t i = 0; i < state.mesh.tetLimit(); ++i) {
        const TetId tet(i);
        if (!state.isMeshed(tet)) continue;
        const TetVerdict verdict = state.judge(tet);
        if (verdict.need == TetNeed::Nothing && !(state.isLeftFlat(tet) && state.criteria.isBad(tet)))
            continue;
        left.push_back(explain(state, tet, verdict, isStopped, costliest));
    }
    return left;
}

}  // namespace mesher
