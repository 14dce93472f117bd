#pragma once

#include "base/vec.h"
#include "io/png_file.h"

#include <array>

namespace mesher {

/// Draws a line with soft edges; `width` in pixels, `opacity` in (0, 1]. Pixel (x, y) has its centre at (x + 0.5, y + 0.5); what
/// lies outside of the image is left away.
void drawLine(Image& image, Vec2 from, Vec2 to, double width, Colour colour, double opacity);

/// Fills the pixels whose centres lie in the triangle or on its boundary, whatever its orientation.
void fillTriangle(Image& image, const std::array<Vec2, 3>& corners, Colour colour);

}  // namespace mesher
