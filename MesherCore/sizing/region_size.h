#pragma once

#include "sizing/sizing_field.h"

#include <memory>
#include <utility>

namespace mesher {

/// A part of space that tells whether a point is in it.
/// Threads      may be asked from several threads at once
class SizeRegion
{
public:
    virtual ~SizeRegion() = default;
    [[nodiscard]] virtual bool contains(const Vec3& point) const = 0;
};

/// One size inside of a region, no wish outside.
class RegionSize final : public SizingField
{
public:
    RegionSize(std::shared_ptr<const SizeRegion> region, double size)
        : region_(std::move(region)), size_(size)
    {
    }
    [[nodiscard]] double sizeAt(const Vec3& point) const override
    {
        return region_->contains(point) ? size_ : kNoSize;
    }

private:
    std::shared_ptr<const SizeRegion> region_;
    double size_;
};

}  // namespace mesher
