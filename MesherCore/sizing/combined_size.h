#pragma once

#include "sizing/sizing_field.h"

#include <memory>
#include <utility>
#include <vector>

namespace mesher {

/// The smallest wish of several fields, raised to a floor and lowered to a cap.
class CombinedSize final : public SizingField
{
public:
    /// Requires 0 < floor <= cap; a cap of kNoSize leaves places without a wish alone.
    explicit CombinedSize(std::vector<std::shared_ptr<const SizingField>> fields, double floor = 0.0,
                          double cap = kNoSize)
        : fields_(std::move(fields)), floor_(floor), cap_(cap)
    {
    }
    [[nodiscard]] double sizeAt(const Vec3& point) const override;
    [[nodiscard]] double smallestNear(const Vec3& centre, double radius) const override;

private:
    std::vector<std::shared_ptr<const SizingField>> fields_;
    double floor_;
    double cap_;
};

}  // namespace mesher
