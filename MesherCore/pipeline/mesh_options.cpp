#include "pipeline/mesh_options.h"

#include "mesh/classified_mesh.h"
#include "pipeline/option_checks.h"
#include "pipeline/validate_sizes.h"

#include <limits>
#include <optional>
#include <string>

namespace mesher {

namespace {

Result<void> validateFaces(const MeshOptions& options)
{
    for (const std::string& name : options.faces) {
        const std::optional<EntityRef> entity = entityNamed(name);
        if (entity && entity->dimension == 2) continue;
        return optionError("faces", "'" + name + "' is no name of a face", "give names like Face1,Face6");
    }
    if (!options.faces.empty() && options.dimension == 3) {
        return optionError("faces", "names what is meshed in two dimensions, and of solids all is",
                           "leave the option out, or add --dimension 2");
    }
    return {};
}

Result<void> validateRun(const MeshOptions& options)
{
    if (auto r = checkRange("threads", options.threads, 1.0, 1024.0); !r) return r;
    if (auto r = checkRange("max-elements", static_cast<double>(options.maxElements), 1.0, 1e9); !r) return r;
    if (options.maxWallElements) {
        if (auto r = checkRange("max-wall-elements", static_cast<double>(*options.maxWallElements), 0.0, 1e9);
            !r)
            return r;
    }
    if (options.timeout && !checkSize("timeout", *options.timeout)) {
        return optionError("timeout", decimalOf(*options.timeout) + " is no time", "give seconds above 0");
    }
    return {};
}

}  // namespace

std::string_view nameOf(OverlapChoice choice)
{
    return choice == OverlapChoice::Separate ? "separate" : "refuse";
}

std::optional<OverlapChoice> overlapChoiceOf(std::string_view name)
{
    for (const OverlapChoice choice : {OverlapChoice::Separate, OverlapChoice::Refuse}) {
        if (name == nameOf(choice)) return choice;
    }
    return std::nullopt;
}

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
    if (auto r = validateFaces(options); !r) return r;
    if (auto r = validateSizes(options); !r) return r;
    if (auto r = checkRange("min-angle", options.minAngle, 0.0, 45.0); !r) return r;
    if (auto r = checkRange("max-turn", options.maxTurn, 30.0, 90.0); !r) return r;
    if (options.threshold) {
        if (auto r = checkRange("threshold", *options.threshold, std::numeric_limits<double>::min(), 1.0); !r)
            return r;
    }
    if (options.maxDihedral) {
        if (auto r = checkRange("max-dihedral", *options.maxDihedral, 120.0, 180.0); !r) return r;
    }
    if (options.lambda) {
        if (auto r = checkRange("lambda", *options.lambda, 1.0, 1e8); !r) return r;
    }
    return validateRun(options);
}

}  // namespace mesher
