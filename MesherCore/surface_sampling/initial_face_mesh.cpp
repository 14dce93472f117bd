#include "surface_sampling/initial_face_mesh.h"

#include "surface_sampling/apex_rings.h"
#include "surface_sampling/face_folds.h"
#include "surface_sampling/face_outline.h"
#include "surface_sampling/face_points.h"
#include "surface_sampling/face_refinement.h"
#include "surface_sampling/face_triangulation.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>

namespace mesher {

namespace {

class FaceLifter
{
public:
    FaceLifter(BrepFaceId id, const BrepFace& face, const FaceTriangulation& t, NodeId firstInteriorNode)
        : id_(id), face_(face), t_(t), nodeOf_(t.mesh().vertexSlots())
    {
        mesh_.firstInteriorNode = firstInteriorNode;
    }

    Result<InitialFaceMesh> run(const FaceOutline& outline)
    {
        const Triangulation2d& mesh = t_.mesh();
        for (std::uint32_t i = 0; i < mesh.triangleSlots(); ++i) {
            const TriangleId t(i);
            if (!mesh.isAlive(t) || !t_.isInside(t)) continue;
            if (auto lifted = lift(mesh.triangle(t)); !lifted) return lifted.error();
        }
        for (const OutlinePiece& piece : outline.pieces) {
            if (!piece.segment.isValid()) continue;
            const OutlinePoint &from = outline.points[piece.from], &to = outline.points[piece.to];
            mesh_.boundary.push_back({piece.segment,
                                      piece.loop,
                                      piece.coedge,
                                      {from.node, to.node},
                                      {from.uv, to.uv},
                                      piece.shift});
        }
        collectRings();
        return std::move(mesh_);
    }

private:
    void collectRings()
    {
        for (std::uint32_t i = 0; i < t_.points.size(); ++i) {
            const FacePoint& point = t_.points[VertexId(i)];
            if (!point.isOnRing) continue;
            const NodeId node = point.node.isValid() ? point.node : nodeOf_[VertexId(i)];
            if (node.isValid()) mesh_.ringNodes.push_back(node);
        }
    }

    NodeId nodeOf(VertexId v)
    {
        const FacePoint& point = t_.points[v];
        if (point.node.isValid()) return point.node;
        NodeId& node = nodeOf_[v];
        if (!node.isValid()) {
            node = NodeId(mesh_.firstInteriorNode.value +
                          static_cast<std::uint32_t>(mesh_.interiorNodes.size()));
            mesh_.interiorNodes.push_back({point.position, {2, id_.value}, point.uv});
        }
        return node;
    }

    Result<void> lift(const Triangle2d& triangle)
    {
        SurfaceFacet facet;
        facet.face = id_;
        std::array<const FacePoint*, 3> p{};
        for (unsigned i = 0; i < 3; ++i) p[i] = &t_.points[triangle.v[i]];
        int poles = 0;
        for (const FacePoint* point : p) poles += point->isPole ? 1 : 0;
        // Between two images of a pole there is nothing in space.
        if (poles >= 2 && samePole(p)) return {};
        for (unsigned i = 0; i < 3; ++i) {
            facet.node[i] = nodeOf(triangle.v[i]);
            const FacePoint &a = *p[nextCorner(i)], &b = *p[previousCorner(i)];
            facet.parameters[i] = p[i]->isPole ? parametersBeside(*p[i], middleOf(a, b)) : p[i]->uv;
        }
        if (!isUpright(p)) {
            // What is narrower than the face is exact may lie across.
            if (!isWithinTolerance(face_, p)) return folded(*p[0]);
            ++mesh_.leftAlone;
        }
        mesh_.facets.push_back(facet);
        return {};
    }

    static bool samePole(const std::array<const FacePoint*, 3>& p)
    {
        for (unsigned i = 0; i < 3; ++i) {
            const FacePoint &a = *p[nextCorner(i)], &b = *p[previousCorner(i)];
            if (a.isPole && b.isPole && a.node == b.node) return true;
        }
        return false;
    }

    [[nodiscard]] Error folded(const FacePoint& point) const
    {
        Error error;
        error.code = ErrorCode::DegenerateInput;
        error.entity = nameOf(id_);
        error.message = "its facets fold over where the surface folds or its edges lie too close";
        error.point = point.position;
        error.remedy = "repair the face there, or lower its tolerance";
        return error;
    }

    BrepFaceId id_;
    const BrepFace& face_;
    const FaceTriangulation& t_;
    IdVector<VertexId, NodeId> nodeOf_;
    InitialFaceMesh mesh_;
};

enum class ShapeOutcome
{
    Done,
    TooManyPoints,
    Inseparable
};

struct Shaping
{
    ShapeOutcome outcome = ShapeOutcome::Done;
    std::size_t leftAlone = 0;
    std::size_t openTips = 0;
};

/// Refines by turns until the facets follow the surface and each of their sides is one of its own.
Shaping shapeFace(const BrepModel& model, BrepFaceId id, const FaceOutline& outline,
                  const CurveChains& chains, const InitialFaceMeshOptions& options,
                  std::span<const std::pair<NodeId, NodeId>> taken, FaceTriangulation& t)
{
    constexpr int kMostTurns = 40;
    const BrepFace& face = model.faces[id];
    Shaping shaping;
    if (!t.tooCoarse.empty()) return shaping;
    const bool isCurved = face.surface->kind() != SurfaceKind::Plane;
    if (isCurved) {
        shaping.openTips = insertApexRings(model, id, chains, t);
        seedFace(model, id, chains, t);
    }
    for (int turn = 0; turn < kMostTurns; ++turn) {
        if (isCurved) {
            const FaceRefinement refined = followSurface(face, outline, chains, options, t);
            shaping.leftAlone = refined.givenUp;
            if (!refined.isComplete) return {ShapeOutcome::TooManyPoints, refined.givenUp};
        }
        if (!t.tooCoarse.empty() || !separateSides(face, outline, taken, t)) return shaping;
    }
    return {ShapeOutcome::Inseparable, shaping.leftAlone};
}

Error unshaped(BrepFaceId face, const FaceTriangulation& t, ShapeOutcome outcome)
{
    Error error;
    error.code = ErrorCode::OutOfRange;
    error.entity = nameOf(face);
    error.message = outcome == ShapeOutcome::TooManyPoints
                        ? "its facets do not follow the surface within the budget of points"
                        : "its facets stay joined where the face is not";
    // The last vertex is where the work went on.
    error.point = t.points[VertexId(static_cast<std::uint32_t>(t.points.size() - 1))].position;
    error.remedy = "smooth the surface or split the face";
    return error;
}

}  // namespace

Result<InitialFaceMesh> triangulateFace(const BrepModel& model, BrepFaceId face, const CurveChains& chains,
                                        const IdVector<NodeId, MeshNode>& nodes, NodeId firstInteriorNode,
                                        const InitialFaceMeshOptions& options,
                                        std::span<const std::pair<NodeId, NodeId>> taken)
{
    const auto outline = outlineOf(model, face, chains, nodes);
    if (!outline) return outline.error();
    auto triangulation = triangulateOutline(model, face, chains, nodes, *outline);
    if (!triangulation) return triangulation.error();
    const Shaping shaping = shapeFace(model, face, *outline, chains, options, taken, *triangulation);
    if (shaping.outcome != ShapeOutcome::Done) return unshaped(face, *triangulation, shaping.outcome);
    if (!triangulation->tooCoarse.empty()) {
        InitialFaceMesh coarse;
        coarse.tooCoarse = std::move(triangulation->tooCoarse);
        return coarse;
    }
    auto mesh = FaceLifter(face, model.faces[face], *triangulation, firstInteriorNode).run(*outline);
    if (mesh) mesh->leftAlone += shaping.leftAlone;
    if (mesh) mesh->openTips = shaping.openTips;
    return mesh;
}

Result<std::vector<SurfaceFacet>> initialFaceMesh(const BrepModel& model, BrepFaceId face,
                                                  CurveChains& chains, IdVector<NodeId, MeshNode>& nodes,
                                                  const InitialFaceMeshOptions& options)
{
    Vec3 last;
    for (int round = 0; round < options.maxSplitsInSeries; ++round) {
        const NodeId first(static_cast<std::uint32_t>(nodes.size()));
        auto mesh = triangulateFace(model, face, chains, nodes, first, options);
        if (!mesh) return mesh.error();
        if (mesh->tooCoarse.empty()) {
            for (const MeshNode& node : mesh->interiorNodes) nodes.push_back(node);
            return std::move(mesh->facets);
        }
        for (const SegmentId s : mesh->tooCoarse) {
            if (const auto split = chains.split(s, nodes)) last = nodes[split->node].position;
        }
    }
    return chainsTooCoarse(face, last, options.maxSplitsInSeries);
}

Error chainsTooCoarse(BrepFaceId face, const Vec3& point, int rounds)
{
    Error error;
    error.code = ErrorCode::DegenerateInput;
    error.entity = nameOf(face);
    error.message = "its edges are too close to each other to be told apart in " + std::to_string(rounds) +
                    " rounds of splits";
    error.point = point;
    error.remedy = "repair the face, or merge its small edges";
    return error;
}

}  // namespace mesher
