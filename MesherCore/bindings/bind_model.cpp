#include "bindings/bindings.h"
#include "bindings/python_error.h"
#include "brep/model_inspection.h"
#include "brep/occt/read_model.h"

#include <pybind11/stl/filesystem.h>

#include <filesystem>

namespace mesher::python {

namespace py = pybind11;

namespace {

ReadModel readFile(const std::filesystem::path& path, bool heals, bool isTried)
{
    Result<ReadModel> read = [&] {
        const py::gil_scoped_release released;
        return readModel(path, ReadOptions{heals, isTried});
    }();
    if (!read) raise("ModelError", read.error());
    return std::move(read).value();
}

std::string factsOf(const ReadModel& read)
{
    const py::gil_scoped_release released;
    return jsonOf(inspectModel(read.model));
}

}  // namespace

void bindModel(py::module_& module)
{
    py::class_<ReadModel>(module, "Model", "A B-rep model, read once and meshed as often as you like.")
        .def_static("read", &readFile, py::arg("path"), py::arg("heal") = false, py::arg("tried") = true)
        .def("info_json", &factsOf)
        .def_property_readonly("format", [](const ReadModel& read) { return read.format; })
        .def_property_readonly("unit", [](const ReadModel& read) { return read.model.unit; })
        .def_property_readonly("solid_count", [](const ReadModel& read) { return read.model.solids.size(); })
        .def_property_readonly("face_count", [](const ReadModel& read) { return read.model.faces.size(); })
        .def_property_readonly("edge_count", [](const ReadModel& read) { return read.model.edges.size(); })
        .def_property_readonly("vertex_count",
                               [](const ReadModel& read) { return read.model.vertices.size(); });
}

}  // namespace mesher::python
