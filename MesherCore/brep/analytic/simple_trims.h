#pragma once

#include "brep/brep_model.h"

namespace mesher {

/// A rectangle of parameters of a surface with these periods, 0 where there is none. A seam is a border.
class RectangleTrim final : public TrimClassifier
{
public:
    /// Tolerances are in units of the parameters.
    RectangleTrim(Interval u, Interval v, Vec2 tolerance, Vec2 periods)
        : u_(u), v_(v), tolerance_(tolerance), periods_(periods)
    {
    }

    [[nodiscard]] TrimSide classify(Vec2 uv) const override;
    [[nodiscard]] std::unique_ptr<TrimClassifier> clone() const override
    {
        return std::make_unique<RectangleTrim>(*this);
    }

private:
    Interval u_;
    Interval v_;
    Vec2 tolerance_;
    Vec2 periods_;
};

/// A disk around the origin of a plane's parameters.
class DiskTrim final : public TrimClassifier
{
public:
    DiskTrim(double radius, double tolerance) : radius_(radius), tolerance_(tolerance) {}

    [[nodiscard]] TrimSide classify(Vec2 uv) const override;
    [[nodiscard]] std::unique_ptr<TrimClassifier> clone() const override { return std::make_unique<DiskTrim>(*this); }

private:
    double radius_;
    double tolerance_;
};

}  // namespace mesher
