#pragma once

#include "io/file_buffer.h"
#include "io/gmsh_entities.h"

#include <array>

namespace mesher {

/// Gmsh's numbers of a point, a line, a triangle and a tetrahedron.
inline constexpr std::array<int, 4> kGmshElementType = {15, 1, 2, 4};

/// The section $PhysicalNames: a group for each entity that has one, of the entity's name.
inline void writePhysicalNames(const GmshEntities& entities, FileBuffer& out)
{
    std::size_t count = 0;
    for (std::size_t d = 0; d < 4; ++d) {
        for (const auto& [tag, entity] : entities.ofDimension(d)) count += entity.group != 0 ? 1u : 0u;
    }
    if (count == 0) return;
    out << "$PhysicalNames\n" << count << '\n';
    for (std::uint8_t d = 4; d-- > 0;) {
        for (const auto& [tag, entity] : entities.ofDimension(d)) {
            if (entity.group == 0) continue;
            out << d << ' ' << entity.group << " \"" << nameOf(entity.entity) << "\"\n";
        }
    }
    out << "$EndPhysicalNames\n";
}

}  // namespace mesher
