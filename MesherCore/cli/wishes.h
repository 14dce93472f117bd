#pragma once

#include "brep/brep_model.h"
#include "cli/command_line.h"

namespace mesher {

/// Refuses what is asked to be written and cannot be, whatever the mesh will be: a curved boundary of faces that are not plane, a
/// format of plane meshes for others. Told before anything takes time.
[[nodiscard]] Result<void> checkWishes(const MeshCommand& command, const BrepModel& model);

}  // namespace mesher
