#pragma once

#include "base/box.h"

namespace mesher {

/// Error bounds of the 2D predicates that hold for all points of one box: a determinant of larger magnitude
/// has the right sign. A default-made filter decides nothing, which is always correct.
struct StaticFilter2d
{
    double orient2d = std::numeric_limits<double>::infinity();
    double incircle = std::numeric_limits<double>::infinity();

    /// Units: model units; `box` must contain every point that is later handed in with this filter.
    static StaticFilter2d forBox(const Box2& box);
};

/// The same for the 3D predicates.
struct StaticFilter3d
{
    double orient3d = std::numeric_limits<double>::infinity();
    double insphere = std::numeric_limits<double>::infinity();

    static StaticFilter3d forBox(const Box3& box);
};

}  // namespace mesher
