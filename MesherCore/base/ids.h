#pragma once

#include <compare>
#include <cstdint>
#include <functional>

namespace mesher {

/// An index that cannot be mistaken for another kind of index. A default-made id is invalid.
template <class Tag>
struct Id
{
    static constexpr std::uint32_t kInvalid = 0xFFFFFFFFu;

    std::uint32_t value = kInvalid;

    constexpr Id() = default;
    constexpr explicit Id(std::uint32_t index) : value(index) {}

    [[nodiscard]] constexpr bool isValid() const { return value != kInvalid; }
    friend constexpr auto operator<=>(const Id&, const Id&) = default;
};

/// A vertex of a two- or three-dimensional triangulation.
using VertexId = Id<struct VertexTag>;
/// A triangle of a two-dimensional triangulation.
using TriangleId = Id<struct TriangleTag>;
/// A tetrahedron of a three-dimensional triangulation.
using TetId = Id<struct TetTag>;
/// A connected part of the domain with one material; 0 is by convention the exterior.
using RegionId = Id<struct RegionTag>;

}  // namespace mesher

template <class Tag>
struct std::hash<mesher::Id<Tag>>
{
    std::size_t operator()(mesher::Id<Tag> id) const noexcept { return id.value; }
};
