#include "bindings/python_sizes.h"

#include "bindings/python_error.h"
#include "io/read_size_fields.h"
#include "sizing/background_size.h"
#include "sizing/combined_size.h"

#include <pybind11/numpy.h>
#include <pybind11/stl/filesystem.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <limits>
#include <string>
#include <utility>
#include <vector>

namespace mesher::python {

namespace py = pybind11;

namespace {

using Field = std::shared_ptr<const SizingField>;
using Numbers = py::array_t<double, py::array::c_style | py::array::forcecast>;
using Indices = py::array_t<std::int64_t, py::array::c_style | py::array::forcecast>;

bool isPath(py::handle value) { return py::isinstance<py::str>(value) || py::hasattr(value, "__fspath__"); }

std::string pathOf(py::handle value) { return value.cast<std::filesystem::path>().string(); }

/// numpy makes an array of nearly anything, texts included; only numbers are wanted.
template <class Array>
Array arrayOf(py::handle value, const std::string& what, const char* kinds)
{
    const py::array any = py::array::ensure(value);
    if (!any || std::string(kinds).find(any.dtype().kind()) == std::string::npos) {
        PyErr_Clear();
        throw py::type_error(what + " is to be an array of numbers");
    }
    return Array::ensure(any);
}

Numbers rowsOf(py::handle value, const std::string& what, py::ssize_t columns)
{
    const auto rows = arrayOf<Numbers>(value, what, "iuf");
    if (rows.ndim() != 2 || rows.shape(1) != columns) {
        throw py::value_error(what + " is to have the shape (n, " + std::to_string(columns) + ")");
    }
    return rows;
}

Field orMeshingError(Result<Field> field)
{
    if (!field) raise("MeshingError", field.error());
    return std::move(field).value();
}

template <std::size_t N>
void takeElements(const Indices& elements, std::vector<std::array<std::uint32_t, N>>& taken)
{
    const auto at = elements.unchecked<2>();
    for (py::ssize_t i = 0; i < at.shape(0); ++i) {
        auto& element = taken.emplace_back();
        for (std::size_t j = 0; j < N; ++j) {
            const std::int64_t index = at(i, static_cast<py::ssize_t>(j));
            const bool isIndex = index >= 0 && index < std::numeric_limits<std::uint32_t>::max();
            // What is no index is refused behind, with those that are too large.
            element[j] =
                isIndex ? static_cast<std::uint32_t>(index) : std::numeric_limits<std::uint32_t>::max();
        }
    }
}

/// (nodes, elements, sizes)
Field fieldOfBackground(py::handle value)
{
    if (!py::isinstance<py::tuple>(value) || py::len(value) != 3) {
        throw py::type_error("background is to be a path, or a tuple of nodes, elements and sizes");
    }
    const auto parts = py::reinterpret_borrow<py::tuple>(value);
    const Numbers nodes = rowsOf(parts[0], "nodes of background", 3);
    const auto elements = arrayOf<Indices>(parts[1], "elements of background", "iu");
    const auto sizes = arrayOf<Numbers>(parts[2], "sizes of background", "iuf");
    if (sizes.ndim() != 1 || sizes.shape(0) != nodes.shape(0))
        throw py::value_error("background is to have one size for each of its nodes");
    if (elements.ndim() != 2 || (elements.shape(1) != 3 && elements.shape(1) != 4))
        throw py::value_error("elements of background are to have the shape (n, 3) or (n, 4)");
    BackgroundMesh mesh;
    const auto at = nodes.unchecked<2>();
    for (py::ssize_t i = 0; i < at.shape(0); ++i) mesh.nodes.push_back({at(i, 0), at(i, 1), at(i, 2)});
    mesh.sizes.assign(sizes.data(), sizes.data() + sizes.size());
    if (elements.shape(1) == 3) {
        takeElements(elements, mesh.triangles);
    } else {
        takeElements(elements, mesh.tets);
    }
    Result<std::shared_ptr<const BackgroundSize>> field = BackgroundSize::make(std::move(mesh));
    if (!field) raise("OptionError", field.error());
    return std::move(field).value();
}

/// Rows of x, y, z and size.
Field fieldOfPointRows(py::handle value, double grading)
{
    const Numbers rows = rowsOf(value, "size_points", 4);
    const auto at = rows.unchecked<2>();
    std::vector<SizePoint> points;
    for (py::ssize_t i = 0; i < at.shape(0); ++i) {
        points.push_back({{at(i, 0), at(i, 1), at(i, 2)}, at(i, 3)});
        const SizePoint& point = points.back();
        if (isFinite(point.position) && std::isfinite(point.size) && point.size > 0.0) continue;
        throw py::value_error("size_points: row " + std::to_string(i) +
                              " has a place or size that is not finite, or a size that is not above 0");
    }
    if (points.empty()) throw py::value_error("size_points has no row");
    return fieldOfPoints(points, grading);
}

py::object givenFor(const py::dict& named, const char* name)
{
    return named.contains(name) ? py::object(named[name]) : py::object(py::none());
}

}  // namespace

Field sizingFieldOf(const py::dict& named, MeshOptions& options)
{
    constexpr const char* kArray = "array";
    std::vector<Field> fields;
    if (const py::object given = givenFor(named, "background"); !given.is_none()) {
        options.background = isPath(given) ? pathOf(given) : kArray;
        fields.push_back(isPath(given) ? orMeshingError(readBackgroundField(options.background))
                                       : fieldOfBackground(given));
    }
    if (const py::object given = givenFor(named, "size_points"); !given.is_none()) {
        options.sizePoints = isPath(given) ? pathOf(given) : kArray;
        fields.push_back(isPath(given)
                             ? orMeshingError(readSizeFields({}, options.sizePoints, options.grading))
                             : fieldOfPointRows(given, options.grading));
    }
    if (fields.empty()) return nullptr;
    return std::make_shared<CombinedSize>(std::move(fields));
}

}  // namespace mesher::python
