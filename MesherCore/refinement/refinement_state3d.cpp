#include "refinement/refinement_state3d.h"

#include <algorithm>

namespace mesher {

const FacetId* RefinementState3d::facetAt(TetFace face) const
{
    std::array<VertexId, 3> corners = mesh.faceVertices(face);
    std::sort(corners.begin(), corners.end());
    return t.facetOf.find(corners);
}

std::optional<SmallInputAngle> RefinementState3d::smallAngleNear(TetId tet) const
{
    constexpr double kReach = 2.0;  // in length scales
    Vec3 centroid;
    double near = 0.0;
    for (const VertexId v : mesh.tet(tet).vertex) {
        centroid = centroid + 0.25 * mesh.position(v);
        near += 0.25 * scale.guard(v);
    }
    return guard.blameFor((1.0 / t.scale) * centroid, kReach * near / t.scale);
}

void RefinementState3d::addOutside(VertexId v)
{
    if (t.nodeOf.size() <= v.value) t.nodeOf.resize(v.value + v.value / 4u + 16u);
    t.nodeOf[v] = NodeId();
    scale.leaveOut(v);
    walls.assign(v, {}, kExteriorRegion);
}

double RefinementState3d::smallAngleBeside(std::span<const VertexId> entity) const
{
    double least = 180.0;
    if (!guard.hasAny()) return least;
    for (const VertexId v : entity) {
        const NodeId node = t.nodeOf[v];
        if (node.isValid()) least = std::min(least, guard.degreesAt(splitter.mesh().nodes[node].entity));
    }
    return least;
}

const std::vector<TetId>& RefinementState3d::flipAround(std::span<const TetId> created)
{
    flips.clearCreated();
    flips.push(created);
    flips.flip(flipBudget);
    return flips.created();
}

}  // namespace mesher
