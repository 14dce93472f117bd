#pragma once

#include "base/vec.h"
#include "mesh/classified_mesh.h"

#include <array>
#include <string>
#include <vector>

namespace mesher {

/// A Gauss point on the exact curve.
struct CurvedBoundaryPoint
{
    double parameter = 0.0;
    Vec3 position;  ///< on the curve, model units
    Vec3 normal;    ///< unit, in the plane of the mesh, to the right of the growing parameter
    double weight =
        0.0;  ///< of arc length: the weights of an edge sum to its length up to the order of the rule
    double curvature = 0.0;  ///< 1 / model units, positive where the curve turns to the left
};

/// A line of the mesh with what flux integration along its exact curve needs.
struct CurvedBoundaryEdge
{
    EntityRef curve;
    std::array<NodeId, 2> node;
    std::array<double, 2> parameter{};  ///< of the nodes on the curve
    EntityRef left;                     ///< face to the left of the growing parameter; none outside
    EntityRef right;
    std::vector<CurvedBoundaryPoint> points;
    /// The same for each half, cut at the mean parameter: control volumes around nodes have half an edge each.
    std::array<std::vector<CurvedBoundaryPoint>, 2> halves;
};

/// What high-order solvers need of a curved boundary.
/// Reference  [gosselin] section 1.1.3, figure 1.1
struct CurvedBoundary
{
    int order = 4;  ///< of accuracy of the solver
    std::string unit = "mm";
    std::vector<CurvedBoundaryEdge> edges;
};

}  // namespace mesher
