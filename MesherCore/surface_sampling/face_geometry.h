#pragma once

#include "base/vec.h"
#include "brep/brep_model.h"
#include "brep/surface.h"

#include <array>
#include <limits>
#include <memory>
#include <optional>

namespace mesher {

/// What the exact surface of a face tells about one of its points.
struct SurfaceFacts
{
    Vec2 parameters;
    Vec3 position;
    Vec3 normal;  ///< unit, along du x dv; zero where the surface has none, as at the apex of a cone
    double curvatureRadius = std::numeric_limits<double>::infinity();  ///< the least of the principal ones
    bool isSingularU = false;  ///< the position does not depend on u here
    bool isSingularV = false;
};

/// The centre of a facet's surface ball: the ball through its corners whose centre is on the surface.
struct SurfaceBallCentre
{
    SurfaceFacts facts;
    double height = 0.0;  ///< above the facet's plane, model units
};

/// The exact surface of one face, as its mesh asks it. A clone of the model's surface: one object per thread.
/// Units   model units; parameters are those of the surface
class FaceGeometry
{
public:
    explicit FaceGeometry(const BrepFace& face);

    [[nodiscard]] const Surface& surface() const { return *surface_; }
    /// By parameter; 0 where the surface is not periodic.
    [[nodiscard]] Vec2 periods() const { return periods_; }

    [[nodiscard]] bool isPlane() const { return isPlane_; }

    [[nodiscard]] SurfaceFacts at(Vec2 uv) const;
    /// The normal on which the line through the facet's circumcentre, along the facet's normal, meets the surface, found
    /// by Newton's method from `seed`. The position is exact; the centre is so up to a hundredth of `radius`.
    /// Terminates   after 6 steps; nothing if they do not converge, or leave the ball
    [[nodiscard]] std::optional<SurfaceBallCentre>
    ballCentre(const Vec3& circumcentre, const Vec3& unitNormal, double radius, Vec2 seed) const;
    /// The closest point reached from the seed.
    [[nodiscard]] SurfaceFacts projected(const Vec3& point, Vec2 seed) const;

    /// The point on the parameter line between two points that is as far from the one as from the other. It cannot leave the
    /// face past a boundary, as a projection of their middle can where the surface turns sharply.
    /// Terminates   after 12 bisections, by which the distances agree to a thousandth
    [[nodiscard]] SurfaceFacts between(Vec2 uvA, const Vec3& a, Vec2 uvB, const Vec3& b) const;

    /// Of three points in one image of the face; not so if their triangle is lower than a 10^-9th of its longest side, where
    /// the face's bounds measure 1 by 1.
    [[nodiscard]] bool isCounterClockwise(Vec2 a, Vec2 b, Vec2 c) const;

    /// The image of `uv` by whole periods that makes `near`, an image of its own point, fit to `target`.
    [[nodiscard]] Vec2 shiftBetween(Vec2 near, Vec2 target) const;

private:
    [[nodiscard]] SurfaceFacts factsOf(const SurfacePoint& point, Vec2 uv) const;
    void setFactsOfPole(SurfaceFacts& facts) const;
    [[nodiscard]] bool isInRange(Vec2 uv) const;

    std::unique_ptr<Surface> surface_;
    Vec2 periods_;
    Interval boundsU_;
    Interval boundsV_;
    Vec2 unit_;  ///< lengths of the bounds, 1 where they have none
    Interval rangeU_;
    Interval rangeV_;
    double squaredPoleExtent_ = 0.0;
    bool isPlane_ = false;
};

}  // namespace mesher
