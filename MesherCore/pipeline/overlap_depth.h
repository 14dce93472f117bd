#pragma once

#include "pipeline/component_surface.h"

#include <optional>

namespace mesher {

/// The volume that two groups of solids have in common where they are pressed into one another by less than their facets depart
/// from their faces, so that meshes cannot tell it: the depth of exact points of the faces, integrated over what lies in the other
/// group. Nothing where they are deeper, or nowhere in one another.
/// Cost   up to a thousand facets of each group
/// Units  model units
[[nodiscard]] std::optional<double> shallowCommonVolume(const ComponentSurface& first,
                                                        const ComponentSurface& second, double tolerance);

}  // namespace mesher
