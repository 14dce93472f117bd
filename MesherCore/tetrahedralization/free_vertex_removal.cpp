#include "tetrahedralization/free_vertex_removal.h"

namespace mesher {

FreeVertexRemoval removeFreeVertices(ConstrainedTetrahedralization& tets)
{
    FreeVertexRemoval result;
    const Triangulation3d& mesh = tets.mesh();
    for (std::uint32_t i = 0; i < mesh.vertexLimit(); ++i) {
        const VertexId vertex(i);
        if (!mesh.isVertexAlive(vertex) || tets.nodeOf[vertex].isValid()) continue;
        if (mesh.region(mesh.incidentTet(vertex)) == kExteriorRegion) continue;
        if (tets.delaunay->remove(vertex) == RemovalStatus::Removed) {
            ++result.removed;
        } else {
            ++result.left;
        }
    }
    return result;
}

}  // namespace mesher
