#include "pipeline/space_sizes.h"

#include "base/assert.h"
#include "base/box.h"
#include "sizing/formula_size.h"
#include "sizing/shape_sizes.h"
#include "sizing/uniform_size.h"

#include <array>

namespace mesher {

std::vector<std::shared_ptr<const SizingField>> spaceSizes(const MeshOptions& options)
{
    std::vector<std::shared_ptr<const SizingField>> fields;
    if (options.size) fields.push_back(std::make_shared<UniformSize>(*options.size));
    const auto profileOf = [&](const auto& wish) {
        DistanceProfile profile;
        profile.size = wish.size;
        profile.growth = wish.growth.value_or(1.0 / options.grading);
        return profile;
    };
    for (const SizeInBox& wish : options.boxSizes) {
        const Box3 box = Box3::of(std::array{wish.first, wish.last});
        fields.push_back(std::make_shared<BoxSize>(box, profileOf(wish)));
    }
    for (const SizeInBall& wish : options.ballSizes) {
        fields.push_back(std::make_shared<BallSize>(wish.centre, wish.radius, profileOf(wish)));
    }
    if (!options.sizeFormula.empty()) {
        const Result<FormulaSize> formula = FormulaSize::parse(options.sizeFormula);
        MESHER_PRECONDITION(formula.hasValue());
        fields.push_back(std::make_shared<FormulaSize>(formula.value()));
    }
    return fields;
}

}  // namespace mesher
