#pragma once

#include "base/vec.h"

#include <cmath>
#include <cstddef>
#include <cstring>

/// Two doubles that are computed with as one vector register, on every target of gcc and clang.
namespace mesher::detail {

typedef double DoublePair __attribute__((vector_size(16)));
static_assert(offsetof(Vec3, x) == 0 && offsetof(Vec3, y) == sizeof(double));

/// The first two coordinates, which lie side by side in memory.
inline DoublePair loadXY(const Vec3& p)
{
    DoublePair pair;
    std::memcpy(&pair, &p, sizeof pair);
    return pair;
}
inline DoublePair both(double a) { return DoublePair{a, a}; }
inline DoublePair swapped(DoublePair a) { return DoublePair{a[1], a[0]}; }
inline DoublePair absolute(DoublePair a) { return DoublePair{std::abs(a[0]), std::abs(a[1])}; }
inline DoublePair maximum(DoublePair a, DoublePair b) { return a > b ? a : b; }

/// Two vectors of space, component by component.
struct VectorPair
{
    DoublePair x;
    DoublePair y;
    DoublePair z;
};

inline VectorPair cross(const VectorPair& p, const VectorPair& q)
{
    return {p.y * q.z - p.z * q.y, p.z * q.x - p.x * q.z, p.x * q.y - p.y * q.x};
}
inline DoublePair squaredLength(const VectorPair& p) { return p.x * p.x + p.y * p.y + p.z * p.z; }

}  // namespace mesher::detail
