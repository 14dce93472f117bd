#include "mesh/classified_mesh.h"

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

}  // namespace mesher
