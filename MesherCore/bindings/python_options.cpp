#include "bindings/python_options.h"

#include "bindings/python_error.h"

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

void setOverlap(MeshOptions& options, py::handle value)
{
    const std::string name = valueOf<std::string>(value);
    const std::optional<OverlapChoice> choice = overlapChoiceOf(name);
    if (!choice)
        raise("OptionError", {ErrorCode::InvalidArgument,
                              "'" + name + "' is no way with solids that overlap",
                              "overlap",
                              {},
                              "give separate or refuse"});
    options.overlap = *choice;
}

void setMeasure(MeshOptions& options, py::handle value)
{
    const std::string key = valueOf<std::string>(value);
    const std::optional<TetMeasure> measure = tetMeasureOf(key);
    if (!measure)
        raise("OptionError", {ErrorCode::InvalidArgument,
                              "'" + key + "' is no measure",
                              "measure",
                              {},
                              "give one of q1 ... q8"});
    options.measure = *measure;
}

template <class Value>
Value itemOf(const py::sequence& items, std::size_t i)
{
    return valueOf<Value>(py::object(items[i]));
}

/// A list of pairs would be taken for one as well.
py::dict dictOf(py::handle value)
{
    if (!py::isinstance<py::dict>(value)) throw py::cast_error();
    return py::reinterpret_borrow<py::dict>(value);
}

Vec3 pointOf(py::handle value)
{
    const auto numbers = valueOf<py::sequence>(value);
    if (numbers.size() != 3) throw py::cast_error();
    return {itemOf<double>(numbers, 0), itemOf<double>(numbers, 1), itemOf<double>(numbers, 2)};
}

/// The items of a sequence that has `least` of them, or one more.
py::sequence itemsOf(py::handle value, std::size_t least)
{
    const auto items = valueOf<py::sequence>(value);
    if (items.size() != least && items.size() != least + 1) throw py::cast_error();
    return items;
}

std::optional<double> growthAt(const py::sequence& items, std::size_t i)
{
    return items.size() > i ? std::optional<double>(itemOf<double>(items, i)) : std::nullopt;
}

void setFaces(MeshOptions& options, py::handle value)
{
    // A text is a sequence, too, of letters.
    if (py::isinstance<py::str>(value)) throw py::cast_error();
    for (const auto& name : valueOf<py::sequence>(value)) options.faces.push_back(valueOf<std::string>(name));
}

void setLocalSizes(MeshOptions& options, py::handle value)
{
    for (const auto& [entity, size] : dictOf(value))
        options.localSizes.push_back({valueOf<std::string>(entity), valueOf<double>(size)});
}

void setDistanceSizes(MeshOptions& options, py::handle value)
{
    for (const auto& [entity, wish] : dictOf(value)) {
        const py::sequence items = itemsOf(wish, 2);
        options.distanceSizes.push_back({valueOf<std::string>(entity), itemOf<double>(items, 0),
                                         itemOf<double>(items, 1), growthAt(items, 2).value_or(0.0)});
    }
}

void setBoxSizes(MeshOptions& options, py::handle value)
{
    for (const auto& wish : valueOf<py::sequence>(value)) {
        const py::sequence items = itemsOf(wish, 3);
        options.boxSizes.push_back({pointOf(py::object(items[0])), pointOf(py::object(items[1])),
                                    itemOf<double>(items, 2), growthAt(items, 3)});
    }
}

void setBallSizes(MeshOptions& options, py::handle value)
{
    for (const auto& wish : valueOf<py::sequence>(value)) {
        const py::sequence items = itemsOf(wish, 3);
        options.ballSizes.push_back({pointOf(py::object(items[0])), itemOf<double>(items, 1),
                                     itemOf<double>(items, 2), growthAt(items, 3)});
    }
}

/// Sizes in files and arrays are read by sizingFieldOf.
void leaveAlone(MeshOptions&, py::handle) {}

const std::map<std::string, Setter>& setters()
{
    static const std::map<std::string, Setter> all = {
        {"dimension", setterOf(&MeshOptions::dimension)},
        {"faces", setFaces},
        {"size", setterOf(&MeshOptions::size)},
        {"min_size", setterOf(&MeshOptions::minSize)},
        {"curvature", setterOf(&MeshOptions::curvature)},
        {"sag", setterOf(&MeshOptions::sag)},
        {"refinement", setterOf(&MeshOptions::refinement)},
        {"grading", setterOf(&MeshOptions::grading)},
        {"local_sizes", setLocalSizes},
        {"size_distance", setDistanceSizes},
        {"size_box", setBoxSizes},
        {"size_ball", setBallSizes},
        {"size_formula", setterOf(&MeshOptions::sizeFormula)},
        {"size_points", leaveAlone},
        {"background", leaveAlone},
        {"min_angle", setterOf(&MeshOptions::minAngle)},
        {"max_turn", setterOf(&MeshOptions::maxTurn)},
        {"measure", setMeasure},
        {"threshold", setterOf(&MeshOptions::threshold)},
        {"max_dihedral", setterOf(&MeshOptions::maxDihedral)},
        {"lambda_", setterOf(&MeshOptions::lambda)},
        {"improve", setterOf(&MeshOptions::isImproved)},
        {"order", setterOf(&MeshOptions::order)},
        {"threads", setterOf(&MeshOptions::threads)},
        {"max_elements", setterOf(&MeshOptions::maxElements)},
        {"max_wall_elements", setterOf(&MeshOptions::maxWallElements)},
        {"overlap", setOverlap},
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
        if (setter == setters().end()) throw py::type_error("there is no option '" + name + "'");
        if (value.is_none()) continue;
        try {
            setter->second(options, value);
        } catch (const py::cast_error&) {
            throw py::type_error(name + ": " + py::repr(value).cast<std::string>() +
                                 " is of the wrong kind; see help(mesher.mesh)");
        }
    }
    return options;
}

}  // namespace mesher::python
