#pragma once

#include "base/ids.h"
#include "brep/brep_ids.h"
#include "brep/curve.h"
#include "brep/plane_frame.h"

#include <array>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace mesher {

/// Index of a point and of a curve of a planar curve complex.
using PccPointId = Id<struct PccPointTag>;
using PccCurveId = Id<struct PccCurveTag>;

struct PccPoint
{
    Vec2 position;       ///< in the plane
    Vec3 spacePosition;  ///< exact, in model units
    BrepVertexId vertex;
};

/// A curve from one point to another, or closed from a point to itself. Seen along growing parameter the regions lie to its
/// left and right; region 0 is unmeshed: the exterior or a hole.
struct PccCurve
{
    std::shared_ptr<const Curve> curve;
    Interval part;
    PccPointId first;
    PccPointId last;
    RegionId left{0u};
    RegionId right{0u};
    BrepEdgeId edge;
};

/// Thesis Definition 2.1: points and piecewise smooth curves of a plane that meet only in points of the complex. Curves with
/// the same region on both sides are embedded in it; points on no curve are embedded points.
struct PlanarCurveComplex
{
    PlaneFrame frame;
    std::vector<PccPoint> points;
    std::vector<PccCurve> curves;
    /// Name of region r + 1, e.g. "Face6"; the regions are 1 … regionNames.size().
    std::vector<std::string> regionNames;
    /// The region of each embedded point, beside its id.
    struct EmbeddedPoint
    {
        PccPointId point;
        RegionId region;
    };
    std::vector<EmbeddedPoint> embeddedPoints;
};

/// Position and derivatives of a curve of the complex in its plane.
struct PlanarCurvePoint
{
    Vec2 position;
    Vec2 d1;
    Vec2 d2;
};

[[nodiscard]] inline PlanarCurvePoint evaluateInPlane(const PlanarCurveComplex& complex, PccCurveId curve,
                                                      double t)
{
    const CurvePoint p = complex.curves[curve.value].curve->evaluate(t);
    return {complex.frame.toPlane(p.position), complex.frame.directionToPlane(p.d1),
            complex.frame.directionToPlane(p.d2)};
}

}  // namespace mesher
