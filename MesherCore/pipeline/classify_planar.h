#pragma once

#include "brep/planar_curve_complex.h"
#include "mesh/classified_mesh.h"
#include "mesh/curved_boundary.h"
#include "triangulation2d/planar_triangulation.h"

namespace mesher {

/// A finished plane mesh and what its boundary edges are on their exact curves.
struct PlanarMesh
{
    ClassifiedMesh mesh;
    CurvedBoundary boundary;  ///< an edge for each line of the mesh, in the same order
};

/// Takes the meshed regions out of a triangulation: nodes in the order of its vertices, lines by edge and parameter, triangles
/// counterclockwise in the complex's plane. Nodes on points and curves have the exact places of those; the parameters of nodes
/// inside of a face are their coordinates in the complex's plane.
/// Cost         linear, and a sort of the lines
[[nodiscard]] PlanarMesh classifyPlanar(const PlanarCurveComplex& complex,
                                        const PlanarTriangulation& triangulation, int boundaryOrder);

}  // namespace mesher
