#include "refinement/small_angle_guard.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

namespace mesher {

namespace {

constexpr double kDegrees = 180.0 / std::numbers::pi;

double degreesBetween(const Vec3& u, const Vec3& v)
{
    return std::atan2(length(cross(u, v)), dot(u, v)) * kDegrees;
}

void keepSmallest(IndexedMap<std::uint32_t, double>& angles, std::uint32_t key, double degrees)
{
    double& smallest = *angles.insert(key, degrees).first;
    smallest = std::min(smallest, degrees);
}

/// Angle in degrees of a tetrahedron at its edge (a, b).
double dihedralAt(const Triangulation3d& mesh, TetId tet, VertexId a, VertexId b)
{
    const Vec3 origin = mesh.position(a);
    const Vec3 axis = mesh.position(b) - origin;
    std::array<Vec3, 2> side;
    unsigned count = 0;
    for (const VertexId v : mesh.tet(tet).vertex) {
        if (v == a || v == b) continue;
        const Vec3 arm = mesh.position(v) - origin;
        side[count++] = arm - (dot(arm, axis) / squaredLength(axis)) * axis;
    }
    return degreesBetween(side[0], side[1]);
}

bool hasConstrainedSideAt(const Triangulation3d& mesh, TetId tet, VertexId a, VertexId b, TetId next)
{
    for (int face = 0; face < 4; ++face) {
        const VertexId opposite = mesh.vertex(tet, face);
        if (opposite == a || opposite == b) continue;
        if (mesh.neighbour(tet, face).tet() == next && mesh.isFaceConstrained({tet, face})) return true;
    }
    return false;
}

/// The smallest angle between neighbouring facets at an edge over a region; 360 if there is none.
double smallestSector(const Triangulation3d& mesh, VertexId a, VertexId b)
{
    const TetId at = mesh.findEdge(a, b);
    if (!at.isValid()) return 360.0;
    std::vector<TetId> ring;
    mesh.collectEdgeRing(at, a, b, ring);
    // Start behind a facet, so that no sector is cut in two.
    const std::size_t n = ring.size();
    std::size_t first = n;
    for (std::size_t i = 0; i < n && first == n; ++i) {
        if (hasConstrainedSideAt(mesh, ring[i], a, b, ring[(i + 1) % n])) first = (i + 1) % n;
    }
    double smallest = 360.0;
    double sector = 0.0;
    for (std::size_t i = 0; i < n && first < n; ++i) {
        const TetId tet = ring[(first + i) % n];
        const bool isMeshed = !mesh.isGhostTet(tet) && mesh.region(tet) != kExteriorRegion;
        sector = isMeshed ? sector + dihedralAt(mesh, tet, a, b) : 360.0;
        if (!hasConstrainedSideAt(mesh, tet, a, b, ring[(first + i + 1) % n])) continue;
        smallest = std::min(smallest, sector);
        sector = 0.0;
    }
    return smallest;
}

}  // namespace

SmallAngleGuard::SmallAngleGuard(const ConstrainedTetrahedralization& tetrahedralization,
                                 const SurfaceMesh& surface)
{
    measureSegments(tetrahedralization, surface);
    measureCorners(surface);
}

void SmallAngleGuard::measureSegments(const ConstrainedTetrahedralization& t, const SurfaceMesh& surface)
{
    for (const SurfaceSegment& segment : surface.segments) {
        if (!segment.isAlive()) continue;
        const double degrees =
            smallestSector(t.mesh(), t.vertexOf[segment.node[0]], t.vertexOf[segment.node[1]]);
        if (degrees < kSmallDihedral) keepSmallest(edges_, segment.edge.value, degrees);
    }
}

void SmallAngleGuard::measureCorners(const SurfaceMesh& surface)
{
    struct Arm
    {
        std::uint32_t vertex;
        Vec3 direction;
    };
    std::vector<Arm> arms;
    for (const SurfaceSegment& segment : surface.segments) {
        if (!segment.isAlive()) continue;
        for (unsigned end = 0; end < 2; ++end) {
            const MeshNode& node = surface.nodes[segment.node[end]];
            if (node.entity.dimension != 0) continue;
            arms.push_back(
                {node.entity.index, surface.nodes[segment.node[1 - end]].position - node.position});
        }
    }
    std::stable_sort(arms.begin(), arms.end(),
                     [](const Arm& a, const Arm& b) { return a.vertex < b.vertex; });
    for (std::size_t i = 0; i < arms.size(); ++i) {
        for (std::size_t j = i + 1; j < arms.size() && arms[j].vertex == arms[i].vertex; ++j) {
            const double degrees = degreesBetween(arms[i].direction, arms[j].direction);
            if (degrees < kSmallCorner) keepSmallest(vertices_, arms[i].vertex, degrees);
        }
    }
}

void SmallAngleGuard::collectPlaces(const SurfaceMesh& surface)
{
    places_.clear();
    if (!hasAny()) return;
    for (const MeshNode& node : surface.nodes) {
        const double* degrees = nullptr;
        if (node.entity.dimension == 0) degrees = vertices_.find(node.entity.index);
        if (node.entity.dimension == 1) degrees = edges_.find(node.entity.index);
        if (degrees != nullptr) places_.push_back({node.position, {node.entity, *degrees}});
    }
    std::stable_sort(places_.begin(), places_.end(), [](const Place& a, const Place& b) {
        return isLexicographicallyLess(a.position, b.position);
    });
}

std::optional<SmallInputAngle> SmallAngleGuard::blameFor(const Vec3& point, double reach) const
{
    std::optional<SmallInputAngle> nearest;
    double nearestDistance = reach;
    const auto first = std::lower_bound(places_.begin(), places_.end(), point.x - reach,
                                        [](const Place& place, double x) { return place.position.x < x; });
    for (auto place = first; place != places_.end() && place->position.x <= point.x + reach; ++place) {
        const double distance = length(place->position - point);
        if (distance > nearestDistance) continue;
        nearestDistance = distance;
        nearest = place->angle;
    }
    return nearest;
}

}  // namespace mesher
