#pragma once

#include "mesh/surface_mesh.h"

namespace mesher::test {

/// Writes a surface mesh whose ids are all alive as TetGen's input, each triangle a facet of its own. Nothing if the file cannot be
/// opened.
void writePoly(const SurfaceMesh& mesh, const char* path);

}  // namespace mesher::test
