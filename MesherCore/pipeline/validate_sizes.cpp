#include "pipeline/validate_sizes.h"

#include "pipeline/option_checks.h"
#include "sizing/formula_size.h"

namespace mesher {

namespace {

Result<void> validateUniform(const MeshOptions& options)
{
    if (options.size) {
        if (auto r = checkSize("size", *options.size); !r) return r;
    }
    if (options.minSize) {
        if (auto r = checkSize("min-size", *options.minSize); !r) return r;
        if (options.size && *options.minSize > *options.size) {
            return optionError("min-size", "is larger than --size",
                               "give a length of at most " + decimalOf(*options.size));
        }
    }
    if (auto r = checkNotNegative("sag", options.sag); !r) return r;
    if (options.curvature != 0.0) {
        if (auto r = checkRange("curvature", options.curvature, 3.0, 3600.0); !r) return r;
    }
    if (options.refinement) {
        if (auto r = checkRange("refinement", *options.refinement, 1.0, 1000.0); !r) return r;
    }
    return checkRange("grading", options.grading, 0.01, 1000.0);
}

Result<void> validateOnEntities(const MeshOptions& options)
{
    for (const LocalSize& local : options.localSizes) {
        if (auto r = checkSize("local-size", local.size, " of " + local.entity); !r) return r;
    }
    for (const SizeByDistance& wish : options.distanceSizes) {
        if (auto r = checkSize("size-distance", wish.size, " of " + wish.entity); !r) return r;
        if (auto r = checkNotNegative("size-distance", wish.growth); !r) return r;
        if (auto r = checkNotNegative("size-distance", wish.plateau); !r) return r;
    }
    return {};
}

Result<void> validateInShapes(const MeshOptions& options)
{
    for (const SizeInBox& box : options.boxSizes) {
        if (!isFinite(box.first) || !isFinite(box.last)) {
            return optionError("size-box", "a corner of the box is not finite",
                               "give coordinates in model units");
        }
        if (auto r = checkSize("size-box", box.size); !r) return r;
        if (auto r = checkNotNegative("size-box", box.growth.value_or(0.0)); !r) return r;
    }
    for (const SizeInBall& ball : options.ballSizes) {
        if (!isFinite(ball.centre)) {
            return optionError("size-ball", "the centre of the ball is not finite",
                               "give coordinates in model units");
        }
        if (!checkSize("size-ball", ball.radius)) {
            return optionError("size-ball", "the radius " + decimalOf(ball.radius) + " makes no sense",
                               "give a length above 0 in model units");
        }
        if (auto r = checkSize("size-ball", ball.size); !r) return r;
        if (auto r = checkNotNegative("size-ball", ball.growth.value_or(0.0)); !r) return r;
    }
    return {};
}

Result<void> validateFormula(const MeshOptions& options)
{
    if (options.sizeFormula.empty()) return {};
    const Result<FormulaSize> formula = FormulaSize::parse(options.sizeFormula);
    if (formula) return {};
    const Error& error = formula.error();
    return optionError("size-formula", error.entity + ": " + error.message, error.remedy);
}

}  // namespace

Result<void> validateSizes(const MeshOptions& options)
{
    if (auto r = validateUniform(options); !r) return r;
    if (auto r = validateOnEntities(options); !r) return r;
    if (auto r = validateInShapes(options); !r) return r;
    return validateFormula(options);
}

}  // namespace mesher
