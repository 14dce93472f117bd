#pragma once

#include "pipeline/mesh_report.h"
#include "pipeline/model_components.h"

namespace mesher {

/// Adds what a component's run did to the report of the whole, with the names of the whole.
void addReport(const ModelComponent& component, const MeshReport& part, MeshReport& whole);

}  // namespace mesher
