#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

namespace mesher {

/// Which entities of the model become groups in formats that number them. Readers take every group for a region or a boundary
/// condition, so those of edges and vertices of a solid are written only on a wish.
enum class GroupChoice : std::uint8_t
{
    Bounding,  ///< those of the mesh's dimension, and of the one below: solids and faces, or faces and edges
    All        ///< edges and vertices too
};

/// "bounding", "all"; nothing for another word.
[[nodiscard]] constexpr std::optional<GroupChoice> groupChoiceOf(std::string_view name)
{
    if (name == "bounding") return GroupChoice::Bounding;
    if (name == "all") return GroupChoice::All;
    return std::nullopt;
}

/// How a mesh is written, whatever the format.
struct WriteOptions
{
    GroupChoice groups = GroupChoice::Bounding;  ///< DEFAULT: Bounding
};

}  // namespace mesher
