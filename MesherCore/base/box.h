#pragma once

#include "base/vec.h"

#include <algorithm>
#include <limits>
#include <span>

namespace mesher {

/// An axis-aligned box of the plane; a default-made box is empty and grows by `include`.
struct Box2
{
    Vec2 low{std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()};
    Vec2 high{-std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()};

    constexpr void include(Vec2 p)
    {
        low = {std::min(low.x, p.x), std::min(low.y, p.y)};
        high = {std::max(high.x, p.x), std::max(high.y, p.y)};
    }
    [[nodiscard]] constexpr bool isEmpty() const { return !(low.x <= high.x); }
    [[nodiscard]] constexpr bool contains(Vec2 p) const
    {
        return low.x <= p.x && p.x <= high.x && low.y <= p.y && p.y <= high.y;
    }
    [[nodiscard]] constexpr Vec2 extent() const { return high - low; }

    [[nodiscard]] static constexpr Box2 of(std::span<const Vec2> points)
    {
        Box2 box;
        for (const Vec2& p : points) box.include(p);
        return box;
    }
};

/// An axis-aligned box of space; a default-made box is empty and grows by `include`.
struct Box3
{
    Vec3 low{std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity(),
             std::numeric_limits<double>::infinity()};
    Vec3 high{-std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity(),
              -std::numeric_limits<double>::infinity()};

    constexpr void include(Vec3 p)
    {
        low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
        high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
    }
    [[nodiscard]] constexpr bool isEmpty() const { return !(low.x <= high.x); }
    [[nodiscard]] constexpr bool contains(Vec3 p) const
    {
        return low.x <= p.x && p.x <= high.x && low.y <= p.y && p.y <= high.y && low.z <= p.z &&
               p.z <= high.z;
    }
    [[nodiscard]] constexpr Vec3 extent() const { return high - low; }

    [[nodiscard]] static constexpr Box3 of(std::span<const Vec3> points)
    {
        Box3 box;
        for (const Vec3& p : points) box.include(p);
        return box;
    }
};

}  // namespace mesher
