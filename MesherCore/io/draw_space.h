#pragma once

#include "io/draw_png.h"

namespace mesher {

/// Draws a mesh in space from the direction (1, -1.2, 0.9), lit from beside the eye: near facets hide far ones, each shows its
/// edges, lines of the mesh are drawn wider. Facets of the model's faces have a colour each, cut-open elements that of their
/// solid. Edges fade where they come close.
/// Requires     finite nodes, options that drawMesh takes
/// Guarantees   the same picture for the same mesh
[[nodiscard]] Image drawInSpace(const ClassifiedMesh& mesh, const DrawingOptions& options);

}  // namespace mesher
