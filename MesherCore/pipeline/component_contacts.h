#pragma once

#include "base/run_context.h"
#include "mesh/region_sides.h"
#include "mesh/surface_mesh.h"
#include "pipeline/mesh_report.h"
#include "pipeline/model_components.h"

#include <optional>
#include <span>
#include <string>
#include <vector>

namespace mesher {

/// A group of solids with its sampled surface.
struct SampledComponent
{
    const ModelComponent* component = nullptr;
    const SurfaceMesh* mesh = nullptr;
    const RegionSides* sides = nullptr;
};

/// Two solids of the whole model that have a volume in common.
struct SolidOverlap
{
    EntityRef first;
    EntityRef second;
    Vec3 place;
    std::optional<double> commonVolume{};  ///< where it is too shallow for meshes to tell, model units cubed
};

/// Compares groups of solids that share no entity, pair by pair. Those that touch are told as a warning, since their meshes are
/// not led through; those that overlap fail the run where the options refuse them. Both have the names of two solids and a place.
/// Returns      the overlaps, which tellOverlaps tells of finished meshes
/// Terminates   early when the run is to end
/// Cost         boxes of all pairs; see solid_contacts.h for those that are near
[[nodiscard]] std::vector<SolidOverlap> tellContacts(std::span<const SampledComponent> components,
                                                     MeshReport& report, RunContext& context);

/// Warns of solids that overlap and are meshed each for itself, with the volume that they have in common, by their
/// meshes where these can tell it.
void tellOverlaps(std::span<const SolidOverlap> overlaps, const ClassifiedMesh& mesh, const std::string& unit,
                  MeshReport& report);

}  // namespace mesher
