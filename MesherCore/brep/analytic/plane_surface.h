#pragma once

#include "brep/surface.h"

namespace mesher {

/// The plane of a frame; (u, v) are the frame's coordinates.
class PlaneSurface final : public Surface
{
public:
    explicit PlaneSurface(const PlaneFrame& frame) : frame_(frame) {}

    [[nodiscard]] SurfaceKind kind() const override { return SurfaceKind::Plane; }
    [[nodiscard]] Interval rangeU() const override { return kUnbounded; }
    [[nodiscard]] Interval rangeV() const override { return kUnbounded; }
    [[nodiscard]] double periodU() const override { return 0.0; }
    [[nodiscard]] double periodV() const override { return 0.0; }
    [[nodiscard]] Vec3 position(Vec2 uv) const override { return frame_.toSpace(uv); }
    [[nodiscard]] SurfacePoint evaluate(Vec2 uv) const override;
    [[nodiscard]] SurfaceProjection project(const Vec3& point, std::optional<Vec2> seed = {}) const override;
    [[nodiscard]] std::optional<PlaneFrame> planeFrame() const override { return frame_; }
    [[nodiscard]] std::unique_ptr<Surface> clone() const override { return std::make_unique<PlaneSurface>(*this); }

private:
    PlaneFrame frame_;
};

}  // namespace mesher
