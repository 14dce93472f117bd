#pragma once

#include "io/file_buffer.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace mesher {

struct Colour
{
    std::uint8_t red = 0;
    std::uint8_t green = 0;
    std::uint8_t blue = 0;

    friend constexpr bool operator==(const Colour&, const Colour&) = default;
};

/// Pixels row by row from the top left.
struct Image
{
    Image(std::size_t imageWidth, std::size_t imageHeight, Colour background)
        : width(imageWidth), height(imageHeight), pixels(imageWidth * imageHeight, background)
    {
    }

    [[nodiscard]] Colour& at(std::size_t x, std::size_t y) { return pixels[y * width + x]; }
    [[nodiscard]] const Colour& at(std::size_t x, std::size_t y) const { return pixels[y * width + x]; }

    std::size_t width;
    std::size_t height;
    std::vector<Colour> pixels;
};

/// Portable Network Graphics (ISO/IEC 15948), 8 bits for each of red, green and blue.
void writePngFile(const Image& image, FileBuffer& out);

}  // namespace mesher
