#pragma once

#include "base/budget.h"
#include "base/stop_reason.h"
#include "surface_sampling/face_mesh.h"

#include <cstddef>
#include <vector>

namespace mesher {

/// What keeps an edge from being flipped.
enum class FlipObstacle
{
    None,
    Constrained,  ///< a segment, a side of a ring, or the border of the face
    Joined,       ///< the new edge is there already
    Folds         ///< the new triangles would look away from the surface, more than the present ones
};

[[nodiscard]] FlipObstacle obstacleToFlip(const FaceMesh& mesh, const FaceGeometry& geometry, EdgeLink side);
/// Replaces the edge by the other diagonal; returns one side of it. Requires an edge without obstacle.
EdgeLink flip(FaceMesh& mesh, const FaceGeometry& geometry, EdgeLink side);
/// The sum of the angles opposite to the edge does not exceed 180 degrees, or a segment or the border holds it.
[[nodiscard]] bool isLocallyDelaunay(const FaceMesh& mesh, EdgeLink side);

struct FaceFlips
{
    StopReason stopReason = StopReason::Done;
    std::size_t flips = 0;
    std::size_t refused = 0;  ///< edges left that are not locally Delaunay, because of an obstacle
};

/// Flips edges of the suspects, and those around what changes, until each is locally Delaunay or cannot be flipped.
/// Guarantees   the mesh stays a manifold; no triangle looks away from the surface that did not before
/// Terminates   each flip of an edge between triangles that are nearly flat lowers their largest opposite angles; the budget
///              ends what could go on where they are not
/// Reference    [lawson1977]; thesis §3.3.2.3
FaceFlips restoreSurfaceDelaunay(FaceMesh& mesh, const FaceGeometry& geometry, std::vector<EdgeLink> suspects,
                                 Budget& budget);
/// Flips of folded facets could go round; this is far more than a sound mesh needs.
[[nodiscard]] BudgetLimits flipLimits(const FaceMesh& mesh);
/// The same for all edges of the mesh.
FaceFlips makeSurfaceDelaunay(FaceMesh& mesh, const FaceGeometry& geometry, Budget& budget);

}  // namespace mesher
