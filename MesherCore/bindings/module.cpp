#include "bindings/bindings.h"

PYBIND11_MODULE(_core, module)
{
    module.doc() = "The compiled part of the package mesher.";
    module.attr("__version__") = MESHER_VERSION;
    mesher::python::bindModel(module);
    mesher::python::bindMesh(module);
    mesher::python::bindPipeline(module);
}
