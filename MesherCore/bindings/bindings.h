#pragma once

#include <pybind11/pybind11.h>

namespace mesher::python {

/// One for each part of the module mesher._core.
void bindModel(pybind11::module_& module);
void bindMesh(pybind11::module_& module);
void bindPipeline(pybind11::module_& module);

}  // namespace mesher::python
