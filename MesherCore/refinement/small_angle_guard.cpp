#include "refinement/small_angle_guard.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

namespace mesher {

namespace {

constexpr double kDegrees = 180.0 / std::numbers::pi;

double degreesBetween(const Vec3& u, const Vec3& v)
{
    return std::atan2(length(cross(u, v)), dot(u, v)) * kDegrees;
}

void keepSmallest(IndexedMap<std::uint32_t, SmallInputAngle>& angles, SmallInputAngle angle)
{
    if (angle.side[1] < angle.side[0]) std::swap(angle.side[0], angle.side[1]);
    SmallInputAngle& smallest = *angles.insert(angle.entity.index, angle).first;
    if (angle.degrees < smallest.degrees) smallest = angle;
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

/// The constrained face at the edge between a tetrahedron and the next one around it; invalid if there is none.
TetFace constrainedSideAt(const Triangulation3d& mesh, TetId tet, VertexId a, VertexId b, TetId next)
{
    for (int face = 0; face < 4; ++face) {
        const VertexId opposite = mesh.vertex(tet, face);
        if (opposite == a || opposite == b) continue;
        if (mesh.neighbour(tet, face).tet() == next && mesh.isFaceConstrained({tet, face}))
            return {tet, face};
    }
    return {};
}

struct Sector
{
    double degrees = 360.0;
    std::array<TetFace, 2> side;
};

/// The smallest angle between neighbouring facets at an edge over a region; 360 if there is none.
Sector smallestSector(const Triangulation3d& mesh, VertexId a, VertexId b)
{
    Sector smallest;
    const TetId at = mesh.findEdge(a, b);
    if (!at.isValid()) return smallest;
    std::vector<TetId> ring;
    mesh.collectEdgeRing(at, a, b, ring);
    // Start behind a facet, so that no sector is cut in two.
    const std::size_t n = ring.size();
    std::size_t first = n;
    Sector sector;
    for (std::size_t i = 0; i < n && first == n; ++i) {
        sector.side[0] = constrainedSideAt(mesh, ring[i], a, b, ring[(i + 1) % n]);
        if (sector.side[0].isValid()) first = (i + 1) % n;
    }
    sector.degrees = 0.0;
    for (std::size_t i = 0; i < n && first < n; ++i) {
        const TetId tet = ring[(first + i) % n];
        const bool isMeshed = !mesh.isGhostTet(tet) && mesh.region(tet) != kExteriorRegion;
        sector.degrees = isMeshed ? sector.degrees + dihedralAt(mesh, tet, a, b) : 360.0;
        sector.side[1] = constrainedSideAt(mesh, tet, a, b, ring[(first + i + 1) % n]);
        if (!sector.side[1].isValid()) continue;
        if (sector.degrees < smallest.degrees) smallest = sector;
        sector = {0.0, {sector.side[1], {}}};
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
        const Sector sector =
            smallestSector(t.mesh(), t.vertexOf[segment.node[0]], t.vertexOf[segment.node[1]]);
        if (sector.degrees >= kSmallDihedral) continue;
        const auto faceOf = [&](TetFace side) {
            std::array<VertexId, 3> corners = t.mesh().faceVertices(side);
            std::sort(corners.begin(), corners.end());
            const FacetId* facet = t.facetOf.find(corners);
            return facet == nullptr ? EntityRef{} : EntityRef{2, surface.facets[*facet].face.value};
        };
        keepSmallest(
            edges_,
            {{1, segment.edge.value}, sector.degrees, {faceOf(sector.side[0]), faceOf(sector.side[1])}});
    }
}

void SmallAngleGuard::measureCorners(const SurfaceMesh& surface)
{
    struct Arm
    {
        std::uint32_t vertex;
        Vec3 direction;
        BrepEdgeId edge;
    };
    std::vector<Arm> arms;
    for (const SurfaceSegment& segment : surface.segments) {
        if (!segment.isAlive()) continue;
        for (unsigned end = 0; end < 2; ++end) {
            const MeshNode& node = surface.nodes[segment.node[end]];
            if (node.entity.dimension != 0) continue;
            arms.push_back({node.entity.index, surface.nodes[segment.node[1 - end]].position - node.position,
                            segment.edge});
        }
    }
    std::stable_sort(arms.begin(), arms.end(),
                     [](const Arm& a, const Arm& b) { return a.vertex < b.vertex; });
    for (std::size_t i = 0; i < arms.size(); ++i) {
        for (std::size_t j = i + 1; j < arms.size() && arms[j].vertex == arms[i].vertex; ++j) {
            const double degrees = degreesBetween(arms[i].direction, arms[j].direction);
            if (degrees >= kSmallCorner) continue;
            keepSmallest(vertices_, {{0, arms[i].vertex},
                                     degrees,
                                     {EntityRef{1, arms[i].edge.value}, EntityRef{1, arms[j].edge.value}}});
        }
    }
}

void SmallAngleGuard::collectPlaces(const SurfaceMesh& surface)
{
    places_.clear();
    if (!hasAny()) return;
    for (const MeshNode& node : surface.nodes) {
        const SmallInputAngle* angle = nullptr;
        if (node.entity.dimension == 0) angle = vertices_.find(node.entity.index);
        if (node.entity.dimension == 1) angle = edges_.find(node.entity.index);
        if (angle != nullptr) places_.push_back({node.position, *angle});
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
