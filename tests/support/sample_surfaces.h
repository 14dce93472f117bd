#pragma once

#include "base/random.h"
#include "mesh/region_sides.h"
#include "mesh/surface_mesh.h"

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace mesher::test {

/// A piecewise linear complex with what lies beside its faces.
struct SampleSurface
{
    SurfaceMesh mesh;
    RegionSides sides;
};

/// Puts triangles together to a SurfaceMesh; edges where faces meet, or other than two triangles, become segments.
class SurfaceBuilder
{
public:
    NodeId addNode(const Vec3& position);
    BrepFaceId addFace(RegionId front, RegionId behind);
    void addFacet(BrepFaceId face, NodeId a, NodeId b, NodeId c);
    SampleSurface finish();

    [[nodiscard]] const Vec3& position(NodeId node) const { return surface_.mesh.nodes[node].position; }

private:
    SampleSurface surface_;
};

/// The hull of random points, each triangle a face.
SampleSurface convexHullSurface(std::size_t points, std::uint64_t seed);
/// A random star-shaped polygon, extruded and twisted (radians); side walls with random diagonals.
SampleSurface prismSurface(std::size_t corners, double twist, std::uint64_t seed);
/// The twisted prism over a triangle that no tetrahedra without a further vertex fill.
SampleSurface schoenhardtSurface(double twist);
/// A block with n wedges cut in from below and n across from above, nearly to a saddle between.
SampleSurface chazelleSurface(int notches, double gap);
/// A sphere, its triangles split `levels` times, with radii that vary by the factor 1 ± noise: a star for large noise.
SampleSurface sphereSurface(int levels, double noise, std::uint64_t seed);
SampleSurface torusSurface(int around, int across, double noise, std::uint64_t seed);
/// Random cells of a grid in `regions` solids: holes, voids, shared faces, and edges where many faces meet. Cells have
/// random sizes down to `thinnest` of the usual one; diagonals are random.
SampleSurface cellSurface(std::array<int, 3> cells, std::uint32_t regions, double thinnest,
                          std::uint64_t seed);
/// A box whose sides have n x n squares, diagonals flipped at random.
SampleSurface flippedBoxSurface(int squares, int flips, const Vec3& size, std::uint64_t seed);

/// Turns it about a random axis; coordinates are rounded.
void rotateRandomly(SampleSurface& surface, std::uint64_t seed);

/// One of all these, of a size of some dozen to some hundred nodes, by the seed alone; `name` tells which.
SampleSurface randomSurface(std::uint64_t seed, std::string& name);

}  // namespace mesher::test
