#pragma once

#include "brep/brep_model.h"
#include "delaunay/check_report.h"
#include "mesh/classified_mesh.h"

namespace mesher {

struct ImprovementCheckOptions
{
    /// Largest distance of a node from its own entity, and from the faces beside an edge if the edge's tolerance and the distance
    /// before are less, model units.
    double nodeDistance = 1e-7;
    /// How much longer the longest distance between a face and the middle of a triangle's side may get, of itself: improvement
    /// bounds it by normals at the ends, which is exact for round faces only.
    double sagGrowth = 0.1;
};

/// Compares a mesh with what improvement has made of it, without knowing how: it is sound (mesh_check) if it was; the sorted
/// scores have not fallen, the worst first; the nodes of the boundary are still there, at the same place if on a vertex of the
/// model, else on the exact point of the same entity that their parameters say, and on the faces beside an edge; each
/// face has as many triangles, nodes and sides as before, which look to the same side, follow its normals as well and have
/// no smaller angle than before or BoundaryGeometry::kLeastFacetAngle; lines are the same; the volume of each solid is the same,
/// but for the gaps between chords and faces.
/// Cost         a projection on the exact surface for each side of a triangle, n log n
[[nodiscard]] CheckReport checkImprovement(const ClassifiedMesh& before, const ClassifiedMesh& after,
                                           const BrepModel& model, const ImprovementCheckOptions& options = {});

}  // namespace mesher
