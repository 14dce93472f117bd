#pragma once

#include "base/result.h"
#include "mesh/classified_mesh.h"

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace mesher {

/// A number at each node of a mesh, e.g. a size.
struct NodalField
{
    std::string name;
    std::vector<double> values;  ///< by node
};

struct MeshFile
{
    ClassifiedMesh mesh;
    std::vector<NodalField> fields;
};

/// Reads Gmsh 4.1 and 2.2 ASCII (.msh) and VTK XML unstructured grids (.vtu: text, base64 or raw, plain or zlib) with points,
/// lines, triangles and linear tetrahedra. It shares nothing with the writers and believes nothing of what a file says about
/// itself.
/// Guarantees   nodes in the order of their tags (.msh) or of the file (.vtu); elements in the order of the file; entities from
///              physical groups named Vertex1, Edge1, Face1, Solid1 and the like, else from the tags of the entities
/// Refuses      with ErrorCode::Unreadable, the path and the line or offset: a missing, truncated or otherwise broken file, other
///              versions, big-endian data, elements of other kinds
/// Cost         linear in the size of the file; memory is taken for what is there, not for what is announced
[[nodiscard]] Result<MeshFile> readMesh(const std::filesystem::path& path);

/// The same from memory; `extension` (".msh", ".vtu") tells the format.
[[nodiscard]] Result<MeshFile> readMeshText(std::string_view content, std::string_view extension);

}  // namespace mesher
