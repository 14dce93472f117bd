#pragma once

#include "mesh/region_sides.h"
#include "mesh/surface_mesh.h"
#include "pipeline/mesh_report.h"
#include "pipeline/model_components.h"

#include <span>

namespace mesher {

/// A group of solids with its sampled surface.
struct SampledComponent
{
    const ModelComponent* component = nullptr;
    const SurfaceMesh* mesh = nullptr;
    const RegionSides* sides = nullptr;
};

/// Compares groups of solids that share no entity, pair by pair: those that overlap fail the run unless
/// the options allow of it, those that touch are told as
/// a warning, since their meshes are not led through; both with the names of two solids and a place.
/// Returns      whether none overlap that must not
/// Cost         boxes of all pairs; see solid_contacts.h for those that are near
[[nodiscard]] bool tellContacts(std::span<const SampledComponent> components, MeshReport& report);

}  // namespace mesher
