#pragma once

#include "base/vec.h"

#include <optional>
#include <string>

namespace mesher {

/// An element size asked for on one entity of the model; beyond it sizes grow by distance / grading.
struct LocalSize
{
    std::string entity;  ///< "Face6", "Edge3", "Vertex1", "Solid1"
    double size = 0.0;   ///< model units, above 0
};

/// A size in an axis-aligned box, which may be flat, given by two opposite corners in any order.
struct SizeInBox
{
    Vec3 first;
    Vec3 last;
    double size = 0.0;             ///< model units, above 0
    std::optional<double> growth;  ///< of the size per unit of distance outside; >= 0. DEFAULT: 1 / grading
};

/// A size in a ball.
struct SizeInBall
{
    Vec3 centre;
    double radius = 0.0;           ///< model units, above 0
    double size = 0.0;             ///< model units, above 0
    std::optional<double> growth;  ///< of the size per unit of distance outside; >= 0. DEFAULT: 1 / grading
};

/// A size by the distance to an entity of the model: `size` up to `plateau`, then growing by `growth` per unit of distance.
struct SizeByDistance
{
    std::string entity;    ///< "Face6", "Edge3", "Vertex1"
    double size = 0.0;     ///< model units, above 0
    double growth = 0.0;   ///< >= 0
    double plateau = 0.0;  ///< model units, >= 0
};

}  // namespace mesher
