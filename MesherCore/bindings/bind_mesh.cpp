#include "bindings/bindings.h"
#include "bindings/python_error.h"
#include "io/mesh_writer.h"
#include "mesh/classified_mesh.h"
#include "mesh/classified_mesh_hash.h"
#include "mesh/mesh_check.h"

#include <pybind11/numpy.h>
#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include <cmath>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

namespace mesher::python {

namespace py = pybind11;

namespace {

using SharedMesh = std::shared_ptr<ClassifiedMesh>;

static_assert(sizeof(NodeId) == sizeof(std::uint32_t), "views show node ids as plain integers");
static_assert(sizeof(Vec3) == 3 * sizeof(double), "views show positions as rows of three numbers");

/// A read-only view of `rows` x `columns` values that lie `stride` bytes apart; it keeps the mesh alive.
template <class Value>
py::array viewOf(const Value* first, std::size_t rows, std::size_t columns, std::size_t stride,
                 const SharedMesh& mesh)
{
    const py::capsule owner(new SharedMesh(mesh), [](void* kept) { delete static_cast<SharedMesh*>(kept); });
    py::array_t<Value> view({rows, columns}, {stride, sizeof(Value)}, first, owner);
    view.attr("setflags")(py::arg("write") = false);
    return view;
}

template <class Value>
py::array columnOf(const Value* first, std::size_t rows, std::size_t stride, const SharedMesh& mesh)
{
    return viewOf(first, rows, 1, stride, mesh).attr("reshape")(rows);
}

py::array nodesOf(const SharedMesh& mesh)
{
    static const MeshNode none;
    const MeshNode& first = mesh->nodes.empty() ? none : mesh->nodes[NodeId(0)];
    return viewOf(&first.position.x, mesh->nodes.size(), 3, sizeof(MeshNode), mesh);
}

template <std::size_t N>
py::array elementsOf(const std::vector<MeshElement<N>>& elements, const SharedMesh& mesh)
{
    static const MeshElement<N> none;
    const MeshElement<N>& first = elements.empty() ? none : elements.front();
    return viewOf(&first.node.front().value, elements.size(), N, sizeof(MeshElement<N>), mesh);
}

template <std::size_t N>
py::array entitiesOf(const std::vector<MeshElement<N>>& elements, const SharedMesh& mesh)
{
    static const MeshElement<N> none;
    const MeshElement<N>& first = elements.empty() ? none : elements.front();
    return columnOf(&first.entity.index, elements.size(), sizeof(MeshElement<N>), mesh);
}

template <class Member>
py::array nodeColumn(const SharedMesh& mesh, Member member)
{
    static const MeshNode none;
    const MeshNode& first = mesh->nodes.empty() ? none : mesh->nodes[NodeId(0)];
    return columnOf(&(first.entity.*member), mesh->nodes.size(), sizeof(MeshNode), mesh);
}

void writeTo(const SharedMesh& mesh, const std::filesystem::path& path, const std::string& format,
             const std::string& groups)
{
    const std::optional<GroupChoice> choice = groupChoiceOf(groups);
    if (!choice) throw py::value_error("groups is 'bounding' or 'all', not '" + groups + "'");
    const Result<void> written = [&] {
        const py::gil_scoped_release released;
        return writeMesh(*mesh, path, format, {*choice});
    }();
    if (!written) raise("WriteError", written.error());
}

template <class Value>
using Rows = py::array_t<Value, py::array::c_style | py::array::forcecast>;

void addNodes(ClassifiedMesh& mesh, const Rows<double>& places)
{
    if (places.ndim() != 2 || places.shape(1) != 3) throw py::value_error("nodes are rows of three numbers");
    const auto rows = places.unchecked<2>();
    for (py::ssize_t i = 0; i < rows.shape(0); ++i) {
        const Vec3 place{rows(i, 0), rows(i, 1), rows(i, 2)};
        if (!std::isfinite(place.x) || !std::isfinite(place.y) || !std::isfinite(place.z))
            throw py::value_error("node " + std::to_string(i) + " has a coordinate that is no finite number");
        mesh.nodes.push_back({place, EntityRef{}, {}});
    }
}

/// Of a node that is on another entity: where it is on two of one dimension, it is on what they meet in, which nobody names.
void joinEntities(EntityRef& known, EntityRef other)
{
    if (known.dimension < other.dimension || known == other) return;
    const bool isFirst = known.dimension > other.dimension || known.index == EntityRef::kNone;
    known = isFirst ? other : EntityRef{static_cast<std::uint8_t>(other.dimension - 1), EntityRef::kNone};
}

/// Elements of N nodes each, on the entities of one dimension; their nodes are on these as far as no other has them.
template <std::size_t N>
void addElements(ClassifiedMesh& mesh, std::vector<MeshElement<N>>& elements,
                 const Rows<std::int64_t>& corners, const Rows<std::int64_t>& entities)
{
    constexpr auto kDimension = static_cast<std::uint8_t>(N - 1);
    if (entities.size() == 0 && corners.size() == 0) return;
    if (corners.ndim() != 2 || corners.shape(1) != N || entities.ndim() != 1 ||
        entities.shape(0) != corners.shape(0))
        throw py::value_error("elements are rows of " + std::to_string(N) + " nodes, with an entity each");
    const auto rows = corners.template unchecked<2>();
    const auto owners = entities.template unchecked<1>();
    for (py::ssize_t i = 0; i < rows.shape(0); ++i) {
        if (owners(i) < 0 || owners(i) >= EntityRef::kNone) throw py::value_error("entities count from 0");
        MeshElement<N> element{{}, {kDimension, static_cast<std::uint32_t>(owners(i))}};
        for (std::size_t k = 0; k < N; ++k) {
            const std::int64_t node = rows(i, static_cast<py::ssize_t>(k));
            if (node < 0 || node >= static_cast<std::int64_t>(mesh.nodes.size()))
                throw py::index_error("node " + std::to_string(node) +
                                      " of an element is none of the mesh's");
            element.node[k] = NodeId(static_cast<std::uint32_t>(node));
            joinEntities(mesh.nodes[element.node[k]].entity, element.entity);
        }
        elements.push_back(element);
    }
}

/// A mesh that others have made.
SharedMesh meshOfArrays(const Rows<double>& nodes, const Rows<std::int64_t>& triangles,
                        const Rows<std::int64_t>& triangleFaces, const Rows<std::int64_t>& tets,
                        const Rows<std::int64_t>& tetSolids)
{
    auto mesh = std::make_shared<ClassifiedMesh>();
    addNodes(*mesh, nodes);
    addElements(*mesh, mesh->tets, tets, tetSolids);
    addElements(*mesh, mesh->triangles, triangles, triangleFaces);
    return mesh;
}

std::vector<std::string> problemsOf(const SharedMesh& mesh)
{
    const py::gil_scoped_release released;
    return checkMesh(*mesh).problems();
}

}  // namespace

void bindMesh(py::module_& module)
{
    py::class_<ClassifiedMesh, SharedMesh>(module, "Mesh", py::dynamic_attr())
        .def_property_readonly("nodes", &nodesOf)
        .def_property_readonly("node_dimension",
                               [](const SharedMesh& mesh) { return nodeColumn(mesh, &EntityRef::dimension); })
        .def_property_readonly("node_entity",
                               [](const SharedMesh& mesh) { return nodeColumn(mesh, &EntityRef::index); })
        .def_property_readonly("points",
                               [](const SharedMesh& mesh) { return elementsOf(mesh->points, mesh); })
        .def_property_readonly("lines", [](const SharedMesh& mesh) { return elementsOf(mesh->lines, mesh); })
        .def_property_readonly("triangles",
                               [](const SharedMesh& mesh) { return elementsOf(mesh->triangles, mesh); })
        .def_property_readonly("tets", [](const SharedMesh& mesh) { return elementsOf(mesh->tets, mesh); })
        .def_property_readonly("point_vertex",
                               [](const SharedMesh& mesh) { return entitiesOf(mesh->points, mesh); })
        .def_property_readonly("line_edge",
                               [](const SharedMesh& mesh) { return entitiesOf(mesh->lines, mesh); })
        .def_property_readonly("triangle_face",
                               [](const SharedMesh& mesh) { return entitiesOf(mesh->triangles, mesh); })
        .def_property_readonly("tet_solid",
                               [](const SharedMesh& mesh) { return entitiesOf(mesh->tets, mesh); })
        .def_property_readonly("unit", [](const SharedMesh& mesh) { return mesh->unit; })
        .def_property_readonly("hash", [](const SharedMesh& mesh) { return classifiedMeshHash(*mesh); })
        .def_static("of_arrays", &meshOfArrays, py::arg("nodes"), py::arg("triangles"),
                    py::arg("triangle_face"), py::arg("tets") = Rows<std::int64_t>(0),
                    py::arg("tet_solid") = Rows<std::int64_t>(0))
        .def("check", &problemsOf)
        .def("write", &writeTo, py::arg("path"), py::arg("format") = "", py::arg("groups") = "bounding");
}

}  // namespace mesher::python
