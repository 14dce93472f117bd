#pragma once

#include "pipeline/mesh_options.h"
#include "sizing/sizing_field.h"

#include <pybind11/pybind11.h>

#include <memory>

namespace mesher::python {

/// The fields that the options `background` and `size_points` of a dictionary stand for, or none: paths of files, or arrays.
/// `options` has the grading, and is told what was given, for the report.
/// Raises       TypeError and ValueError for arrays of another kind or shape, MeshingError for files that hold no sizes
[[nodiscard]] std::shared_ptr<const SizingField> sizingFieldOf(const pybind11::dict& named,
                                                               MeshOptions& options);

}  // namespace mesher::python
