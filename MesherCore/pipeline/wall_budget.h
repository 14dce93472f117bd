#pragma once

#include "pipeline/estimate.h"
#include "pipeline/mesh_options.h"
#include "pipeline/model_components.h"

#include <vector>

namespace mesher {

/// The good tetrahedra that narrow places may take.
struct WallBudget
{
    double walls = 0.0;   ///< thin walls, gaps and cusps, with their rims
    double strips = 0.0;  ///< narrow faces of thick solids
};

/// Those of each component: the number asked for; without one as many as the wishes ask for in the whole model, for strips as
/// the sizes alone, since the curvature of a narrow fillet is no reason to make it good; some thousands where these are fewer,
/// shared out by the extents of the components.
[[nodiscard]] std::vector<WallBudget> wallBudgets(const std::vector<ModelComponent>& components,
                                                  const MeshOptions& options, const MeshEstimate& estimate);

/// The same for faces that are meshed for themselves, where narrow places take no tetrahedra.
[[nodiscard]] WallBudget wallBudgetOfFaces(const MeshOptions& options);

/// What walls may take that are features, where sizes by local features are asked for: in tetrahedra as large as the wall is thick,
/// of which a refinement R makes R^3 each. Walls that take more are no features.
[[nodiscard]] WallBudget wallBudgetOfFeatures(const MeshOptions& options);

}  // namespace mesher
