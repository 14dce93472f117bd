#pragma once

#include "brep/brep_ids.h"
#include "delaunay/constrained_tetrahedralization.h"
#include "mesh/surface_mesh.h"

#include <array>
#include <vector>

namespace mesher {

/// An edge of the model and what lies nearer beside it than can be resolved.
struct NarrowGap
{
    EntityRef edge;
    EntityRef other;     ///< a vertex, edge or face
    double width = 0.0;  ///< the least that was met, model units
    Vec3 place;          ///< model units
};

/// Finds segments with a vertex or another segment beside them, nearer than the least gap. To split them would go on until their parts are as short
/// as the gap is wide, all along the segment, and the tetrahedra in the gap would be as flat as before.
/// Cost         the tetrahedra around a segment
class NarrowGaps
{
public:
    /// Both outlive it. The least gap is in model units; with 0 there are none.
    NarrowGaps(const ConstrainedTetrahedralization& tetrahedralization, const SurfaceMesh& surface,
               double leastGap);

    /// Whether there is such a gap beside the segment; it is kept, if it is the narrowest between its two entities.
    bool isBeside(SegmentId segment);
    /// Whether the facet is narrower than the least gap: parts of it would be so, too.
    [[nodiscard]] bool isInside(const std::array<VertexId, 3>& facet) const;
    /// In the order in which they were met.
    [[nodiscard]] const std::vector<NarrowGap>& gaps() const { return gaps_; }

private:
    struct Nearest
    {
        EntityRef entity;
        Vec3 place;
        double squaredGap = 0.0;
    };

    void includeVertex(VertexId v, const Vec3& a, const Vec3& b, Nearest& nearest) const;
    void includeSegment(const std::array<VertexId, 2>& ends, const Vec3& middle, Nearest& nearest) const;
    void keep(const NarrowGap& gap);

    const ConstrainedTetrahedralization& t_;
    const SurfaceMesh& surface_;
    double leastGap_;
    std::vector<NarrowGap> gaps_;
    std::vector<TetId> ring_;
};

}  // namespace mesher
