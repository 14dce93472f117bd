#pragma once

#include "brep/brep_model.h"
#include "delaunay/check_report.h"
#include "improvement/boundary_geometry.h"
#include "mesh/classified_mesh.h"

namespace mesher {

struct ImprovementCheckOptions
{
    /// Largest distance of a node from its own entity, and from the faces beside an edge if the edge's tolerance and the distance
    /// before are less, model units.
    double nodeDistance = 1e-7;
    /// How many times the longest distance between a face and the middle of a triangle's side may grow: improvement bounds it by
    /// the normals at the ends, which is exact for round faces only.
    double sagGrowth = 1.1 * BoundaryGeometry::kGrowth;
};

/// Compares a mesh with what improvement has made of it, without knowing how: it is sound (mesh_check) if it was; the sorted
/// scores have not fallen, the worst first; the nodes of the boundary are still there, at the same place if on a vertex of the
/// model, else on the exact point of the same entity that their parameters say, and on the faces beside an edge; each
/// face has as many triangles, nodes and sides as before, which look to the same side, follow its normals and have angles as
/// BoundaryGeometry says; lines are the same; the volume of each solid is the same,
/// but for the gaps between chords and faces.
/// Cost         a projection on the exact surface for each side of a triangle, n log n
[[nodiscard]] CheckReport checkImprovement(const ClassifiedMesh& before, const ClassifiedMesh& after,
                                           const BrepModel& model,
                                           const ImprovementCheckOptions& options = {});

}  // namespace mesher
