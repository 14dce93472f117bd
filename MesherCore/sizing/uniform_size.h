#pragma once

#include "sizing/sizing_field.h"

namespace mesher {

/// The same size everywhere.
class UniformSize final : public SizingField
{
public:
    explicit UniformSize(double size) : size_(size) {}
    [[nodiscard]] double sizeAt(const Vec3&) const override { return size_; }
    [[nodiscard]] double smallestNear(const Vec3&, double) const override { return size_; }

private:
    double size_;
};

}  // namespace mesher
