#include "delaunay/mesh_hash2d.h"

#include "delaunay/mesh_hash.h"

#include <algorithm>
#include <bit>
#include <utility>

namespace mesher {
namespace {

std::uint64_t hashOf(Vec2 p)
{
    // Adding zero makes the two zeros one.
    const std::uint64_t x = mixBits(std::bit_cast<std::uint64_t>(p.x + 0.0) + 0x9E3779B97F4A7C15u);
    return mixBits(x ^ std::bit_cast<std::uint64_t>(p.y + 0.0));
}

std::uint64_t hashOf(const Triangulation2d& mesh, const Triangle2d& record)
{
    std::pair<std::uint64_t, bool> corners[3];
    for (unsigned i = 0; i < 3; ++i)
        corners[i] = {hashOf(mesh.position(record.v[i])), record.isConstrained(i)};
    std::sort(std::begin(corners), std::end(corners));
    std::uint64_t hash = 0;
    for (const auto& [corner, isOppositeConstrained] : corners) {
        hash = mixBits(hash ^ corner) + (isOppositeConstrained ? 0xA0761D6478BD642Fu : 0u);
    }
    return mixBits(hash);
}

}  // namespace

std::uint64_t meshHash2d(const Triangulation2d& mesh)
{
    std::uint64_t sum = 0;
    for (std::uint32_t i = 0; i < mesh.vertexSlots(); ++i) {
        if (mesh.isAlive(VertexId(i))) sum += hashOf(mesh.position(VertexId(i)));
    }
    for (std::uint32_t i = 0; i < mesh.triangleSlots(); ++i) {
        const Triangle2d& record = mesh.triangle(TriangleId(i));
        if (record.isAlive() && !record.isGhost()) sum += hashOf(mesh, record);
    }
    return sum;
}

}  // namespace mesher
