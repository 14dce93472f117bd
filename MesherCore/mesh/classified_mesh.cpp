#include "mesh/classified_mesh.h"

#include <charconv>
#include <system_error>

namespace mesher {

std::string nameOf(EntityRef entity)
{
    if (entity.index == EntityRef::kNone) return {};
    switch (entity.dimension) {
        case 0: return nameOf(BrepVertexId(entity.index));
        case 1: return nameOf(BrepEdgeId(entity.index));
        case 2: return nameOf(BrepFaceId(entity.index));
        default: return nameOf(BrepSolidId(entity.index));
    }
}

std::optional<EntityRef> entityNamed(std::string_view name)
{
    constexpr std::array<std::string_view, 4> kPrefixes = {"Vertex", "Edge", "Face", "Solid"};
    for (std::uint8_t dimension = 0; dimension < kPrefixes.size(); ++dimension) {
        if (!name.starts_with(kPrefixes[dimension])) continue;
        const std::string_view digits = name.substr(kPrefixes[dimension].size());
        std::uint32_t number = 0;
        const auto [end, code] = std::from_chars(digits.data(), digits.data() + digits.size(), number);
        const bool isNumber = code == std::errc() && end == digits.data() + digits.size() && number > 0;
        if (isNumber) return EntityRef{dimension, number - 1};
    }
    return std::nullopt;
}

}  // namespace mesher
