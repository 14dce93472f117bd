#include "inspection_panel.h"
#include "mesh_panel.h"

#include <pybind11/pybind11.h>

#include <cstdint>

namespace {

template <class Widget>
std::uintptr_t addressOfNew()
{
    return reinterpret_cast<std::uintptr_t>(static_cast<QWidget*>(new Widget));
}

}  // namespace

PYBIND11_MODULE(mesher_gui, module)
{
    module.doc() = "The widgets of the workbench; each function returns the address of a new QWidget, to be "
                   "wrapped by PySide.";
    module.def("create_mesh_panel", &addressOfNew<mesher::gui::MeshPanel>);
    module.def("create_inspection_panel", &addressOfNew<mesher::gui::InspectionPanel>);
}
