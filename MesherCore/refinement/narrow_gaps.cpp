#include "refinement/narrow_gaps.h"

#include <algorithm>
#include <cmath>

namespace mesher {

NarrowGaps::NarrowGaps(const ConstrainedTetrahedralization& tetrahedralization, const SurfaceMesh& surface,
                       double leastGap)
    : t_(tetrahedralization), surface_(surface), leastGap_(leastGap * tetrahedralization.scale)
{
}

bool NarrowGaps::isBeside(SegmentId segment)
{
    if (!(leastGap_ > 0.0)) return false;
    const auto& ends = surface_.segments[segment].node;
    const VertexId a = t_.vertexOf[ends[0]], b = t_.vertexOf[ends[1]];
    const Triangulation3d& mesh = t_.mesh();
    const TetId at = mesh.findEdge(a, b);
    if (!at.isValid()) return false;
    Nearest nearest{{}, mesh.position(a), leastGap_ * leastGap_};
    mesh.collectEdgeRing(at, a, b, ring_);
    for (const TetId tet : ring_) {
        if (mesh.isGhostTet(tet) || mesh.region(tet) == kExteriorRegion) continue;
        std::array<VertexId, 2> across;
        std::size_t count = 0;
        for (const VertexId v : mesh.tet(tet).vertex) {
            if (v == a || v == b) continue;
            includeVertex(v, mesh.position(a), mesh.position(b), nearest);
            across[count++] = v;
        }
        includeSegment(across, 0.5 * (mesh.position(a) + mesh.position(b)), nearest);
    }
    if (nearest.entity.index == EntityRef::kNone) return false;
    const double unit = 1.0 / t_.scale;
    keep({{1, surface_.segments[segment].edge.value},
          nearest.entity,
          unit * std::sqrt(nearest.squaredGap),
          unit * nearest.place});
    return true;
}

bool NarrowGaps::isInside(const std::array<VertexId, 3>& facet) const
{
    if (!(leastGap_ > 0.0)) return false;
    const Triangulation3d& mesh = t_.mesh();
    std::array<Vec3, 3> side;
    double longest = 0.0;
    for (unsigned k = 0; k < 3; ++k) {
        side[k] = mesh.position(facet[(k + 1) % 3]) - mesh.position(facet[k]);
        longest = std::max(longest, length(side[k]));
    }
    return length(cross(side[0], side[1])) < leastGap_ * longest;
}

/// A vertex of the surface that is beside the segment from a to b, and not beyond one of its ends.
void NarrowGaps::includeVertex(VertexId v, const Vec3& a, const Vec3& b, Nearest& nearest) const
{
    if (!t_.nodeOf[v].isValid()) return;
    const Vec3& p = t_.mesh().position(v);
    const double share = dot(p - a, b - a) / squaredLength(b - a);
    if (!(share > 0.0 && share < 1.0)) return;
    const double squaredGap = squaredLength(p - a - share * (b - a));
    if (squaredGap < nearest.squaredGap) nearest = {surface_.nodes[t_.nodeOf[v]].entity, p, squaredGap};
}

/// Beside long segments there need not be a vertex.
void NarrowGaps::includeSegment(const std::array<VertexId, 2>& ends, const Vec3& middle,
                                Nearest& nearest) const
{
    const SegmentId* other = t_.segmentOf.find(std::minmax(ends[0], ends[1]));
    if (other == nullptr) return;
    const Vec3 &c = t_.mesh().position(ends[0]), &d = t_.mesh().position(ends[1]);
    const double share = dot(middle - c, d - c) / squaredLength(d - c);
    if (!(share > 0.0 && share < 1.0)) return;
    const double squaredGap = squaredLength(middle - c - share * (d - c));
    if (squaredGap < nearest.squaredGap)
        nearest = {{1, surface_.segments[*other].edge.value}, middle, squaredGap};
}

void NarrowGaps::keep(const NarrowGap& gap)
{
    const auto known = std::find_if(gaps_.begin(), gaps_.end(), [&](const NarrowGap& other) {
        return (other.edge == gap.edge && other.other == gap.other) ||
               (other.edge == gap.other && other.other == gap.edge);
    });
    if (known == gaps_.end()) {
        gaps_.push_back(gap);
    } else if (gap.width < known->width) {
        *known = gap;
    }
}

}  // namespace mesher
