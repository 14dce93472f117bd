#pragma once

#include "surface_sampling/face_triangulation.h"
#include "surface_sampling/initial_face_mesh.h"

#include <cstddef>
#include <span>
#include <utility>

namespace mesher {

struct FaceRefinement
{
    std::size_t insertions = 0;
    /// Triangles left alone at the floor, where the surface has a crease or a cusp.
    std::size_t givenUp = 0;
    bool isComplete = true;  ///< false if the budget of points ended it
};

/// Inserts a grid of points on faces that are curved both ways; the number of points.
std::size_t seedFace(const BrepModel& model, BrepFaceId face, const CurveChains& chains,
                     FaceTriangulation& t);

/// Inserts points into a face's triangulation until its lifted triangles follow the surface: the middles of the sides along
/// which the surface turns most. Where that side is a piece of the outline its segment is too coarse, and is named instead.
/// Terminates   by the option's budget and the floor
[[nodiscard]] FaceRefinement followSurface(const BrepFace& face, const FaceOutline& outline,
                                           const CurveChains& chains, const InitialFaceMeshOptions& options,
                                           FaceTriangulation& t);

/// Splits sides that lifting makes one with others: those that join two images of a node, that join the same nodes as another
/// side does, or that join nodes of `taken`, which are edges of other faces.
/// Guarantees   true if there was such a side; triangles around the new points may not follow the surface then
bool separateSides(const BrepFace& face, const FaceOutline& outline,
                   std::span<const std::pair<NodeId, NodeId>> taken, FaceTriangulation& t);

}  // namespace mesher
