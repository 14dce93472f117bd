#include "base/indexed_map.h"
#include "surface_sampling/face_pinch.h"
#include "surface_sampling/initial_face_mesh.h"

#include <algorithm>
#include <optional>
#include <utility>

namespace mesher {

namespace {

class RoundsOfFaces
{
public:
    RoundsOfFaces(const BrepModel& model, CurveChains& chains, IdVector<NodeId, MeshNode>& nodes,
                  const InitialFaceMeshOptions& options, RunContext& context)
        : model_(model),
          chains_(chains),
          nodes_(nodes),
          options_(options),
          context_(context),
          facesOf_(model.edges.size()),
          isStale_(model.faces.size(), std::uint8_t{1}),
          isGivenUp_(model.faces.size(), std::uint8_t{0}),
          namings_(model.faces.size(), 0),
          taken_(model.faces.size()),
          errors_(model.faces.size())
    {
        result_.faces.resize(model.faces.size());
        for (std::uint32_t f = 0; f < model.faces.size(); ++f) {
            for (const BrepLoop& loop : model.faces[BrepFaceId(f)].loops) {
                for (const BrepCoedge& coedge : loop.coedges) facesOf_[coedge.edge].push_back(BrepFaceId(f));
            }
            for (const BrepEdgeId edge : model.faces[BrepFaceId(f)].embeddedEdges)
                facesOf_[edge].push_back(BrepFaceId(f));
        }
    }

    InitialSurfaceMesh run()
    {
        for (; result_.rounds < options_.maxRounds; ++result_.rounds) {
            std::vector<SegmentId> proposals;
            for (std::uint32_t f = 0; f < model_.faces.size(); ++f) {
                if (!mayGoOn()) break;
                if (isStale_[BrepFaceId(f)] != 0 && isGivenUp_[BrepFaceId(f)] == 0)
                    triangulate(BrepFaceId(f), proposals);
            }
            if (result_.stopReason != StopReason::Done) break;
            if (proposals.empty() && !findSharedEdges()) break;
            split(proposals);
        }
        finish();
        return std::move(result_);
    }

private:
    bool mayGoOn()
    {
        constexpr unsigned kFacesPerReport = 8;
        const double fraction = 1.0 - 1.0 / (1.0 + result_.rounds);
        if (++facesSeen_ % kFacesPerReport == 0) context_.reportProgress("first facets", fraction);
        if (const std::optional<StopReason> reason = context_.stopReason()) result_.stopReason = *reason;
        return result_.stopReason == StopReason::Done;
    }

    void triangulate(BrepFaceId f, std::vector<SegmentId>& proposals)
    {
        isStale_[f] = 0;
        if (std::optional<Error> pinch = refusePinch(model_, f)) {
            errors_[f] = std::move(pinch);
            return;
        }
        const NodeId first(static_cast<std::uint32_t>(nodes_.size()));
        auto mesh = triangulateFace(model_, f, chains_, nodes_, first, options_, taken_[f]);
        errors_[f].reset();
        if (!mesh) {
            errors_[f] = mesh.error();
            result_.faces[f] = {};
            return;
        }
        result_.faces[f] = std::move(*mesh);
        const auto& coarse = result_.faces[f].tooCoarse;
        if (coarse.empty()) return;
        if (++namings_[f] > options_.maxSplitsInSeries) {
            // Further splits for its sake would only spoil its neighbours.
            errors_[f] = chainsTooCoarse(f, placeOf(f), options_.maxSplitsInSeries);
            isGivenUp_[f] = 1;
            return;
        }
        proposals.insert(proposals.end(), coarse.begin(), coarse.end());
        isStale_[f] = 1;
    }

    /// A segment that the face named, or a vertex of its.
    [[nodiscard]] Vec3 placeOf(BrepFaceId f) const
    {
        const auto& coarse = result_.faces[f].tooCoarse;
        if (!coarse.empty()) return nodes_[chains_.segments()[coarse.front()].node[0]].position;
        const BrepEdgeId edge = model_.faces[f].loops.front().coedges.front().edge;
        return model_.vertices[model_.edges[edge].first].position;
    }

    void split(std::vector<SegmentId>& proposals)
    {
        std::sort(proposals.begin(), proposals.end());
        proposals.erase(std::unique(proposals.begin(), proposals.end()), proposals.end());
        for (const SegmentId s : proposals) {
            const BrepEdgeId edge = chains_.segments()[s].edge;
            if (!chains_.split(s, nodes_)) continue;
            ++result_.segmentSplits;
            for (const BrepFaceId f : facesOf_[edge]) isStale_[f] = 1;
        }
    }

    [[nodiscard]] bool isOnCurve(NodeId node) const
    {
        return node.value < nodes_.size() && nodes_[node].entity.dimension < 2;
    }
    [[nodiscard]] bool isPlane(BrepFaceId f) const
    {
        return model_.faces[f].surface->kind() == SurfaceKind::Plane;
    }

    /// Free edges between nodes of curves that two faces have, or that are a segment elsewhere: one of the faces is to yield.
    bool findSharedEdges()
    {
        IndexedMap<std::pair<NodeId, NodeId>, BrepFaceId> owners;
        for (const SurfaceSegment& segment : chains_.segments()) {
            if (segment.isAlive())
                owners.insert(unorderedPair(segment.node[0], segment.node[1]), BrepFaceId());
        }
        bool isAny = false;
        for (std::uint32_t i = 0; i < model_.faces.size(); ++i) {
            const BrepFaceId f(i);
            for (const auto& edge : freeEdgesOf(result_.faces[f])) {
                const auto [owner, isNew] = owners.insert(edge, f);
                if (isNew || *owner == f) continue;
                BrepFaceId yielding = f;
                // The flat facets of a curved face in the plane of a plane one would lie in its facets.
                if (owner->isValid() && isPlane(f)) yielding = *owner;
                taken_[yielding].push_back(edge);
                isStale_[yielding] = 1;
                isAny = true;
            }
        }
        return isAny;
    }

    [[nodiscard]] std::vector<std::pair<NodeId, NodeId>> freeEdgesOf(const InitialFaceMesh& mesh) const
    {
        std::vector<std::pair<NodeId, NodeId>> bounds;
        for (const FaceBoundaryPiece& piece : mesh.boundary)
            bounds.push_back(unorderedPair(piece.node[0], piece.node[1]));
        std::sort(bounds.begin(), bounds.end());
        std::vector<std::pair<NodeId, NodeId>> edges;
        for (const SurfaceFacet& facet : mesh.facets) {
            for (std::size_t k = 0; k < 3; ++k) {
                const NodeId a = facet.node[k], b = facet.node[(k + 1) % 3];
                if (!(a < b) || !(b < mesh.firstInteriorNode) || !isOnCurve(a) || !isOnCurve(b)) continue;
                if (!std::binary_search(bounds.begin(), bounds.end(), std::pair(a, b)))
                    edges.emplace_back(a, b);
            }
        }
        return edges;
    }

    /// Gives the interior nodes their final numbers.
    void finish()
    {
        for (std::uint32_t i = 0; i < model_.faces.size(); ++i) {
            const BrepFaceId f(i);
            InitialFaceMesh& mesh = result_.faces[f];
            if (!errors_[f] && isStale_[f] != 0 && result_.stopReason == StopReason::Done) {
                errors_[f] = chainsTooCoarse(f, placeOf(f), options_.maxRounds);
            }
            if (errors_[f]) {
                result_.failures.emplace_back(f, *errors_[f]);
                mesh.facets.clear();
                mesh.interiorNodes.clear();
                mesh.ringNodes.clear();
            }
            const NodeId first(static_cast<std::uint32_t>(nodes_.size()));
            const auto renumber = [&](NodeId& node) {
                if (!(node < mesh.firstInteriorNode))
                    node = NodeId(first.value + (node.value - mesh.firstInteriorNode.value));
            };
            for (SurfaceFacet& facet : mesh.facets) {
                for (NodeId& node : facet.node) renumber(node);
            }
            for (NodeId& node : mesh.ringNodes) renumber(node);
            std::sort(mesh.ringNodes.begin(), mesh.ringNodes.end());
            mesh.firstInteriorNode = first;
            for (const MeshNode& node : mesh.interiorNodes) nodes_.push_back(node);
        }
    }

    const BrepModel& model_;
    CurveChains& chains_;
    IdVector<NodeId, MeshNode>& nodes_;
    const InitialFaceMeshOptions& options_;
    RunContext& context_;
    std::uint64_t facesSeen_ = 0;
    IdVector<BrepEdgeId, std::vector<BrepFaceId>> facesOf_;
    IdVector<BrepFaceId, std::uint8_t> isStale_;
    IdVector<BrepFaceId, std::uint8_t> isGivenUp_;
    IdVector<BrepFaceId, int> namings_;  ///< rounds in which the face named segments
    IdVector<BrepFaceId, std::vector<std::pair<NodeId, NodeId>>> taken_;
    IdVector<BrepFaceId, std::optional<Error>> errors_;
    InitialSurfaceMesh result_;
};

}  // namespace

InitialSurfaceMesh initialSurfaceMesh(const BrepModel& model, CurveChains& chains,
                                      IdVector<NodeId, MeshNode>& nodes,
                                      const InitialFaceMeshOptions& options, RunContext& context)
{
    return RoundsOfFaces(model, chains, nodes, options, context).run();
}

SurfaceMesh assembleSurfaceMesh(const CurveChains& chains, const IdVector<NodeId, MeshNode>& nodes,
                                const InitialSurfaceMesh& initial)
{
    SurfaceMesh mesh{nodes, chains.segments(), {}};
    for (const InitialFaceMesh& face : initial.faces) {
        for (const SurfaceFacet& facet : face.facets) mesh.facets.push_back(facet);
    }
    return mesh;
}

}  // namespace mesher
