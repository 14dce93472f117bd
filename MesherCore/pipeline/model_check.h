#pragma once

#include "brep/brep_model.h"
#include "mesh/classified_mesh.h"

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace mesher {

/// How a mesh lies on the model it was made of.
struct ModelCheckReport
{
    std::array<double, 3>
        largestDistance{};  ///< of nodes on vertices, edges, faces from their own entity; model units
    std::array<std::string, 3> farthestEntity;
    std::uint64_t nodesOff = 0;         ///< further than max(1e-7, tolerance of the entity)
    std::uint64_t unknownEntities = 0;  ///< nodes and elements on an entity that the model does not have
    std::uint64_t missingVertices = 0;  ///< vertices of meshed faces and edges that are no node
    std::uint64_t trianglesOff = 0;     ///< with a node that is not on their face

    [[nodiscard]] bool isValid() const
    {
        return nodesOff + unknownEntities + missingVertices + trianglesOff == 0;
    }
    [[nodiscard]] std::vector<std::string> problems() const;
};

/// Measures each node against the exact geometry of its own entity, and looks whether triangles name the face they lie on.
/// Cost         a closest-point search on a curve or surface for each node of the boundary
[[nodiscard]] ModelCheckReport checkAgainstModel(const ClassifiedMesh& mesh, const BrepModel& model);

}  // namespace mesher
