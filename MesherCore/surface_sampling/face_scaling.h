#pragma once

#include "brep/brep_model.h"

namespace mesher {

/// A linear map of a surface's parameters after which their plane measures about as the surface does, on average over a face.
class FaceScaling
{
public:
    FaceScaling() = default;
    /// From the mean first fundamental form over the bounds of the face.
    explicit FaceScaling(const BrepFace& face);

    [[nodiscard]] Vec2 toPlane(Vec2 uv) const { return {xu_ * uv.x + xv_ * uv.y, yv_ * uv.y}; }
    [[nodiscard]] Vec2 toParameters(Vec2 place) const
    {
        const double v = place.y / yv_;
        return {(place.x - xv_ * v) / xu_, v};
    }

private:
    double xu_ = 1.0;
    double xv_ = 0.0;
    double yv_ = 1.0;
};

}  // namespace mesher
