#pragma once

#include "base/vec.h"
#include "io/png_file.h"
#include "mesh/classified_mesh.h"

#include <array>
#include <cmath>
#include <cstdint>

namespace mesher {

/// \name How pictures of meshes look
///@{
inline constexpr Colour kBackground = {255, 255, 255};
inline constexpr Colour kEdgeColour = {60, 66, 80};
inline constexpr Colour kBoundaryColour = {12, 16, 28};
inline constexpr double kMargin = 24.0;           // pixels
inline constexpr double kFullyDrawnLength = 6.0;  // pixels: shorter edges fade
inline constexpr double kFaintestEdge = 0.12;
inline constexpr std::array<Colour, 8> kEntityColours = {{{176, 205, 232},
                                                          {247, 208, 158},
                                                          {186, 222, 178},
                                                          {233, 184, 184},
                                                          {206, 194, 228},
                                                          {240, 232, 160},
                                                          {170, 220, 218},
                                                          {222, 204, 188}}};
///@}

[[nodiscard]] inline Colour colourOf(EntityRef entity)
{
    return kEntityColours[entity.index % kEntityColours.size()];
}

/// The colour under a light, from 0 to 1.
[[nodiscard]] inline Colour lit(Colour colour, double light)
{
    const auto dim = [light](std::uint8_t value) {
        return static_cast<std::uint8_t>(std::lround(light * value));
    };
    return {dim(colour.red), dim(colour.green), dim(colour.blue)};
}

/// Two axes of the picture and the direction towards the eye, which is at infinity.
struct View
{
    Vec3 right;
    Vec3 up;
    Vec3 towardsEye;

    [[nodiscard]] Vec2 projected(const Vec3& p) const { return {dot(p, right), dot(p, up)}; }
};

/// What points up (along z) in the model points up in the picture, unless one looks along it.
[[nodiscard]] inline View viewAlong(const Vec3& direction)
{
    const auto normalised = [](const Vec3& v) { return (1.0 / length(v)) * v; };
    const Vec3 eye = normalised(direction);
    const Vec3 up = std::abs(eye.z) > 0.99 ? Vec3{0.0, 1.0, 0.0} : Vec3{0.0, 0.0, 1.0};
    const Vec3 right = normalised(cross(up, eye));
    return {right, cross(eye, right), eye};
}

}  // namespace mesher
