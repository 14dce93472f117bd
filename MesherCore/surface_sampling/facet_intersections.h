#pragma once

#include "base/id_vector.h"
#include "base/run_context.h"
#include "base/vec.h"
#include "brep/brep_model.h"
#include "mesh/surface_mesh.h"

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace mesher {

/// Two facets that have more in common than the nodes and the segments that they share.
struct FacetIntersection
{
    FacetId first;
    FacetId second;
    Vec3 point;  ///< near it
};

/// All pairs of facets of a surface mesh that intersect, touch, or overlap; exact. Pairs of one plane face are left out: its
/// facets are a triangulation of the plane.
/// Guarantees   ascending in (first, second)
/// Cost         O(n log n) for facets of bounded shape, by a tree of boxes
/// Terminates   early, with those that were found, when the run is cancelled by its progress hook or otherwise
[[nodiscard]] std::vector<FacetIntersection>
findFacetIntersections(const BrepModel& model, const SurfaceMesh& mesh, RunContext& context);

/// For each facet whether it is asked for.
using FacetMarks = IdVector<FacetId, std::uint8_t>;

/// The same of pairs of which one facet at least is asked for: of a mesh that was free of intersections before these changed.
[[nodiscard]] std::vector<FacetIntersection> findFacetIntersections(const BrepModel& model,
                                                                    const SurfaceMesh& mesh,
                                                                    const FacetMarks& asked,
                                                                    RunContext& context);

}  // namespace mesher
