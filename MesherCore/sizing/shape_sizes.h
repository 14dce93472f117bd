#pragma once

#include "base/box.h"
#include "sizing/sizing_field.h"

namespace mesher {

/// How a size changes with the distance from where it was asked for: `size` up to `plateau`, then growing by `growth` per
/// unit of distance, up to `largest`; beyond `reach` there is no wish.
struct DistanceProfile
{
    double size = 1.0;
    double plateau = 0.0;
    double growth = 1.0;
    double largest = kNoSize;
    double reach = kNoSize;

    /// Grows with the distance, except that it ends at `reach`.
    [[nodiscard]] double at(double distance) const;
};

/// A size in a box and, by its profile, around it.
class BoxSize final : public SizingField
{
public:
    BoxSize(const Box3& box, const DistanceProfile& profile) : box_(box), profile_(profile) {}
    [[nodiscard]] double sizeAt(const Vec3& point) const override { return smallestNear(point, 0.0); }
    [[nodiscard]] double smallestNear(const Vec3& centre, double radius) const override;

private:
    Box3 box_;
    DistanceProfile profile_;
};

/// A size in a ball and, by its profile, around it.
class BallSize final : public SizingField
{
public:
    BallSize(const Vec3& centre, double radius, const DistanceProfile& profile)
        : centre_(centre), radius_(radius), profile_(profile)
    {
    }
    [[nodiscard]] double sizeAt(const Vec3& point) const override { return smallestNear(point, 0.0); }
    [[nodiscard]] double smallestNear(const Vec3& centre, double radius) const override;

private:
    Vec3 centre_;
    double radius_;
    DistanceProfile profile_;
};

}  // namespace mesher
