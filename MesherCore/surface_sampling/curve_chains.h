#pragma once

#include "base/id_vector.h"
#include "base/result.h"
#include "base/run_context.h"
#include "brep/brep_model.h"
#include "brep/tangent_variation.h"
#include "mesh/surface_mesh.h"
#include "sizing/sizing_field.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace mesher {

/// Curves that leave a vertex under contiguous small angles.
using AngleComplexId = Id<struct AngleComplexTag>;

struct CurveChainOptions
{
    /// Largest total variation of the tangent over a segment, degrees, in [1, 90].
    double maxVariation = 45.0;
    /// Segments on a full turn of the tangent; 0 for no wish.
    double segmentsPerTurn = 0.0;
    /// Largest distance between a segment and its curve, model units; 0 for no wish.
    double maxSag = 0.0;
    /// Wanted lengths; null for no wish.
    const SizingField* sizes = nullptr;
    /// Segments are not made shorter than this many times the gap between their edge, its faces and the vertex they end in:
    /// the tolerance there, or what was measured if that is less. Below it positions mean nothing.
    double floorInTolerances = 10.0;
    /// Beyond that many segments sampling ends with an Error that names the edge.
    std::size_t maxSegments = 50'000'000;
};

/// Where a segment is split.
struct SegmentPlace
{
    double parameter = 0.0;
    Vec3 position;
    /// Valid if the place lies on a shell around the apex of a small angle.
    AngleComplexId complex;
    double radius = 0.0;
};

struct SegmentSplit
{
    NodeId node;
    std::array<SegmentId, 2> halves;  ///< in the order of the parameter
};

/// A small angle complex: the edges that form contiguous small angles at a vertex.
struct SmallAngleAtVertex
{
    BrepVertexId apex;
    std::vector<BrepEdgeId> edges;
    double smallestAngle = 0.0;  ///< degrees
    int firstShell = 0;          ///< the shell that protects it has radius 2^firstShell; model units
    bool isAroundTip = false;    ///< a face has its tip there, and all edges are cut at the shell
};

/// The curves of a model, each cut once into segments that all faces beside it share.
/// Guarantees   segments of an edge follow each other without gaps from its first vertex to its last, parameters ascend; each
///              inner node is the curve's exact point at its parameter, the end nodes are those of the edge's vertices;
///              node i < vertices of the model is that of BrepVertexId(i); ids of segments and nodes never change, a segment
///              that was split is no longer alive; no two alive segments join the same two nodes when they are first made
/// Units        model units, angles in degrees
/// Reference    [gosselin] §3.3.1, §2.4.1; §2.5 for the shells, with 90 degrees as the limit of small angles in space
class CurveChains
{
public:
    /// Any angle below it between two edges at a vertex is small.
    static constexpr double kSmallAngleLimit = 90.0;

    /// \name Segments
    ///@{
    [[nodiscard]] const IdVector<SegmentId, SurfaceSegment>& segments() const { return segments_; }
    [[nodiscard]] bool isAlive(SegmentId s) const { return segments_[s].isAlive(); }
    [[nodiscard]] std::size_t aliveCount() const { return aliveCount_; }
    /// The alive segment at the start of an edge; invalid for a degenerate edge, which has none.
    [[nodiscard]] SegmentId firstOf(BrepEdgeId edge) const { return firstOf_[edge]; }
    /// Along the edge's parameter; invalid at the ends of the edge. Requires an alive segment.
    [[nodiscard]] SegmentId next(SegmentId s) const { return records_[s].next; }
    [[nodiscard]] SegmentId previous(SegmentId s) const { return records_[s].previous; }
    /// The alive segments of an edge in the order of the parameter.
    [[nodiscard]] std::vector<SegmentId> chainOf(BrepEdgeId edge) const;
    /// Requires an edge that is not degenerate.
    [[nodiscard]] const TangentVariation& variation(BrepEdgeId edge) const { return *variations_[edge]; }
    ///@}

    /// \name Splits
    ///@{
    /// On the next smaller shell beside a small angle, else at equal total variation (equal arc length where all is straight,
    /// and not too near to an end where nearly all is).
    /// Nothing if a half would be shorter than the floor.
    [[nodiscard]] std::optional<SegmentPlace> splitPlace(SegmentId s) const;
    /// Requires an alive segment and a place that `splitPlace` gave for it, or one strictly inside of it.
    SegmentSplit split(SegmentId s, const SegmentPlace& place, IdVector<NodeId, MeshNode>& nodes);
    /// Both in one; nothing if there is no place.
    std::optional<SegmentSplit> split(SegmentId s, IdVector<NodeId, MeshNode>& nodes);
    /// The least length of a part of this segment.
    [[nodiscard]] double floorOf(SegmentId s) const;
    ///@}

    /// \name Small angles
    ///@{
    [[nodiscard]] const IdVector<AngleComplexId, SmallAngleAtVertex>& smallAngles() const
    {
        return smallAngles_;
    }
    /// The complex whose apex the segment leaves, or beside which it lies within the first shell; else invalid.
    [[nodiscard]] AngleComplexId complexOf(SegmentId s) const { return records_[s].complex; }
    /// Two nodes on one shell of one complex: the short side of a facet that no refinement can better.
    [[nodiscard]] bool spansSmallAngle(NodeId a, NodeId b) const;
    /// The radius of the shell that cuts the edges around the tip of a face; 0 where there is none.
    [[nodiscard]] double shellAround(BrepVertexId tip) const;
    /// Is the node where that shell cuts an edge?
    [[nodiscard]] bool isOnShellAround(BrepVertexId tip, NodeId node) const;
    /// Segments that could not be cut at their shell: their distance from the apex is not monotone, or they are too short.
    [[nodiscard]] std::size_t unprotectedCount() const { return unprotected_; }
    ///@}

private:
    friend class CurveChainSampler;
    friend class SmallAngleProtection;

    struct Record
    {
        SegmentId next;
        SegmentId previous;
        /// Valid within the first shell around the apex of a small angle: both ends are at known distances from it.
        AngleComplexId complex;
        CurveEnd nearEnd = CurveEnd::First;
        double nearRadius = 0.0;
        double farRadius = 0.0;
    };
    struct Shell
    {
        AngleComplexId complex;
        double radius = 0.0;
    };

    [[nodiscard]] std::optional<SegmentPlace> placeAt(SegmentId s, double t) const;
    [[nodiscard]] std::optional<SegmentPlace> equalVariationPlace(SegmentId s) const;
    [[nodiscard]] std::optional<SegmentPlace> shellPlace(SegmentId s, CurveEnd nearEnd,
                                                         AngleComplexId complex, double radius) const;

    const BrepModel* model_ = nullptr;
    IdVector<SegmentId, SurfaceSegment> segments_;
    IdVector<SegmentId, Record> records_;
    IdVector<BrepEdgeId, SegmentId> firstOf_;
    IdVector<BrepEdgeId, std::optional<TangentVariation>> variations_;
    IdVector<BrepEdgeId, double> floors_;
    IdVector<BrepVertexId, double> vertexFloors_;
    IdVector<AngleComplexId, SmallAngleAtVertex> smallAngles_;
    IdVector<NodeId, Shell> shells_;  ///< by node; shorter than the nodes, later ones are on no shell
    std::size_t aliveCount_ = 0;
    std::size_t unprotected_ = 0;
};

/// Cuts every edge of the model, and appends a node for each vertex of the model and each inner point of a chain.
/// Requires     empty `nodes`; a model that outlives the result
/// Refuses      two edges that coincide between the same vertices
/// Terminates   early when the run is to end; the chains are incomplete then
/// Cost         linear in the number of segments
[[nodiscard]] Result<CurveChains> sampleCurveChains(const BrepModel& model, const CurveChainOptions& options,
                                                    IdVector<NodeId, MeshNode>& nodes, RunContext& context);

}  // namespace mesher
