#pragma once

#include "base/error.h"
#include "base/run_context.h"
#include "base/stop_reason.h"
#include "mesh/classified_mesh.h"
#include "pipeline/mesh_report.h"

namespace mesher {

/// The run failed for this reason; without an entity that is the model.
void fail(MeshReport& report, Error error);

/// What a run that ended early is told: what limit it was, and what to do about it.
[[nodiscard]] Error errorOf(StopReason reason, const MeshOptions& options);

/// The run ended early for this reason, unless it is done.
void tellStop(StopReason reason, MeshReport& report);

/// Checks the whole mesh as anyone who reads its file could; what is found fails the run.
void checkWhole(const ClassifiedMesh& mesh, MeshReport& report, RunContext& context);

}  // namespace mesher
