#include "refinement/local_feature_size.h"

#include "refinement/meshed_tets.h"
#include "sizing/sizing_field.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

namespace mesher {

namespace {

double distanceToSegment(const Vec3& p, const Vec3& a, const Vec3& b)
{
    const Vec3 along = b - a;
    const double t = std::clamp(dot(p - a, along) / squaredLength(along), 0.0, 1.0);
    return length(p - (a + t * along));
}

double distanceToTriangle(const Vec3& p, const Vec3& a, const Vec3& b, const Vec3& c)
{
    const Vec3 normal = cross(b - a, c - a);
    const auto isInsideOf = [&](const Vec3& from, const Vec3& to) {
        return dot(cross(to - from, p - from), normal) >= 0.0;
    };
    if (isInsideOf(a, b) && isInsideOf(b, c) && isInsideOf(c, a)) {
        return std::abs(dot(p - a, normal)) / length(normal);
    }
    return std::min({distanceToSegment(p, a, b), distanceToSegment(p, b, c), distanceToSegment(p, c, a)});
}

/// The three distances of thesis section 4.4, as far as this tetrahedron knows them.
void lowerToLocalFeatures(const Triangulation3d& mesh, TetId tet, std::vector<double>& lfs)
{
    const auto& vertex = mesh.tet(tet).vertex;
    std::array<Vec3, 4> p;
    for (unsigned i = 0; i < 4; ++i) p[i] = mesh.position(vertex[i]);
    for (const auto& [from, to] : kEdgeSlots) {
        const auto i = static_cast<unsigned>(from);
        const auto j = static_cast<unsigned>(to);
        const double distance = length(p[j] - p[i]);
        lfs[vertex[i].value] = std::min(lfs[vertex[i].value], distance);
        lfs[vertex[j].value] = std::min(lfs[vertex[j].value], distance);
    }
    for (unsigned face = 0; face < 4; ++face) {
        if (!mesh.isFaceConstrained({tet, static_cast<int>(face)})) continue;
        const unsigned a = static_cast<unsigned>(kFaceSlots[face][0]);
        const unsigned b = static_cast<unsigned>(kFaceSlots[face][1]);
        const unsigned c = static_cast<unsigned>(kFaceSlots[face][2]);
        double& apex = lfs[vertex[face].value];
        apex = std::min(apex, distanceToTriangle(p[face], p[a], p[b], p[c]));
        for (const auto& [v, from, to] : {std::array{a, b, c}, std::array{b, c, a}, std::array{c, a, b}}) {
            double& corner = lfs[vertex[v].value];
            corner = std::min(corner, distanceToSegment(p[v], p[from], p[to]));
        }
    }
}

}  // namespace

std::vector<double> localFeatureSizes(const Triangulation3d& mesh, const ThinWalls* walls)
{
    std::vector<double> lfs(mesh.vertexLimit(), kNoSize);
    for (std::uint32_t i = 0; i < mesh.tetLimit(); ++i) {
        const bool isInWall = walls != nullptr && walls->isInKept(TetId(i));
        if (!isInWall && isMeshed(mesh, TetId(i))) lowerToLocalFeatures(mesh, TetId(i), lfs);
    }
    return lfs;
}

std::vector<double> meanFacetSides(const Triangulation3d& mesh)
{
    struct Sides
    {
        double sum = 0.0;
        int count = 0;
    };
    std::vector<Sides> at(mesh.vertexLimit());
    for (std::uint32_t i = 0; i < mesh.tetLimit(); ++i) {
        if (!isMeshed(mesh, TetId(i))) continue;
        for (int face = 0; face < 4; ++face) {
            if (!mesh.isFaceConstrained({TetId(i), face})) continue;
            const auto v = mesh.faceVertices({TetId(i), face});
            for (unsigned k = 0; k < 3; ++k) {
                const VertexId a = v[k], b = v[(k + 1) % 3];
                const double side = length(mesh.position(b) - mesh.position(a));
                for (Sides* end : {&at[a.value], &at[b.value]}) {
                    end->sum += side;
                    ++end->count;
                }
            }
        }
    }
    std::vector<double> mean(at.size(), kNoSize);
    for (std::size_t v = 0; v < at.size(); ++v) {
        if (at[v].count > 0) mean[v] = at[v].sum / at[v].count;
    }
    return mean;
}

}  // namespace mesher
