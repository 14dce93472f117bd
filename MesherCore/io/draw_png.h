#pragma once

#include "base/box.h"
#include "base/result.h"
#include "io/png_file.h"
#include "mesh/classified_mesh.h"

#include <cstddef>
#include <optional>

namespace mesher {

/// What is shown of a mesh in space.
enum class DrawnPart
{
    SurfaceAndCut,  ///< beside each other; the surface alone without tetrahedra
    Surface,
    Cut  ///< the whole elements on the far side of a plane
};

struct DrawingOptions
{
    std::size_t width = 1600;    ///< pixels, 64 … 16384; the height follows from the mesh, up to the same
    double edgeWidth = 1.0;      ///< of the edges of triangles, pixels
    double boundaryWidth = 2.5;  ///< of the lines of the mesh, pixels
    /// The part of the picture's plane to be drawn, model units (x and y of a mesh in a plane z = constant); else all.
    std::optional<Box2> window;
    /// \name Of a mesh in space
    ///@{
    DrawnPart part = DrawnPart::SurfaceAndCut;
    std::optional<std::size_t>
        cutAxis{};  ///< 0, 1, 2 for a plane across x, y, z; else across the shorter of x and y
    std::optional<double> cutAt{};  ///< the plane's coordinate; else the middle
    ///@}
};

/// Draws a mesh: the triangles and lines of a plane one from its front, any other in space (drawInSpace), its surface beside a
/// cut. Each face has a colour of its own; edges fade where they come close, so that a fine mesh does not become black.
/// Refuses  a mesh without triangles and tetrahedra; widths outside of their range; a window without area; nodes not finite
[[nodiscard]] Result<Image> drawMesh(const ClassifiedMesh& mesh, const DrawingOptions& options = {});

}  // namespace mesher
