#include "pipeline/classify_solids.h"

#include "base/indexed_map.h"

#include <algorithm>
#include <utility>
#include <vector>

namespace mesher {

namespace {

/// Nodes are taken over when an element that is written has them.
class SolidClassifier
{
public:
    SolidClassifier(const SurfaceMesh& surface, const RegionSides& sides, RunContext& context)
        : surface_(surface), sides_(sides), watch_(context), nodeOf_(surface.nodes.size())
    {
    }

    void addSurface()
    {
        const std::vector<FacetId> facets = facetsInOrder();
        markNodes(facets);
        for (std::uint32_t i = 0; i < surface_.nodes.size(); ++i) {
            if (isUsed_[i]) nodeOf_[NodeId(i)] = mesh_.nodes.push_back(surface_.nodes[NodeId(i)]);
        }
        for (const FacetId f : facets) {
            if (!watch_.mayGoOn()) return;
            addTriangle(surface_.facets[f]);
        }
        addLines();
        addPoints();
    }

    void addVolume(const ConstrainedTetrahedralization& tetrahedralization)
    {
        const Triangulation3d& tets = tetrahedralization.mesh();
        std::vector<std::pair<RegionId, TetId>> inside;
        for (std::uint32_t i = 0; i < tets.tetLimit() && watch_.mayGoOn(); ++i) {
            const TetId t(i);
            if (tets.isAlive(t) && !tets.isGhostTet(t) && tets.region(t) != kExteriorRegion)
                inside.emplace_back(tets.region(t), t);
        }
        std::sort(inside.begin(), inside.end());
        if (!watch_.mayGoOn()) return;
        IdVector<VertexId, NodeId> nodeAt(tets.vertexLimit());
        addInnerNodes(tetrahedralization, inside, nodeAt);
        for (const auto& [region, t] : inside) {
            if (!watch_.mayGoOn()) return;
            const auto& v = tets.tet(t).vertex;
            mesh_.tets.push_back(
                {{nodeAt[v[0]], nodeAt[v[1]], nodeAt[v[2]], nodeAt[v[3]]}, {3, region.value - 1}});
        }
    }

    [[nodiscard]] ClassifiedMesh take() { return std::move(mesh_); }

private:
    [[nodiscard]] std::vector<FacetId> facetsInOrder() const
    {
        std::vector<std::pair<BrepFaceId, FacetId>> order;
        for (std::uint32_t i = 0; i < surface_.facets.size(); ++i) {
            const SurfaceFacet& facet = surface_.facets[FacetId(i)];
            if (facet.isAlive()) order.emplace_back(facet.face, FacetId(i));
        }
        std::sort(order.begin(), order.end());
        std::vector<FacetId> facets;
        for (const auto& [face, facet] : order) facets.push_back(facet);
        return facets;
    }

    void markNodes(const std::vector<FacetId>& facets)
    {
        isUsed_.assign(surface_.nodes.size(), false);
        for (const FacetId f : facets) {
            for (const NodeId n : surface_.facets[f].node) isUsed_[n.value] = true;
        }
    }

    void addTriangle(const SurfaceFacet& facet)
    {
        std::array<NodeId, 3> node = {nodeOf_[facet.node[0]], nodeOf_[facet.node[1]], nodeOf_[facet.node[2]]};
        const auto& [ahead, behind] = sides_[facet.face];
        const bool looksIn = ahead != kExteriorRegion && (behind == kExteriorRegion || ahead < behind);
        if (looksIn) std::swap(node[1], node[2]);
        mesh_.triangles.push_back({node, {2, facet.face.value}});
        for (std::size_t i = 0; i < 3; ++i)
            triangleSides_.insert(unorderedPair(node[i], node[(i + 1) % 3]), true);
    }

    void addLines()
    {
        std::vector<SegmentId> order;
        for (std::uint32_t i = 0; i < surface_.segments.size(); ++i) {
            const SurfaceSegment& segment = surface_.segments[SegmentId(i)];
            if (segment.isAlive() && isSide(segment)) order.push_back(SegmentId(i));
        }
        std::sort(order.begin(), order.end(), [this](SegmentId a, SegmentId b) {
            const SurfaceSegment& left = surface_.segments[a];
            const SurfaceSegment& right = surface_.segments[b];
            return std::pair(left.edge, left.parameter[0]) < std::pair(right.edge, right.parameter[0]);
        });
        for (const SegmentId s : order) {
            const SurfaceSegment& segment = surface_.segments[s];
            mesh_.lines.push_back(
                {{nodeOf_[segment.node[0]], nodeOf_[segment.node[1]]}, {1, segment.edge.value}});
        }
    }

    [[nodiscard]] bool isSide(const SurfaceSegment& segment) const
    {
        const NodeId a = nodeOf_[segment.node[0]];
        const NodeId b = nodeOf_[segment.node[1]];
        return a.isValid() && b.isValid() && triangleSides_.find(unorderedPair(a, b)) != nullptr;
    }

    void addPoints()
    {
        for (std::uint32_t i = 0; i < mesh_.nodes.size(); ++i) {
            const EntityRef entity = mesh_.nodes[NodeId(i)].entity;
            if (entity.dimension == 0) mesh_.points.push_back({{NodeId(i)}, entity});
        }
        std::sort(mesh_.points.begin(), mesh_.points.end(),
                  [](const auto& a, const auto& b) { return a.entity < b.entity; });
    }

    void addInnerNodes(const ConstrainedTetrahedralization& tetrahedralization,
                       const std::vector<std::pair<RegionId, TetId>>& inside,
                       IdVector<VertexId, NodeId>& nodeAt)
    {
        const Triangulation3d& tets = tetrahedralization.mesh();
        IdVector<VertexId, RegionId> regionAt(tets.vertexLimit());
        for (const auto& [region, t] : inside) {
            for (const VertexId v : tets.tet(t).vertex) regionAt[v] = region;
        }
        const double unit = 1.0 / tetrahedralization.scale;
        for (std::uint32_t i = 0; i < tets.vertexLimit(); ++i) {
            const VertexId v(i);
            if (!regionAt[v].isValid()) continue;
            const NodeId node =
                v.value < tetrahedralization.nodeOf.size() ? tetrahedralization.nodeOf[v] : NodeId();
            nodeAt[v] =
                node.isValid()
                    ? nodeOf_[node]
                    : mesh_.nodes.push_back({unit * tets.position(v), {3, regionAt[v].value - 1}, {}});
        }
    }

    const SurfaceMesh& surface_;
    const RegionSides& sides_;
    StepWatch watch_;
    IdVector<NodeId, NodeId> nodeOf_;
    std::vector<bool> isUsed_;
    IndexedMap<std::pair<NodeId, NodeId>, bool> triangleSides_;
    ClassifiedMesh mesh_;
};

}  // namespace

ClassifiedMesh classifySolids(const ConstrainedTetrahedralization& tetrahedralization,
                              const SurfaceMesh& surface, const RegionSides& sides, RunContext& context)
{
    SolidClassifier classifier(surface, sides, context);
    classifier.addSurface();
    classifier.addVolume(tetrahedralization);
    return classifier.take();
}

ClassifiedMesh classifySurface(const SurfaceMesh& surface, const RegionSides& sides, RunContext& context)
{
    SolidClassifier classifier(surface, sides, context);
    classifier.addSurface();
    return classifier.take();
}

}  // namespace mesher
