#include "support/poly_file.h"

#include <cstdio>

namespace mesher::test {

void writePoly(const SurfaceMesh& mesh, const char* path)
{
    std::FILE* file = std::fopen(path, "w");
    if (file == nullptr) return;
    std::fprintf(file, "%zu 3 0 0\n", mesh.nodes.size());
    for (std::uint32_t i = 0; i < mesh.nodes.size(); ++i) {
        const Vec3& p = mesh.nodes[NodeId(i)].position;
        std::fprintf(file, "%u %.17g %.17g %.17g\n", i, p.x, p.y, p.z);
    }
    std::fprintf(file, "%zu 0\n", mesh.facets.size());
    for (const SurfaceFacet& facet : mesh.facets) {
        std::fprintf(file, "1\n3 %u %u %u\n", facet.node[0].value, facet.node[1].value, facet.node[2].value);
    }
    std::fprintf(file, "0\n0\n");
    std::fclose(file);
}

}  // namespace mesher::test
