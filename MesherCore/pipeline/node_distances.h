#pragma once

#include "brep/brep_model.h"
#include "brep/face_distance.h"
#include "mesh/classified_mesh.h"

#include <optional>
#include <vector>

namespace mesher {

/// Farther than that from its entity, or than the entity's tolerance, a node is off it; model units.
inline constexpr double kNodeTolerance = 1e-7;

/// How far each node lies from its own vertex, edge or face; nothing for nodes inside of solids and entities that the model lacks.
/// A search on the surface without a seed may miss the nearest sheet of a face that runs close to itself: where it finds a node
/// off its face, the feet of the nodes joined to it are tried as seeds, from node to node.
/// Cost         a closest-point search on a curve or surface for each node; one for each triangle's side at a node that is off
[[nodiscard]] std::vector<std::optional<FaceDistance>> distancesOfNodes(const ClassifiedMesh& mesh,
                                                                        const BrepModel& model);

[[nodiscard]] bool isInModel(EntityRef entity, const BrepModel& model);

/// Is a place at this distance from its entity on it, within the tolerances and the rounding of places so far from the origin?
[[nodiscard]] bool isOn(const FaceDistance& found, const Vec3& place);

}  // namespace mesher
