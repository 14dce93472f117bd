#pragma once

#include "brep/surface.h"
#include "brep/surface_projection.h"

#include <cstddef>
#include <vector>

namespace mesher {

/// What makes a B-spline surface: flat knots in both directions; poles by u, then v; no weights means all are one.
struct BSplineSurfaceData
{
    std::size_t degreeU = 3;
    std::size_t degreeV = 3;
    std::vector<double> knotsU;
    std::vector<double> knotsV;
    std::vector<Vec3> poles;
    std::vector<double> weights;

    [[nodiscard]] std::size_t countU() const { return knotsU.size() - degreeU - 1; }
    [[nodiscard]] std::size_t countV() const { return knotsV.size() - degreeV - 1; }
};

/// A B-spline or NURBS surface of degrees 1 to 25 that is not periodic. Evaluates without a cache, so that threads may share
/// it while none searches without a seed.
class BSplineSurface final : public Surface
{
public:
    /// Requires data that fit together; the window is where closest points are looked for first.
    BSplineSurface(BSplineSurfaceData data, Interval windowU, Interval windowV);

    [[nodiscard]] SurfaceKind kind() const override;
    [[nodiscard]] Interval rangeU() const override;
    [[nodiscard]] Interval rangeV() const override;
    [[nodiscard]] double periodU() const override { return 0.0; }
    [[nodiscard]] double periodV() const override { return 0.0; }
    [[nodiscard]] Vec3 position(Vec2 uv) const override;
    [[nodiscard]] SurfacePoint evaluate(Vec2 uv) const override;
    [[nodiscard]] SurfaceProjection project(const Vec3& point, std::optional<Vec2> seed = {}) const override;
    [[nodiscard]] std::span<const double> breaksU() const override { return breaksU_; }
    [[nodiscard]] std::span<const double> breaksV() const override { return breaksV_; }
    [[nodiscard]] std::unique_ptr<Surface> clone() const override
    {
        return std::make_unique<BSplineSurface>(*this);
    }

private:
    BSplineSurfaceData data_;
    std::vector<double> breaksU_;
    std::vector<double> breaksV_;
    SurfaceSearch search_;
};

}  // namespace mesher
