#pragma once

#include "pipeline/mesh_options.h"

#include <pybind11/pybind11.h>

namespace mesher::python {

/// The options that a dictionary names, but for sizes in files and arrays; None stands for the default.
/// Raises       TypeError for a name that is none, or a value of another kind; OptionError for a measure that is none
[[nodiscard]] MeshOptions meshOptionsOf(const pybind11::dict& named);

}  // namespace mesher::python
