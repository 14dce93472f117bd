#include "mesh_panel.h"

#include <pybind11/pybind11.h>

#include <cstdint>

PYBIND11_MODULE(mesher_gui, module)
{
    module.doc() = "The widgets of the workbench; each function returns the address of a new QWidget, to be "
                   "wrapped by PySide.";
    module.def("create_mesh_panel", [] {
        return reinterpret_cast<std::uintptr_t>(static_cast<QWidget*>(new mesher::gui::MeshPanel));
    });
}
