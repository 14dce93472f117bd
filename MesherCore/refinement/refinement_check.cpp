#include "refinement/refinement_check.h"

#include "delaunay/delaunay_check3d.h"

#include <algorithm>
#include <string>
#include <unordered_set>

namespace mesher {

namespace {

std::string nameOf(SegmentId segment) { return "segment " + std::to_string(segment.value); }
std::string nameOf(FacetId facet) { return "facet " + std::to_string(facet.value); }

bool isVertexOf(const ConstrainedTetrahedralization& t, NodeId node)
{
    if (!node.isValid() || node.value >= t.vertexOf.size()) return false;
    const VertexId v = t.vertexOf[node];
    return v.isValid() && t.mesh().isVertexAlive(v) && v.value < t.nodeOf.size() && t.nodeOf[v] == node;
}

void checkNodes(const ConstrainedTetrahedralization& t, const SurfaceMesh& surface, CheckReport& report)
{
    const auto checkNode = [&](NodeId node, const std::string& user) {
        if (!isVertexOf(t, node)) {
            report.add(user + " has a node without a vertex of its own");
        } else if (!(t.mesh().position(t.vertexOf[node]) == t.scale * surface.nodes[node].position)) {
            report.add(user + " has a node whose vertex is elsewhere");
        }
    };
    for (std::uint32_t i = 0; i < surface.segments.size(); ++i) {
        const SurfaceSegment& segment = surface.segments[SegmentId(i)];
        if (!segment.isAlive()) continue;
        for (const NodeId node : segment.node) checkNode(node, nameOf(SegmentId(i)));
    }
    for (std::uint32_t i = 0; i < surface.facets.size(); ++i) {
        const SurfaceFacet& facet = surface.facets[FacetId(i)];
        if (!facet.isAlive()) continue;
        for (const NodeId node : facet.node) checkNode(node, nameOf(FacetId(i)));
    }
    for (std::uint32_t i = 0; i < t.mesh().vertexLimit() && i < t.nodeOf.size(); ++i) {
        if (!t.mesh().isVertexAlive(VertexId(i)) || !t.nodeOf[VertexId(i)].isValid()) continue;
        if (!isVertexOf(t, t.nodeOf[VertexId(i)])) {
            report.add("vertex " + std::to_string(i) + " is not the one of its node");
        }
    }
}

/// Every live segment and facet is in the map under its own key; returns how many live ones there are.
std::size_t checkSegmentKeys(const ConstrainedTetrahedralization& t, const SurfaceMesh& surface,
                             CheckReport& report)
{
    std::size_t live = 0;
    for (std::uint32_t i = 0; i < surface.segments.size(); ++i) {
        const SurfaceSegment& segment = surface.segments[SegmentId(i)];
        if (!segment.isAlive()) continue;
        ++live;
        if (!isVertexOf(t, segment.node[0]) || !isVertexOf(t, segment.node[1])) continue;
        const SegmentId* found =
            t.segmentOf.find(unorderedPair(t.vertexOf[segment.node[0]], t.vertexOf[segment.node[1]]));
        if (found == nullptr || *found != SegmentId(i))
            report.add(nameOf(SegmentId(i)) + " is not in the map");
    }
    if (t.segmentOf.size() != live) report.add("the map names segments that are not there");
    return live;
}

std::size_t checkFacetKeys(const ConstrainedTetrahedralization& t, const SurfaceMesh& surface,
                           CheckReport& report)
{
    std::size_t live = 0;
    for (std::uint32_t i = 0; i < surface.facets.size(); ++i) {
        const SurfaceFacet& facet = surface.facets[FacetId(i)];
        if (!facet.isAlive()) continue;
        ++live;
        if (!std::all_of(facet.node.begin(), facet.node.end(), [&](NodeId n) { return isVertexOf(t, n); }))
            continue;
        std::array<VertexId, 3> key{t.vertexOf[facet.node[0]], t.vertexOf[facet.node[1]],
                                    t.vertexOf[facet.node[2]]};
        std::sort(key.begin(), key.end());
        const FacetId* found = t.facetOf.find(key);
        if (found == nullptr || *found != FacetId(i)) report.add(nameOf(FacetId(i)) + " is not in the map");
    }
    if (t.facetOf.size() != live) report.add("the map names facets that are not there");
    return live;
}

/// Every constrained face and edge is in the map, and as many are constrained as there are in it.
void checkConstraints(const ConstrainedTetrahedralization& t, std::size_t segments, std::size_t facets,
                      CheckReport& report)
{
    const Triangulation3d& mesh = t.mesh();
    std::size_t faces = 0;
    std::unordered_set<std::uint64_t> edges;
    for (std::uint32_t i = 0; i < mesh.tetLimit(); ++i) {
        const TetId tet(i);
        if (!mesh.isAlive(tet) || (mesh.flags(tet) & tet_flag::kConstraints) == 0) continue;
        for (int face = 0; face < 4; ++face) {
            if (!mesh.isFaceConstrained({tet, face}) || mesh.neighbour(tet, face).tet() < tet) continue;
            ++faces;
            std::array<VertexId, 3> key = mesh.faceVertices({tet, face});
            std::sort(key.begin(), key.end());
            if (!t.facetOf.contains(key)) report.add("a constrained face is no facet");
        }
        for (int edge = 0; edge < 6; ++edge) {
            if (!mesh.isEdgeConstrained(tet, edge)) continue;
            const auto ends =
                unorderedPair(mesh.vertex(tet, kEdgeSlots[edge][0]), mesh.vertex(tet, kEdgeSlots[edge][1]));
            if (!edges.insert(std::uint64_t{ends.first.value} << 32 | ends.second.value).second) continue;
            if (!t.segmentOf.contains(ends)) report.add("a constrained edge is no segment");
        }
    }
    if (faces != facets) {
        report.add(std::to_string(faces) + " constrained faces for " + std::to_string(facets) + " facets");
    }
    if (edges.size() != segments) {
        report.add(std::to_string(edges.size()) + " constrained edges for " + std::to_string(segments) +
                   " segments");
    }
}

}  // namespace

CheckReport checkRefinement(const ConstrainedTetrahedralization& tetrahedralization,
                            const SurfaceMesh& surface)
{
    CheckReport report = checkTopology3d(tetrahedralization.mesh());
    checkNodes(tetrahedralization, surface, report);
    const std::size_t segments = checkSegmentKeys(tetrahedralization, surface, report);
    const std::size_t facets = checkFacetKeys(tetrahedralization, surface, report);
    checkConstraints(tetrahedralization, segments, facets, report);
    return report;
}

}  // namespace mesher
