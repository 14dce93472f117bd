#pragma once

#include "base/run_context.h"
#include "mesh/classified_mesh.h"

#include <cstdint>
#include <map>
#include <string>
#include <vector>

namespace mesher {

/// What the check found. All counts of defects are 0 in a valid mesh.
struct MeshCheckReport
{
    struct Counts
    {
        std::uint64_t nodes = 0;
        std::uint64_t points = 0;
        std::uint64_t lines = 0;
        std::uint64_t triangles = 0;
        std::uint64_t tets = 0;
    } counts;

    // Nodes
    std::uint64_t badReferences = 0;  ///< elements with a node that does not exist, or one twice
    std::uint64_t nonFiniteNodes =
        0;  ///< a coordinate that is infinite, not a number, or too large for the exact tests
    std::uint64_t duplicateNodes = 0;  ///< at the place of another of the same connected part
    std::uint64_t orphanNodes = 0;     ///< in no element of the highest dimension
    std::uint64_t duplicateElements = 0;

    // Classification
    std::uint64_t unclassified = 0;  ///< elements and nodes without an entity
    std::uint64_t misclassified =
        0;  ///< elements on an entity of another dimension, or with a node that lies elsewhere
    std::uint64_t linesNotEdges = 0;            ///< of a triangle, in a mesh that has triangles
    std::uint64_t trianglesNotFaces = 0;        ///< of a tet, in a mesh that has tets
    std::uint64_t boundaryWithoutElement = 0;   ///< outer sides without a line or triangle
    std::uint64_t interfaceWithoutElement = 0;  ///< sides between two entities without one

    // Orientation and conformity
    std::uint64_t inverted = 0;    ///< tets, or triangles of a plane that look against the rest of their face
    std::uint64_t degenerate = 0;  ///< exactly flat tets, triangles without an area
    std::uint64_t overSharedSides =
        0;  ///< faces of more than two tets; edges of more than two triangles of one face
    std::uint64_t foldedSides = 0;  ///< both neighbours on the same side
    std::uint64_t openBoundaryEdges =
        0;  ///< edges with an odd number of boundary faces: the boundary is not closed
    std::uint64_t inwardTriangles = 0;  ///< outer triangles that look into their only tet

    // Measures
    std::map<std::uint32_t, double> areaOfFace;     ///< by index from 0, model units squared
    std::map<std::uint32_t, double> volumeOfSolid;  ///< model units cubed
    double area = 0.0;
    double volume = 0.0;
    /// Relative difference between the volume of the tets and that enclosed by their boundary: told apart, they overlap.
    double volumeGap = 0.0;

    [[nodiscard]] bool isValid() const { return problems().empty(); }
    /// One clause for each kind of defect, with its number.
    [[nodiscard]] std::vector<std::string> problems() const;
};

/// Checks a finished mesh on its own: it sees what anyone who reads the file sees, and knows nothing of how the mesh was made.
/// Signs are exact (predicates) where a sign decides; orientation of triangles is judged in faces whose nodes lie in a plane.
/// Cost  O(n log n); about 100 bytes for each side of an element
[[nodiscard]] MeshCheckReport checkMesh(const ClassifiedMesh& mesh);
/// Ends between two of its steps when the run is to end; the report is incomplete then.
[[nodiscard]] MeshCheckReport checkMesh(const ClassifiedMesh& mesh, RunContext& context);

}  // namespace mesher
