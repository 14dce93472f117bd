#include "pipeline/mesh_options.h"

#include <charconv>
#include <cmath>
#include <limits>
#include <string_view>

namespace mesher {

namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

std::string text(double value)
{
    char digits[32];
    return {digits, std::to_chars(std::begin(digits), std::end(digits), value).ptr};
}

Error optionError(std::string_view option, const std::string& message, std::string remedy)
{
    return {ErrorCode::InvalidArgument, message, "--" + std::string(option), {}, std::move(remedy)};
}

/// Refuses what is not in [low, high], or not a number.
Result<void> checkRange(std::string_view option, double value, double low, double high)
{
    if (low <= value && value <= high) return {};
    return optionError(option, text(value) + " is out of range",
                       "give a number from " + text(low) + " to " + text(high));
}

Result<void> checkSize(std::string_view option, double value)
{
    if (value > 0.0 && value < kInfinity) return {};
    return optionError(option, "the size " + text(value) + " makes no sense",
                       "give a length above 0 in model units");
}

Result<void> checkNotNegative(std::string_view option, double value)
{
    if (value >= 0.0 && value < kInfinity) return {};
    return optionError(option, text(value) + " is out of range", "give a number of at least 0");
}

Result<void> validateSizes(const MeshOptions& options)
{
    if (options.size) {
        if (auto r = checkSize("size", *options.size); !r) return r;
    }
    if (options.minSize) {
        if (auto r = checkSize("min-size", *options.minSize); !r) return r;
        if (options.size && *options.minSize > *options.size) {
            return optionError("min-size", "is larger than --size",
                               "give a length of at most " + text(*options.size));
        }
    }
    for (const LocalSize& local : options.localSizes) {
        if (local.size > 0.0 && local.size < kInfinity) continue;
        return optionError("local-size",
                           "the size " + text(local.size) + " of " + local.entity + " makes no sense",
                           "give a length above 0 in model units");
    }
    if (auto r = checkNotNegative("sag", options.sag); !r) return r;
    if (options.curvature != 0.0) {
        if (auto r = checkRange("curvature", options.curvature, 3.0, 3600.0); !r) return r;
    }
    if (auto r = checkRange("refinement", options.refinement, 1.0, 1000.0); !r) return r;
    return checkRange("grading", options.grading, 0.01, 1000.0);
}

Result<void> validateRun(const MeshOptions& options)
{
    if (auto r = checkRange("threads", options.threads, 1.0, 1024.0); !r) return r;
    if (auto r = checkRange("max-elements", static_cast<double>(options.maxElements), 1.0, 1e9); !r) return r;
    if (options.timeout && !(*options.timeout > 0.0 && *options.timeout < kInfinity)) {
        return optionError("timeout", text(*options.timeout) + " is no time", "give seconds above 0");
    }
    return {};
}

}  // namespace

Result<void> validate(const MeshOptions& options)
{
    if (options.dimension != 2 && options.dimension != 3) {
        return optionError("dimension", std::to_string(options.dimension) + " is no dimension of a mesh",
                           "give 2 or 3");
    }
    if (options.order != 1 && options.order != 2) {
        return optionError("order", std::to_string(options.order) + " is no order of elements",
                           "give 1 or 2");
    }
    if (auto r = validateSizes(options); !r) return r;
    if (auto r = checkRange("min-angle", options.minAngle, 0.0, 45.0); !r) return r;
    if (auto r = checkRange("max-turn", options.maxTurn, 30.0, 90.0); !r) return r;
    if (options.threshold) {
        if (auto r = checkRange("threshold", *options.threshold, std::numeric_limits<double>::min(), 1.0); !r)
            return r;
    }
    return validateRun(options);
}

}  // namespace mesher
