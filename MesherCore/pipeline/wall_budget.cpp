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

std::vector<WallBudget> wallBudgets(const std::vector<ModelComponent>& components, const MeshOptions& options,
                                    const MeshEstimate& estimate)
{
    if (options.maxWallElements) {
        const auto asked = static_cast<double>(*options.maxWallElements);
        return std::vector<WallBudget>(components.size(), {asked, asked});
    }
    std::vector<WallBudget> budgets;
    double area = 0.0;
    for (const ModelComponent& component : components) area += boxAreaOf(component.model);
    for (const ModelComponent& component : components) {
        const double share = area > 0.0 ? boxAreaOf(component.model) / area : 1.0;
        budgets.push_back({share * std::max(estimate.elements, kLeastTets),
                           share * std::max(estimate.forSizes, kLeastTets)});
    }
    return budgets;
}

WallBudget wallBudgetOfFeatures(const MeshOptions& options)
{
    const double refinement = options.refinement.value_or(1.0);
    const double all =
        options.maxWallElements ? static_cast<double>(*options.maxWallElements) : kTetsForFeatures;
    const double each = all / (refinement * refinement * refinement);
    return {each, each};
}

WallBudget wallBudgetOfFaces(const MeshOptions& options)
{
    const double all =
        options.maxWallElements ? static_cast<double>(*options.maxWallElements) : kTetsForFaces;
    return {all, all};
}

}  // namespace mesher
