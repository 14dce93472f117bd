#pragma once

#include "base/ids.h"
#include "brep/brep_ids.h"
#include "mesh/surface_mesh.h"

#include <algorithm>
#include <array>
#include <compare>

namespace mesher {

/// The two faces of a wall, and the solid that it is part of.
struct WallSides
{
    std::array<BrepFaceId, 2> face;  ///< ascending; the same twice where a face comes near to itself
    RegionId region;

    friend auto operator<=>(const WallSides&, const WallSides&) = default;

    [[nodiscard]] static WallSides of(BrepFaceId a, BrepFaceId b, RegionId region)
    {
        return {{std::min(a, b), std::max(a, b)}, region};
    }
};

/// A facet on a side of a wall that is kept flat, with as few tetrahedra as its facets allow.
struct FlatWallFacet
{
    FacetId facet;
    WallSides sides;
    double thickness = 0.0;  ///< of the wall behind the middle of the facet, model units
    Vec3 middle;             ///< model units
};

}  // namespace mesher
