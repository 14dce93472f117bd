#pragma once

#include "pipeline/estimate.h"
#include "pipeline/mesh_options.h"
#include "pipeline/model_components.h"

#include <vector>

namespace mesher {

/// The good tetrahedra that thin walls, gaps and cusps of each component may take: the number asked for; without one as many as
/// the sizes ask for in the whole model, and some thousands where these are fewer, shared out by the extents of the components.
[[nodiscard]] std::vector<double> wallBudgets(const std::vector<ModelComponent>& components,
                                              const MeshOptions& options, const MeshEstimate& forSizes);

/// The same for faces that are meshed for themselves, where a rim takes no tetrahedra.
[[nodiscard]] double wallBudgetOfFaces(const MeshOptions& options);

/// What walls may take that are features, where sizes by local features are asked for: in tetrahedra as large as the wall is thick,
/// of which a refinement R makes R^3 each. Walls that take more are no features.
[[nodiscard]] double wallBudgetOfFeatures(const MeshOptions& options);

}  // namespace mesher
