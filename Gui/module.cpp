#include "inspection_panel.h"
#include "mesh_panel.h"

#include <pybind11/pybind11.h>

#include <QString>

#include <cstdint>
#include <memory>
#include <utility>

namespace {

std::uintptr_t addressOf(QWidget* widget) { return reinterpret_cast<std::uintptr_t>(widget); }

/// A panel that keeps it is deleted by Qt, without the interpreter's lock, and maybe after the interpreter.
std::shared_ptr<pybind11::function> shared(pybind11::function function)
{
    return {new pybind11::function(std::move(function)), [](pybind11::function* kept) {
                if (Py_IsInitialized() == 0) return;  // it went with the interpreter
                const pybind11::gil_scoped_acquire lock;
                delete kept;
            }};
}

std::uintptr_t createMeshPanel(pybind11::function makeField)
{
    return addressOf(new mesher::gui::MeshPanel([make = shared(std::move(makeField))](const QString& name) {
        const pybind11::gil_scoped_acquire lock;
        const pybind11::tuple made = (*make)(name.toStdString());
        auto* field = reinterpret_cast<QWidget*>(made[0].cast<std::uintptr_t>());
        field->setParent(nullptr);  // before its owner leaves
        return field;
    }));
}

}  // namespace

PYBIND11_MODULE(mesher_gui, module)
{
    module.doc() = "The widgets of the workbench; each function returns the address of a new QWidget, to be "
                   "wrapped by PySide.";
    module.def("create_mesh_panel", &createMeshPanel, pybind11::arg("make_field"),
               "`make_field(name)` returns the address of a new Gui::QuantitySpinBox and the widget in which "
               "it was made.");
    module.def("create_inspection_panel", [] { return addressOf(new mesher::gui::InspectionPanel); });
}
