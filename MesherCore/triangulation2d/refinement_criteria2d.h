#pragma once

#include "triangulation2d/delaunay_refinement2d.h"
#include "triangulation2d/triangle_shape2d.h"

namespace mesher {

enum class RefinementNeed2d
{
    Nothing,
    Size,
    Quality
};

/// What a triangle needs, and how urgently: the larger the key, the worse.
struct RefinementVerdict2d
{
    RefinementNeed2d need = RefinementNeed2d::Nothing;
    double key = 0.0;
};

/// Decides which triangles and subcurves are to be refined.
/// Reference    thesis sections 2.4.3 (too large, too long) and 2.5 (triangles that span a small angle are left alone)
class RefinementCriteria2d
{
public:
    RefinementCriteria2d(const PlanarDomain& domain, const RefinementOptions2d& options,
                         const PlanarTriangulation& triangulation);

    /// Smallest angle wanted from now on, degrees; 0 asks for none.
    void setMinAngle(double minAngle);

    /// Of a meshed triangle.
    [[nodiscard]] RefinementVerdict2d judge(TriangleId t) const;
    [[nodiscard]] bool isTooLong(SubcurveId s) const;
    [[nodiscard]] SmallAngleId smallAngleSpannedBy(TriangleId t) const;
    [[nodiscard]] bool hasSmallAngle(const TriangleShape2d& shape) const
    {
        return shape.squaredRatio() > squaredBound_;
    }
    /// The small angle between whose curves the triangle's shortest edge lies, both ends on one shell; else invalid.
    [[nodiscard]] SmallAngleId smallAngleSpannedBy(const Triangle2d& record,
                                                   const TriangleShape2d& shape) const;

private:
    [[nodiscard]] double squaredFieldBound(Vec2 a, Vec2 b, Vec2 c, const TriangleShape2d& shape,
                                           double known) const;

    const PlanarDomain& domain_;
    const PlanarSizing& sizing_;
    const PlanarTriangulation& t_;
    const Triangulation2d& mesh_;
    bool hasSizing_;
    bool hasField_;
    double squaredBound_ = 0.0;
};

}  // namespace mesher
