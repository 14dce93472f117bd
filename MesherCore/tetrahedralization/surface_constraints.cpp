#include "tetrahedralization/surface_constraints.h"

#include <algorithm>

namespace mesher {

namespace {

std::array<VertexId, 3> sorted(std::array<VertexId, 3> corner)
{
    std::sort(corner.begin(), corner.end());
    return corner;
}

int edgeOf(const Triangulation3d& mesh, TetId tet, VertexId a, VertexId b)
{
    return kEdgeOfSlots[mesh.slotOf(tet, a)][mesh.slotOf(tet, b)];
}

}  // namespace

std::array<VertexId, 3> SurfaceConstraints::cornersOf(FacetId facet) const
{
    const auto& node = surface().facets[facet].node;
    return {tets_.vertexOf[node[0]], tets_.vertexOf[node[1]], tets_.vertexOf[node[2]]};
}

NodeId SurfaceConstraints::nodeAt(VertexId vertex) const
{
    return vertex.value < tets_.nodeOf.size() ? tets_.nodeOf[vertex] : NodeId();
}

void SurfaceConstraints::listFacetsByNode()
{
    facetsByNode_.resize(surface().nodes.size());
    for (std::uint32_t i = 0; i < surface().facets.size(); ++i) {
        if (!surface().facets[FacetId(i)].isAlive()) continue;
        for (const NodeId node : surface().facets[FacetId(i)].node) facetsByNode_[node].push_back(FacetId(i));
    }
}

std::vector<FacetId> SurfaceConstraints::facetsAt(VertexId a, VertexId b)
{
    std::vector<FacetId> facets;
    const NodeId from = nodeAt(a);
    const NodeId to = nodeAt(b);
    if (!from.isValid() || !to.isValid()) return facets;
    if (facetsByNode_.empty()) listFacetsByNode();
    std::vector<FacetId>& atNode = facetsByNode_[from];
    std::erase_if(atNode, [&](FacetId facet) { return !surface().facets[facet].isAlive(); });
    for (const FacetId facet : atNode) {
        const auto& node = surface().facets[facet].node;
        if (std::find(node.begin(), node.end(), to) != node.end()) facets.push_back(facet);
    }
    std::sort(facets.begin(), facets.end());
    return facets;
}

SegmentId SurfaceConstraints::segmentAt(VertexId a, VertexId b) const
{
    const SegmentId* segment = tets_.segmentOf.find(unorderedPair(a, b));
    return segment == nullptr ? SegmentId() : *segment;
}

bool SurfaceConstraints::isConstraint(TetId tet, VertexId a, VertexId b) const
{
    if (mesh().isEdgeConstrained(tet, edgeOf(mesh(), tet, a, b))) return true;
    std::vector<TetId> ring;
    mesh().collectEdgeRing(tet, a, b, ring);
    return std::any_of(ring.begin(), ring.end(), [&](TetId other) {
        for (int face = 0; face < 4; ++face) {
            const VertexId opposite = mesh().vertex(other, face);
            if (opposite != a && opposite != b && mesh().isFaceConstrained({other, face})) return true;
        }
        return false;
    });
}

void SurfaceConstraints::lockEdge(TetId tet, VertexId a, VertexId b)
{
    if (mesh().isEdgeConstrained(tet, edgeOf(mesh(), tet, a, b))) return;
    mesh().setEdgeConstrained(tet, a, b, true);
    if (!segmentAt(a, b).isValid()) temporaryLocks_.push_back(unorderedPair(a, b));
}

void SurfaceConstraints::lockFacet(TetFace face)
{
    mesh().setFaceConstrained(face, true);
    for (const VertexId corner : mesh().faceVertices(face)) {
        if (corner.value < isLoose_.size()) isLoose_[corner] = 0;
    }
}

void SurfaceConstraints::releaseTemporaryLocks()
{
    for (const auto& [a, b] : temporaryLocks_) {
        // Vertices of temporary splits may be gone.
        if (segmentAt(a, b).isValid() || !mesh().isVertexAlive(a) || !mesh().isVertexAlive(b)) continue;
        const TetId tet = mesh().findEdge(a, b);
        if (tet.isValid()) mesh().setEdgeConstrained(tet, a, b, false);
    }
    temporaryLocks_.clear();
}

void SurfaceConstraints::loosenFacetsAt(VertexId vertex)
{
    // Recovery asks after each step, and stars are large where many facets meet a vertex.
    if (vertex.value < isLoose_.size() && isLoose_[vertex] != 0) return;
    isLoose_.resize(std::max<std::size_t>(isLoose_.size(), mesh().vertexLimit()), 0);
    isLoose_[vertex] = 1;
    std::vector<TetId> star;
    mesh().collectStar(vertex, star);
    for (const TetId tet : star) {
        for (int face = 0; face < 4; ++face) {
            if (!mesh().isFaceConstrained({tet, face})) continue;
            const auto corner = mesh().faceVertices({tet, face});
            const FacetId* facet = tets_.facetOf.find(sorted(corner));
            MESHER_INVARIANT(facet != nullptr);
            for (unsigned k = 0; k < 3; ++k) lockEdge(tet, corner[k], corner[(k + 1) % 3]);
            mesh().setFaceConstrained({tet, face}, false);
            missingFacets.push_back(*facet);
        }
    }
}

void SurfaceConstraints::requireEdge(VertexId a, VertexId b)
{
    const TetId tet = mesh().findEdge(a, b);
    if (tet.isValid()) {
        lockEdge(tet, a, b);
    } else {
        missingEdges.push_back(unorderedPair(a, b));
    }
}

void SurfaceConstraints::require(FacetId facet)
{
    const auto corner = cornersOf(facet);
    tets_.facetOf.insertOrAssign(sorted(corner), facet);
    const TetFace face = mesh().findFace(corner[0], corner[1], corner[2]);
    if (face.isValid()) {
        lockFacet(face);
        return;
    }
    missingFacets.push_back(facet);
    for (unsigned k = 0; k < 3; ++k) requireEdge(corner[k], corner[(k + 1) % 3]);
}

void SurfaceConstraints::require(SegmentId segment)
{
    const auto& node = surface().segments[segment].node;
    const VertexId a = tets_.vertexOf[node[0]];
    const VertexId b = tets_.vertexOf[node[1]];
    tets_.segmentOf.insertOrAssign(unorderedPair(a, b), segment);
    requireEdge(a, b);
}

void SurfaceConstraints::unlock(VertexId a, VertexId b)
{
    const TetId tet = mesh().findEdge(a, b);
    if (tet.isValid()) mesh().setEdgeConstrained(tet, a, b, false);
}

void SurfaceConstraints::release(const SurfaceSplit& split)
{
    if (split.segment.isValid()) {
        const auto& node = surface().segments[split.segment].node;
        tets_.segmentOf.erase(unorderedPair(tets_.vertexOf[node[0]], tets_.vertexOf[node[1]]));
        unlock(tets_.vertexOf[node[0]], tets_.vertexOf[node[1]]);
    }
    const auto isRemoved = [&](FacetId facet) {
        return std::find(split.removed.begin(), split.removed.end(), facet) != split.removed.end();
    };
    for (const FacetId facet : split.removed) {
        const auto corner = cornersOf(facet);
        tets_.facetOf.erase(sorted(corner));
        const TetFace face = mesh().findFace(corner[0], corner[1], corner[2]);
        if (face.isValid()) mesh().setFaceConstrained(face, false);
        for (unsigned k = 0; k < 3; ++k) {
            const VertexId a = corner[k];
            const VertexId b = corner[(k + 1) % 3];
            const std::vector<FacetId> facets = facetsAt(a, b);
            if (!segmentAt(a, b).isValid() && std::all_of(facets.begin(), facets.end(), isRemoved))
                unlock(a, b);
        }
    }
}

void SurfaceConstraints::restore(const SurfaceSplit& split)
{
    if (split.segment.isValid()) require(split.segment);
    for (const FacetId facet : split.removed) require(facet);
}

void SurfaceConstraints::make(const SurfaceSplit& split, VertexId vertex)
{
    const SurfaceSplitResult result = active_->commit(split);
    tets_.nodeOf.resize(std::max<std::size_t>(tets_.nodeOf.size(), mesh().vertexLimit()));
    tets_.vertexOf.resize(surface().nodes.size());
    tets_.nodeOf[vertex] = result.node;
    tets_.vertexOf[result.node] = vertex;
    if (!facetsByNode_.empty()) {
        facetsByNode_.resize(surface().nodes.size());
        for (const FacetId facet : result.added) {
            for (const NodeId node : surface().facets[facet].node) facetsByNode_[node].push_back(facet);
        }
    }
    if (split.segment.isValid()) {
        for (const SegmentId half : result.halves) require(half);
    }
    for (const FacetId facet : result.added) require(facet);
}

// --- temporary splits

bool SurfaceConstraints::startTemporarySplits()
{
    if (temporary_) return false;
    temporary_ = std::make_unique<TemporarySplits>(exact_.mesh());
    active_ = temporary_.get();
    return true;
}

void SurfaceConstraints::takeBack(std::size_t index)
{
    const TemporarySplits::Made& made = temporary_->made()[index];
    const auto endsOf = [&](SegmentId segment) {
        const auto& node = surface().segments[segment].node;
        return std::pair(tets_.vertexOf[node[0]], tets_.vertexOf[node[1]]);
    };
    for (const FacetId facet : made.result.added) tets_.facetOf.erase(sorted(cornersOf(facet)));
    if (made.split.segment.isValid()) {
        for (const SegmentId half : made.result.halves) {
            const auto [a, b] = endsOf(half);
            tets_.segmentOf.erase(unorderedPair(a, b));
        }
        const auto [a, b] = endsOf(made.split.segment);
        tets_.segmentOf.insertOrAssign(unorderedPair(a, b), made.split.segment);
        lockEdge(mesh().findEdge(a, b), a, b);
    }
    for (const FacetId facet : made.split.removed)
        tets_.facetOf.insertOrAssign(sorted(cornersOf(facet)), facet);
    temporary_->takeBack(index);
    VertexId& vertex = tets_.vertexOf[made.result.node];
    tets_.nodeOf[vertex] = NodeId();
    vertex = VertexId();
    facetsByNode_.clear();
}

Result<void> SurfaceConstraints::endTemporarySplits()
{
    if (!temporary_) return {};
    IndexedMap<NodeId, NodeId> nodes;
    IndexedMap<SegmentId, SegmentId> segments;
    IndexedMap<FacetId, FacetId> facets;
    const auto idIn = [](const auto& map, auto id) {
        const auto* mapped = map.find(id);
        return mapped == nullptr ? id : *mapped;
    };
    IdVector<NodeId, VertexId> vertexOf = tets_.vertexOf;
    vertexOf.resize(exact_.mesh().nodes.size());
    for (const TemporarySplits::Made& made : temporary_->made()) {
        if (made.isTakenBack) continue;
        SurfaceSplit split = made.split;
        if (split.segment.isValid()) split.segment = idIn(segments, split.segment);
        for (SurfaceSegment& half : split.halves) {
            for (NodeId& node : half.node) node = idIn(nodes, node);
        }
        for (FacetId& facet : split.removed) facet = idIn(facets, facet);
        for (SurfaceFacet& facet : split.added) {
            for (NodeId& node : facet.node) node = idIn(nodes, node);
        }
        if (!exact_.accepts(split)) {
            return Error{ErrorCode::DegenerateInput,
                         "a vertex of recovery could not be taken off the surface", nameOf(split.node.entity),
                         split.node.position, "make the surface mesh finer there"};
        }
        const SurfaceSplitResult result = exact_.commit(split);
        nodes.insert(made.result.node, result.node);
        vertexOf.push_back(tets_.vertexOf[made.result.node]);
        tets_.nodeOf[vertexOf[result.node]] = result.node;
        for (std::size_t i = 0; i < result.added.size(); ++i)
            facets.insert(made.result.added[i], result.added[i]);
        for (std::size_t i = 0; i < 2 && split.segment.isValid(); ++i)
            segments.insert(made.result.halves[i], result.halves[i]);
    }
    tets_.vertexOf = std::move(vertexOf);
    active_ = &exact_;
    temporary_.reset();
    facetsByNode_.clear();
    for (const auto& [old, id] : facets) {
        if (surface().facets[id].isAlive()) tets_.facetOf.insertOrAssign(sorted(cornersOf(id)), id);
    }
    for (const auto& [old, id] : segments) {
        if (!surface().segments[id].isAlive()) continue;
        const auto& node = surface().segments[id].node;
        tets_.segmentOf.insertOrAssign(unorderedPair(tets_.vertexOf[node[0]], tets_.vertexOf[node[1]]), id);
    }
    return {};
}

std::string SurfaceConstraints::nameOfFacet(FacetId facet) const
{
    return nameOf(surface().facets[facet].face);
}

std::string SurfaceConstraints::nameOfEdge(VertexId a, VertexId b)
{
    const SegmentId segment = segmentAt(a, b);
    if (segment.isValid()) return nameOf(surface().segments[segment].edge);
    const std::vector<FacetId> facets = facetsAt(a, b);
    return facets.empty() ? std::string() : nameOfFacet(facets.front());
}

std::string SurfaceConstraints::nameOfVertex(VertexId vertex) const
{
    const NodeId node = nodeAt(vertex);
    return node.isValid() ? nameOf(surface().nodes[node].entity) : std::string();
}

}  // namespace mesher
