#pragma once

#include "delaunay/constrained_tetrahedralization.h"
#include "refinement/thin_walls.h"

#include <vector>

namespace mesher {

/// The local feature size of each vertex, by its number: the least of its shortest edge, its distance from the edges opposite to
/// it in the facets around it, and from the facets opposite to it in the tetrahedra around it. kNoSize for vertices of no
/// tetrahedron of a solid. Tetrahedra in walls that are kept flat do not count.
/// Requires     a constrained Delaunay tetrahedralization of vertices on the boundary
/// Cost         linear
/// Units        those of the tetrahedralization
/// Reference    [gosselin] definition 4.2, section 4.4; chords and facets stand for curves and faces
[[nodiscard]] std::vector<double> localFeatureSizes(const Triangulation3d& mesh,
                                                    const ThinWalls* walls = nullptr);

/// The mean side of the facets around each vertex, by its number, of facets that bound a solid; kNoSize where there are none.
/// Cost         linear
/// Units        those of the tetrahedralization
[[nodiscard]] std::vector<double> meanFacetSides(const Triangulation3d& mesh);

}  // namespace mesher
