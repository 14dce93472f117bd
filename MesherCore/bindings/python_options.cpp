#include "bindings/python_options.h"

#include <functional>
#include <map>
#include <string>

namespace mesher::python {

namespace py = pybind11;

namespace {

using Setter = std::function<void(MeshOptions&, py::handle)>;

template <class Value>
Value valueOf(py::handle handle)
{
    // A True that stands for 1.0 is a mistake of the caller.
    if constexpr (!std::is_same_v<Value, bool>) {
        if (PyBool_Check(handle.ptr())) throw py::cast_error();
    }
    return handle.cast<Value>();
}

template <class Member>
Setter setterOf(Member member)
{
    return [member](MeshOptions& options, py::handle value) {
        using Field = std::remove_reference_t<decltype(options.*member)>;
        if constexpr (requires { typename Field::value_type; } && !std::is_same_v<Field, std::string>) {
            options.*member = valueOf<typename Field::value_type>(value);
        } else {
            options.*member = valueOf<Field>(value);
        }
    };
}

void setMeasure(MeshOptions& options, py::handle value)
{
    const std::string key = valueOf<std::string>(value);
    const std::optional<TetMeasure> measure = tetMeasureOf(key);
    if (!measure) throw py::value_error("measure: '" + key + "' is none of q1 ... q8");
    options.measure = *measure;
}

void setLocalSizes(MeshOptions& options, py::handle value)
{
    for (const auto& [entity, size] : valueOf<py::dict>(value))
        options.localSizes.push_back({valueOf<std::string>(entity), valueOf<double>(size)});
}

const std::map<std::string, Setter>& setters()
{
    static const std::map<std::string, Setter> all = {
        {"dimension", setterOf(&MeshOptions::dimension)},
        {"size", setterOf(&MeshOptions::size)},
        {"min_size", setterOf(&MeshOptions::minSize)},
        {"curvature", setterOf(&MeshOptions::curvature)},
        {"sag", setterOf(&MeshOptions::sag)},
        {"refinement", setterOf(&MeshOptions::refinement)},
        {"grading", setterOf(&MeshOptions::grading)},
        {"local_sizes", setLocalSizes},
        {"min_angle", setterOf(&MeshOptions::minAngle)},
        {"max_turn", setterOf(&MeshOptions::maxTurn)},
        {"measure", setMeasure},
        {"threshold", setterOf(&MeshOptions::threshold)},
        {"improve", setterOf(&MeshOptions::isImproved)},
        {"order", setterOf(&MeshOptions::order)},
        {"threads", setterOf(&MeshOptions::threads)},
        {"max_elements", setterOf(&MeshOptions::maxElements)},
        {"max_wall_elements", setterOf(&MeshOptions::maxWallElements)},
        {"timeout", setterOf(&MeshOptions::timeout)},
        {"check", setterOf(&MeshOptions::isChecked)},
    };
    return all;
}

}  // namespace

MeshOptions meshOptionsOf(const py::dict& named)
{
    MeshOptions options;
    for (const auto& [key, value] : named) {
        const std::string name = key.cast<std::string>();
        const auto setter = setters().find(name);
        if (setter == setters().end()) throw py::type_error("mesh() has no option '" + name + "'");
        if (value.is_none()) continue;
        try {
            setter->second(options, value);
        } catch (const py::cast_error&) {
            throw py::type_error(name + ": " + py::repr(value).cast<std::string>() + " is of the wrong kind");
        }
    }
    return options;
}

}  // namespace mesher::python
