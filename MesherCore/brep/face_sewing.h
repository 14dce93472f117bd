#pragma once

#include "brep/brep_model.h"

namespace mesher {

/// Joins faces of a model that lie side by side without an edge in common, as files without solids have them: edges of one face each
/// that run along one another become one. Faces of closed shells are left as they are.
/// Guarantees   names of vertices, edges and faces stay; edges that are split at a vertex of another keep their name for the first
///              part, the others come last. Notes tell what was done.
/// Requires     edges nearer than 1e-6 of the model's diagonal, or within their tolerances, and never farther apart than a tenth of
///              the shortest of them
/// Cost         n log n for the vertices, a few projections for each vertex near an edge
void sewFaces(BrepModel& model);

}  // namespace mesher
