#pragma once

#include "triangulation2d/boundary.h"
#include "triangulation2d/boundary_index.h"

#include <vector>

namespace mesher {

/// Which side of a directed curve or edge.
enum class CurveSide
{
    Left,
    Right,
    On
};

/// The side of the boundary edge's straight line; exact.
[[nodiscard]] CurveSide sideOfEdge(const Boundary& boundary, SubcurveId s, Vec2 point);

/// The side of the subcurve itself, for a point in the edge's diametral circle. A subcurve that turns by at most 90 degrees
/// is a graph over its edge, so the side is told by the curve's height at the point's foot.
/// A point on the curve up to rounding counts as being on the side of the edge where it is.
[[nodiscard]] CurveSide sideOfSubcurve(const PlanarDomain& domain, const Boundary& boundary, SubcurveId s,
                                       Vec2 point);

/// Whether a vertex in the diametral circle of a boundary edge is visible from the edge. It also is if it proves that the
/// edge crosses another one, as the edge has to be split then all the same.
/// Not visible  across an unmeshed region; or where both lines of sight to the edge's ends are crossed by boundary edges
/// Reference    thesis Algorithm 2.2; [gosselin] section 2.4.2
class Visibility2d
{
public:
    Visibility2d(const PlanarDomain& domain, const Boundary& boundary, const BoundaryIndex& index)
        : domain_(domain), boundary_(boundary), index_(index)
    {
    }

    [[nodiscard]] bool isVisible(BoundaryVertexId v, SubcurveId from);

private:
    [[nodiscard]] bool isSightBlocked(Vec2 point, SubcurveId from);

    const PlanarDomain& domain_;
    const Boundary& boundary_;
    const BoundaryIndex& index_;
    std::vector<SubcurveId> near_;
};

}  // namespace mesher
