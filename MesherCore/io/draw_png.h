#pragma once

#include "base/box.h"
#include "base/result.h"
#include "io/png_file.h"
#include "mesh/classified_mesh.h"

#include <cstddef>
#include <optional>

namespace mesher {

struct DrawingOptions
{
    std::size_t width = 1600;    ///< pixels, 64 … 16384; the height follows from the mesh, up to the same
    double edgeWidth = 1.0;      ///< of the edges of triangles, pixels
    double boundaryWidth = 2.5;  ///< of the lines of the mesh, pixels
    /// The part of the picture's plane to be drawn, model units (x and y of a mesh in a plane z = constant); else all.
    std::optional<Box2> window;
};

/// Draws the triangles and lines of a mesh: a plane one from its front, any other from the direction (1, -1.2, 0.9), far parts
/// first. Each face has a colour of its own; edges fade where they come close, so that a fine mesh does not become black.
/// Refuses  a mesh without triangles; widths outside of their range; a window without area
[[nodiscard]] Result<Image> drawMesh(const ClassifiedMesh& mesh, const DrawingOptions& options = {});

}  // namespace mesher
