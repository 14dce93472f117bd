#include "pipeline/wall_budget.h"

#include <algorithm>

namespace mesher {

namespace {

/// Who asks for sizes by features wants them in walls as well, but not at any price.
constexpr double kTetsForFeatures = 1e6;

/// That walls may take however coarse the sizes are: what is over in a second.
constexpr double kLeastTets = 5000.0;
constexpr double kTetsForFaces = 1e6;

double boxAreaOf(const BrepModel& model)
{
    const Vec3 extent = model.box.extent();
    return extent.x * extent.y + extent.y * extent.z + extent.z * extent.x;
}

}  // namespace

std::vector<double> wallBudgets(const std::vector<ModelComponent>& components, const MeshOptions& options,
                                const MeshEstimate& forSizes)
{
    if (options.maxWallElements)
        return std::vector<double>(components.size(), static_cast<double>(*options.maxWallElements));
    std::vector<double> budgets;
    double area = 0.0;
    for (const ModelComponent& component : components) area += boxAreaOf(component.model);
    const double all = std::max(forSizes.elements, kLeastTets);
    for (const ModelComponent& component : components)
        budgets.push_back(area > 0.0 ? all * boxAreaOf(component.model) / area : all);
    return budgets;
}

double wallBudgetOfFeatures(const MeshOptions& options)
{
    const double refinement = options.refinement.value_or(1.0);
    const double all =
        options.maxWallElements ? static_cast<double>(*options.maxWallElements) : kTetsForFeatures;
    return all / (refinement * refinement * refinement);
}

double wallBudgetOfFaces(const MeshOptions& options)
{
    return options.maxWallElements ? static_cast<double>(*options.maxWallElements) : kTetsForFaces;
}

}  // namespace mesher
