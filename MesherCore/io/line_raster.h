#pragma once

#include "base/vec.h"
#include "io/png_file.h"

#include <array>
#include <cstddef>

namespace mesher {

struct PixelRange
{
    std::size_t first = 0;
    std::size_t last = 0;  ///< one behind the last
};

/// The pixels, of a row or column of `count`, whose centres are in [low, high].
[[nodiscard]] PixelRange pixelsBetween(double low, double high, std::size_t count);

/// `over` laid on `under`, covering this share of it.
[[nodiscard]] Colour mixed(Colour under, Colour over, double share);

/// Draws a line with soft edges; `width` in pixels, `opacity` in (0, 1]. Pixel (x, y) has its centre at (x + 0.5, y + 0.5); what
/// lies outside of the image is left away.
void drawLine(Image& image, Vec2 from, Vec2 to, double width, Colour colour, double opacity);

/// Fills the pixels whose centres lie in the triangle or on its boundary, whatever its orientation.
void fillTriangle(Image& image, const std::array<Vec2, 3>& corners, Colour colour);

}  // namespace mesher
