#include "delaunay/constrained_check.h"

#include "predicates/insphere.h"
#include "predicates/orient3d.h"

#include <algorithm>
#include <cmath>
#include <string>

namespace mesher {

namespace {

std::string nameOfSegment(SegmentId id) { return "segment " + std::to_string(id.value); }
std::string nameOfFacet(FacetId id) { return "facet " + std::to_string(id.value); }

class ConstraintCheck
{
public:
    ConstraintCheck(const ConstrainedTetrahedralization& tets, const SurfaceMesh& surface)
        : tets_(tets), mesh_(tets.mesh()), surface_(surface)
    {
    }

    CheckReport run()
    {
        if (checkNodes()) {
            checkSegments();
            checkFacets();
            checkNoOthers();
        }
        return report_;
    }

private:
    bool checkNodes()
    {
        if (tets_.vertexOf.size() != surface_.nodes.size()) {
            report_.add("the map of the nodes has another size than the surface mesh");
            return false;
        }
        for (std::uint32_t i = 0; i < surface_.nodes.size(); ++i) {
            const VertexId vertex = tets_.vertexOf[NodeId(i)];
            const std::string name = "node " + std::to_string(i);
            if (!vertex.isValid() || !mesh_.isVertexAlive(vertex)) {
                report_.add(name + " has no vertex");
                return false;
            }
            if (!(mesh_.position(vertex) == tets_.scale * surface_.nodes[NodeId(i)].position)) {
                report_.add(name + " is not where its vertex is");
            }
            if (vertex.value >= tets_.nodeOf.size() || tets_.nodeOf[vertex] != NodeId(i)) {
                report_.add(name + " is not the node of its vertex");
            }
        }
        return true;
    }

    void checkSegments()
    {
        std::size_t alive = 0;
        for (std::uint32_t i = 0; i < surface_.segments.size(); ++i) {
            const SurfaceSegment& segment = surface_.segments[SegmentId(i)];
            if (!segment.isAlive()) continue;
            ++alive;
            const VertexId a = tets_.vertexOf[segment.node[0]];
            const VertexId b = tets_.vertexOf[segment.node[1]];
            const SegmentId* tag = tets_.segmentOf.find(unorderedPair(a, b));
            if (tag == nullptr || *tag != SegmentId(i))
                report_.add(nameOfSegment(SegmentId(i)) + " is not mapped");
            const TetId tet = mesh_.findEdge(a, b);
            if (!tet.isValid()) {
                report_.add(nameOfSegment(SegmentId(i)) + " is no edge");
            } else if (!mesh_.isEdgeConstrained(tet,
                                                kEdgeOfSlots[mesh_.slotOf(tet, a)][mesh_.slotOf(tet, b)])) {
                report_.add(nameOfSegment(SegmentId(i)) + " is not constrained");
            }
        }
        if (tets_.segmentOf.size() != alive) report_.add("the map of the segments has others besides");
    }

    void checkFacets()
    {
        std::size_t alive = 0;
        for (std::uint32_t i = 0; i < surface_.facets.size(); ++i) {
            const SurfaceFacet& facet = surface_.facets[FacetId(i)];
            if (!facet.isAlive()) continue;
            ++alive;
            std::array<VertexId, 3> corner;
            for (unsigned k = 0; k < 3; ++k) corner[k] = tets_.vertexOf[facet.node[k]];
            const TetFace face = mesh_.findFace(corner[0], corner[1], corner[2]);
            if (!face.isValid()) {
                report_.add(nameOfFacet(FacetId(i)) + " is no face");
            } else if (!mesh_.isFaceConstrained(face)) {
                report_.add(nameOfFacet(FacetId(i)) + " is not constrained");
            }
            std::sort(corner.begin(), corner.end());
            const FacetId* tag = tets_.facetOf.find(corner);
            if (tag == nullptr || *tag != FacetId(i)) report_.add(nameOfFacet(FacetId(i)) + " is not mapped");
        }
        if (tets_.facetOf.size() != alive) report_.add("the map of the facets has others besides");
    }

    void checkNoOthers()
    {
        for (std::uint32_t i = 0; i < mesh_.tetLimit(); ++i) {
            const TetId tet(i);
            if (!mesh_.isAlive(tet) || (mesh_.flags(tet) & tet_flag::kConstraints) == 0) continue;
            for (int edge = 0; edge < 6; ++edge) {
                if (!mesh_.isEdgeConstrained(tet, edge)) continue;
                const auto key = unorderedPair(mesh_.vertex(tet, kEdgeSlots[edge][0]),
                                               mesh_.vertex(tet, kEdgeSlots[edge][1]));
                if (!tets_.segmentOf.contains(key)) report_.add("a constrained edge is no segment");
            }
            for (int face = 0; face < 4; ++face) {
                if (!mesh_.isFaceConstrained({tet, face})) continue;
                auto key = mesh_.faceVertices({tet, face});
                std::sort(key.begin(), key.end());
                if (!tets_.facetOf.contains(key)) report_.add("a constrained face is no facet");
            }
        }
    }

    const ConstrainedTetrahedralization& tets_;
    const Triangulation3d& mesh_;
    const SurfaceMesh& surface_;
    CheckReport report_;
};

double sixfoldVolume(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d)
{
    return dot(cross(b - a, c - a), d - a);
}

/// Volumes by region, from the tetrahedra and from the facets around.
struct RegionVolumes
{
    std::vector<double> ofTets;
    std::vector<double> ofFacets;
    std::vector<double> magnitude;  ///< of the terms that were summed, for the rounding

    explicit RegionVolumes(std::size_t count) : ofTets(count), ofFacets(count), magnitude(count) {}
};

}  // namespace

CheckReport checkConstraints(const ConstrainedTetrahedralization& tets, const SurfaceMesh& surface)
{
    return ConstraintCheck(tets, surface).run();
}

CheckReport checkRegions(const ConstrainedTetrahedralization& tets, const SurfaceMesh& surface,
                         const RegionSides& sides)
{
    CheckReport report;
    const Triangulation3d& mesh = tets.mesh();
    std::uint32_t largest = 0;
    for (const auto& pair : sides) largest = std::max({largest, pair[0].value, pair[1].value});
    RegionVolumes volumes(largest + 1);
    const Vec3 origin = mesh.vertexLimit() > 0 ? mesh.position(VertexId(0u)) : Vec3{};
    for (std::uint32_t i = 0; i < mesh.tetLimit(); ++i) {
        const TetId tet(i);
        if (!mesh.isAlive(tet)) continue;
        const RegionId region = mesh.region(tet);
        if (region.value > largest) {
            report.add("a tetrahedron lies in a region that no face bounds");
            continue;
        }
        if (mesh.isGhostTet(tet)) {
            if (mesh.region(mesh.neighbour(tet, 3).tet()) != kExteriorRegion)
                report.add("a solid reaches the hull");
            continue;
        }
        const double volume =
            sixfoldVolume(mesh.position(mesh.vertex(tet, 0)), mesh.position(mesh.vertex(tet, 1)),
                          mesh.position(mesh.vertex(tet, 2)), mesh.position(mesh.vertex(tet, 3)));
        volumes.ofTets[region.value] += volume;
        volumes.magnitude[region.value] += std::abs(volume);
    }
    for (std::uint32_t i = 0; i < surface.facets.size(); ++i) {
        const SurfaceFacet& facet = surface.facets[FacetId(i)];
        if (!facet.isAlive()) continue;
        const auto corner = [&](unsigned k) { return tets.vertexOf[facet.node[k]]; };
        const double cone = sixfoldVolume(origin, mesh.position(corner(0)), mesh.position(corner(1)),
                                          mesh.position(corner(2)));
        for (unsigned side = 0; side < 2; ++side) {
            const RegionId region = sides[facet.face][side];
            // The facet looks into its first region, so out of its second.
            volumes.ofFacets[region.value] += side == 0 ? -cone : cone;
            volumes.magnitude[region.value] += std::abs(cone);
        }
        const TetFace face = mesh.findFace(corner(0), corner(1), corner(2));
        if (!face.isValid()) {
            report.add(nameOfFacet(FacetId(i)) + " is no face");
            continue;
        }
        for (const TetFace sideFace : {face, mesh.neighbour(face)}) {
            const VertexId apex = mesh.vertex(sideFace.tet(), sideFace.face());
            const bool isFirst =
                !isGhost(apex) && orient3d(mesh.position(corner(0)), mesh.position(corner(1)),
                                           mesh.position(corner(2)), mesh.position(apex)) == Sign::Positive;
            if (mesh.region(sideFace.tet()) != sides[facet.face][isFirst ? 0 : 1])
                report.add(nameOfFacet(FacetId(i)) + " has another region beside it than its face");
        }
    }
    for (std::uint32_t region = 1; region <= largest; ++region) {
        if (std::abs(volumes.ofTets[region] - volumes.ofFacets[region]) > 1e-10 * volumes.magnitude[region])
            report.add("region " + std::to_string(region) + " has not the volume that its facets enclose");
    }
    return report;
}

std::uint64_t countNonDelaunayFaces(const Triangulation3d& mesh, DelaunayPart part)
{
    std::uint64_t count = 0;
    for (std::uint32_t i = 0; i < mesh.tetLimit(); ++i) {
        const TetId tet(i);
        if (!mesh.isAlive(tet) || mesh.isGhostTet(tet)) continue;
        if (part == DelaunayPart::Inside && mesh.region(tet) == kExteriorRegion) continue;
        for (int face = 0; face < 4; ++face) {
            const TetFace other = mesh.neighbour(tet, face);
            if (other.tet() < tet || mesh.isGhostTet(other.tet()) || mesh.isFaceConstrained({tet, face}))
                continue;
            const auto& v = mesh.tet(tet).vertex;
            if (insphere(mesh.position(v[0]), mesh.position(v[1]), mesh.position(v[2]), mesh.position(v[3]),
                         mesh.position(mesh.vertex(other.tet(), other.face()))) == Sign::Positive) {
                ++count;
            }
        }
    }
    return count;
}

}  // namespace mesher
