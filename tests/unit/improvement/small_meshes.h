#pragma once

#include "improvement/boundary_geometry.h"
#include "improvement/tet_complex.h"

#include <cmath>
#include <numbers>
#include <vector>

namespace mesher::test {

/// Nodes inside of a solid and tetrahedra, without a boundary: what an operation sees of a mesh.
struct SmallMesh
{
    ClassifiedMesh mesh;
    BrepModel model;

    NodeId add(const Vec3& p) { return mesh.nodes.push_back({p, {3, 0}, {}}); }
    void addTet(NodeId a, NodeId b, NodeId c, NodeId d) { mesh.tets.push_back({{a, b, c, d}, {3, 0}}); }
};

/// An edge from node 0 to node 1 and n nodes around it, 2 and up.
inline SmallMesh ringAroundEdge(std::uint32_t n, double halfLength, double wobble)
{
    SmallMesh small;
    const NodeId a = small.add({0, 0, -halfLength});
    const NodeId b = small.add({0, 0, halfLength});
    for (std::uint32_t i = 0; i < n; ++i) {
        const double turn = 2.0 * std::numbers::pi * (i + 0.3 * wobble * std::sin(3.0 * i)) / n;
        const double radius = 1.0 + wobble * std::cos(5.0 * i);
        small.add({radius * std::cos(turn), radius * std::sin(turn), wobble * std::sin(7.0 * i)});
    }
    for (std::uint32_t i = 0; i < n; ++i) small.addTet(a, b, NodeId(2 + i), NodeId(2 + (i + 1) % n));
    return small;
}

inline double volumeOf(const TetComplex& complex)
{
    double sum = 0.0;
    for (std::uint32_t i = 0; i < complex.tetLimit(); ++i) {
        if (complex.isAlive(TetId(i))) sum += sixfoldVolume(complex.corners(complex.nodes(TetId(i)))) / 6.0;
    }
    return sum;
}

inline double leastScore(const TetComplex& complex)
{
    double least = 1.0;
    for (std::uint32_t i = 0; i < complex.tetLimit(); ++i) {
        if (complex.isAlive(TetId(i))) least = std::min(least, complex.score(TetId(i)));
    }
    return least;
}

inline std::size_t tetCount(const TetComplex& complex)
{
    std::size_t count = 0;
    for (std::uint32_t i = 0; i < complex.tetLimit(); ++i) count += complex.isAlive(TetId(i)) ? 1 : 0;
    return count;
}

}  // namespace mesher::test
