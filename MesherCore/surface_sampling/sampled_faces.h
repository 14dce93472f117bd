#pragma once

#include "base/budget.h"
#include "base/error.h"
#include "base/id_vector.h"
#include "base/run_context.h"
#include "base/stop_reason.h"
#include "brep/brep_model.h"
#include "surface_sampling/curve_chains.h"
#include "surface_sampling/face_flips.h"
#include "surface_sampling/initial_face_mesh.h"
#include "surface_sampling/surface_refinement.h"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <utility>
#include <vector>

namespace mesher {

/// What a face is asked, its mesh and the refinement of that; each face has its own, so that faces can be refined at once.
class SampledFace
{
public:
    SampledFace(const BrepFace& face, FaceMesh faceMesh, const FaceBoundary& boundary,
                const FaceRefinementOptions& options)
        : geometry(face), mesh(std::move(faceMesh)), refiner(mesh, geometry, boundary, options)
    {
    }
    SampledFace(const SampledFace&) = delete;
    SampledFace& operator=(const SampledFace&) = delete;

    FaceGeometry geometry;
    FaceMesh mesh;
    FaceRefiner refiner;
    StopReason stopReason = StopReason::Done;
    bool isActive = true;  ///< something has changed since it was refined, or its proposals were answered
};

struct SamplingRounds
{
    int rounds = 0;
    std::size_t segmentSplits = 0;
    std::size_t refusedSplits = 0;  ///< segments as short as they may be
    std::size_t flips = 0;          ///< that made the first meshes Delaunay
    StopReason stopReason = StopReason::Done;
};

/// The chains of a model and the meshes of all of its faces, refined in rounds: faces go by themselves as far as they can
/// without the segments they propose to split; the splits of all faces are made in the order of edge and parameter, and
/// followed by all faces beside them.
/// Guarantees   the result does not depend on the number of threads; the meshes of faces match along the segments
/// Reference    thesis §3.3.2, where the faces are sampled one after the other
class SampledFaces
{
public:
    /// Takes over chains and nodes; the model must outlive it. Nodes inside of faces become the faces' own.
    SampledFaces(const BrepModel& model, CurveChains chains, IdVector<NodeId, MeshNode> nodes,
                 const InitialSurfaceMesh& initial, const FaceRefinementOptions& options);

    /// Refines all faces. Terminates by the limits, which hold for the whole model, and by `maxRounds`.
    SamplingRounds refine(const BudgetLimits& limits, int maxRounds, RunContext& context);
    /// Flat facets on what may be the rims of walls wait until it is known which walls are kept flat. Requires the first meshes.
    void leaveFlatOnRims(const RegionSides& sides);
    [[nodiscard]] const WallRims& rims() const { return *rims_; }
    /// As WallRims::keep; faces with other facets that waited are refined again next. False if there are none.
    bool keepRimsOf(std::vector<WallSides> walls, std::vector<WallSides> goodWalls,
                    std::vector<BrepFaceId> strips);
    /// Has a facet split in the next refinement, whatever its shape.
    void force(BrepFaceId face, TriangleId facet);

    [[nodiscard]] const BrepModel& model() const { return model_; }
    [[nodiscard]] const CurveChains& chains() const { return chains_; }
    [[nodiscard]] CurveChains& chains() { return chains_; }
    /// Of the model's vertices and edges.
    [[nodiscard]] const IdVector<NodeId, MeshNode>& nodes() const { return nodes_; }
    /// Null for a face that failed.
    [[nodiscard]] SampledFace* face(BrepFaceId f) const { return faces_[f].get(); }
    /// The faces beside an edge, each once, ascending.
    [[nodiscard]] const std::vector<BrepFaceId>& facesOf(BrepEdgeId edge) const { return facesOf_[edge]; }
    [[nodiscard]] const std::vector<std::pair<BrepFaceId, Error>>& failures() const { return failures_; }
    [[nodiscard]] std::size_t vertexCount() const;
    [[nodiscard]] FaceRefinementCounts counts() const;
    /// Those on which the angle asked for was out of reach.
    [[nodiscard]] std::vector<BrepFaceId> facesWithoutAngle() const;

private:
    class Boundary final : public FaceBoundary
    {
    public:
        explicit Boundary(const SampledFaces& faces) : faces_(faces) {}
        [[nodiscard]] bool maySplit(SegmentId segment) const override;
        [[nodiscard]] bool isAtApex(SegmentId segment) const override;
        [[nodiscard]] bool spansSmallAngle(NodeId a, NodeId b) const override;
        [[nodiscard]] BrepEdgeId edgeOf(SegmentId segment) const override;
        [[nodiscard]] double wholeLengthOf(SegmentId segment) const override;

    private:
        const SampledFaces& faces_;
    };

    void findFacesOfEdges();
    [[nodiscard]] SegmentsByEnds segmentsOf(BrepFaceId f) const;
    void makeFace(BrepFaceId f, const InitialFaceMesh& initial, const IdVector<NodeId, MeshNode>& nodes,
                  const FaceRefinementOptions& options);
    [[nodiscard]] bool tellProgress(RunContext& context);
    void refineActive(const BudgetLimits& limits, SamplingRounds& result, RunContext& context);
    void noteWholeLengths();
    void prepareFaces(SamplingRounds& result, RunContext& context);
    [[nodiscard]] std::vector<SegmentId> takeProposals();
    bool queueGivenUp(RunContext& context);
    void split(const std::vector<SegmentId>& segments, SamplingRounds& result, RunContext& context);
    void splitBatch(std::span<const SegmentId> segments, SamplingRounds& result, RunContext& context);
    [[nodiscard]] std::vector<SampledFace*> activeFaces() const;

    const BrepModel& model_;
    CurveChains chains_;
    IdVector<NodeId, MeshNode> nodes_;
    Boundary boundary_;
    IdVector<SegmentId, std::uint8_t> isRefused_;
    /// Also of segments that are split already, which a face has until it follows.
    struct SegmentOrigin
    {
        BrepEdgeId edge;
        double wholeLength = 0.0;  ///< FaceBoundary::wholeLengthOf
    };
    IdVector<SegmentId, SegmentOrigin> originOf_;
    IdVector<BrepEdgeId, std::vector<BrepFaceId>> facesOf_;
    IdVector<BrepFaceId, std::unique_ptr<SampledFace>> faces_;
    std::vector<std::pair<BrepFaceId, Error>> failures_;
    std::unique_ptr<WallRims> rims_;
    double floor_ = 0.0;
    double minAngle_ = 0.0;
    bool isPrepared_ = false;
    double progress_ = 0.0;
};

}  // namespace mesher
