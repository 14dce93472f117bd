#pragma once

#include "base/vec.h"
#include "io/png_file.h"

#include <array>
#include <cstddef>
#include <vector>

namespace mesher {

/// A triangle on the picture: x and y in pixels from the top left, z towards the eye.
struct RasterTriangle
{
    std::array<Vec3, 3> corner;
    Colour colour;
    /// Of the line from corner k to corner k + 1: its width inside the triangle (pixels, 0 for none), colour and opacity.
    std::array<double, 3> lineWidth{};
    std::array<Colour, 3> lineColour{};
    std::array<double, 3> lineOpacity{};
};

/// A picture on which near triangles hide far ones, pixel by pixel.
/// Guarantees   the picture does not depend on the order of triangles, except where two are equally near: the first one stays
/// Cost         the pixels of each triangle's box; 11 bytes a pixel
class DepthRaster
{
public:
    DepthRaster(std::size_t width, std::size_t height, Colour background);

    void draw(const RasterTriangle& triangle);
    /// The picture made smaller, a mean of factor x factor pixels each.
    [[nodiscard]] Image reduced(std::size_t factor) const;
    [[nodiscard]] const Image& image() const { return image_; }

private:
    Image image_;
    std::vector<float> depth_;
};

}  // namespace mesher
