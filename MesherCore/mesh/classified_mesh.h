#pragma once

#include "base/id_vector.h"
#include "base/ids.h"
#include "base/vec.h"
#include "brep/brep_ids.h"

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace mesher {

/// A node of a finished mesh.
using NodeId = Id<struct NodeTag>;

/// The entity of the model that a mesh entity lies on: the lowest-dimensional one. `index` counts from 0 within its
/// dimension (0 Vertex, 1 Edge, 2 Face, 3 Solid).
struct EntityRef
{
    static constexpr std::uint32_t kNone = 0xFFFFFFFFu;

    std::uint8_t dimension = 3;
    std::uint32_t index = kNone;

    friend constexpr auto operator<=>(const EntityRef&, const EntityRef&) = default;
};

/// "Vertex1", "Edge3", "Face6", "Solid1"; empty without an entity.
[[nodiscard]] std::string nameOf(EntityRef entity);
/// The entity of such a name; nothing if it is none.
[[nodiscard]] std::optional<EntityRef> entityNamed(std::string_view name);

struct MeshNode
{
    Vec3 position;  ///< model units
    EntityRef entity;
    /// On an edge the curve's parameter in x; on a face the surface's parameters; else unused.
    Vec2 parameters;
};

/// A mesh element of N nodes and the entity it lies on.
template <std::size_t N>
struct MeshElement
{
    std::array<NodeId, N> node;
    EntityRef entity;
};

/// A finished mesh as it is handed to writers, solvers and people: nodes and elements of each dimension, each with its
/// entity of the model. Triangles of faces with one solid look outward, tetrahedra are positively oriented, lines run along
/// their edge's parameter.
struct ClassifiedMesh
{
    IdVector<NodeId, MeshNode> nodes;
    std::vector<MeshElement<1>> points;  ///< one for each model vertex that is a node
    std::vector<MeshElement<2>> lines;
    std::vector<MeshElement<3>> triangles;
    std::vector<MeshElement<4>> tets;
    std::string unit = "mm";
    std::string title;
};

}  // namespace mesher
