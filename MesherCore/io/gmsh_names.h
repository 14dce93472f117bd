#pragma once

#include "io/file_buffer.h"
#include "io/gmsh_entities.h"

#include <array>

namespace mesher {

/// Gmsh's numbers of a point, a line, a triangle and a tetrahedron.
inline constexpr std::array<int, 4> kGmshElementType = {15, 1, 2, 4};

/// The section $PhysicalNames: one group for each entity, of the entity's name and number.
inline void writePhysicalNames(const GmshEntities& entities, FileBuffer& out)
{
    std::size_t count = 0;
    for (std::size_t d = 0; d < 4; ++d) {
        for (const auto& [tag, entity] : entities.ofDimension(d)) count += entity.isNamed ? 1u : 0u;
    }
    if (count == 0) return;
    out << "$PhysicalNames\n" << count << '\n';
    for (std::uint8_t d = 0; d < 4; ++d) {
        for (const auto& [tag, entity] : entities.ofDimension(d)) {
            if (entity.isNamed) out << d << ' ' << tag << " \"" << nameOf(EntityRef{d, tag - 1}) << "\"\n";
        }
    }
    out << "$EndPhysicalNames\n";
}

}  // namespace mesher
