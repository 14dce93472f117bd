#include "surface_sampling/sampled_faces.h"

#include "base/parallel.h"

#include <algorithm>
#include <tuple>

namespace mesher {
namespace {

/// How often facets that were given up are tried again.
constexpr int kMostSweeps = 3;
/// Insertions in a face between two looks at the progress hook: a tenth of a second.
constexpr std::uint64_t kOperationsPerReport = 30'000;

}  // namespace

bool SampledFaces::Boundary::maySplit(SegmentId segment) const
{
    if (segment.value < faces_.isRefused_.size() && faces_.isRefused_[segment] != 0) return false;
    const SurfaceSegment& whole = faces_.chains_.segments()[segment];
    const Vec3 along = faces_.nodes_[whole.node[1]].position - faces_.nodes_[whole.node[0]].position;
    return squaredLength(along) >= 4.0 * faces_.floor_ * faces_.floor_;
}

bool SampledFaces::Boundary::isAtApex(SegmentId segment) const
{
    const AngleComplexId complex = faces_.chains_.complexOf(segment);
    return complex.isValid() && faces_.chains_.smallAngles()[complex].smallestAngle < faces_.minAngle_;
}

bool SampledFaces::Boundary::spansSmallAngle(NodeId a, NodeId b) const
{
    return faces_.chains_.spansSmallAngle(a, b);
}

BrepEdgeId SampledFaces::Boundary::edgeOf(SegmentId segment) const { return faces_.originOf_[segment].edge; }

double SampledFaces::Boundary::wholeLengthOf(SegmentId segment) const
{
    return faces_.originOf_[segment].wholeLength;
}

SampledFaces::SampledFaces(const BrepModel& model, CurveChains chains, IdVector<NodeId, MeshNode> nodes,
                           const InitialSurfaceMesh& initial, const FaceRefinementOptions& options)
    : model_(model),
      chains_(std::move(chains)),
      boundary_(*this),
      floor_(options.splits.floor),
      minAngle_(options.criteria.minAngle)
{
    findFacesOfEdges();
    for (const SurfaceSegment& segment : chains_.segments()) originOf_.push_back({segment.edge, 0.0});
    failures_ = initial.failures;
    faces_ = decltype(faces_)();
    for (std::uint32_t f = 0; f < model.faces.size(); ++f) {
        faces_.push_back(nullptr);
        makeFace(BrepFaceId(f), initial.faces[BrepFaceId(f)], nodes, options);
    }
    std::sort(failures_.begin(), failures_.end(),
              [](const auto& a, const auto& b) { return a.first < b.first; });
    for (const MeshNode& node : nodes) {
        if (node.entity.dimension < 2) nodes_.push_back(node);
    }
}

void SampledFaces::findFacesOfEdges()
{
    facesOf_.resize(model_.edges.size());
    for (std::uint32_t f = 0; f < model_.faces.size(); ++f) {
        const BrepFace& face = model_.faces[BrepFaceId(f)];
        const auto add = [&](BrepEdgeId edge) {
            auto& faces = facesOf_[edge];
            if (faces.empty() || faces.back() != BrepFaceId(f)) faces.push_back(BrepFaceId(f));
        };
        for (const BrepLoop& loop : face.loops) {
            for (const BrepCoedge& coedge : loop.coedges) add(coedge.edge);
        }
        for (const BrepEdgeId edge : face.embeddedEdges) add(edge);
    }
}

SegmentsByEnds SampledFaces::segmentsOf(BrepFaceId f) const
{
    SegmentsByEnds segments;
    const auto add = [&](BrepEdgeId edge) {
        for (const SegmentId s : chains_.chainOf(edge)) {
            const auto& ends = chains_.segments()[s].node;
            segments.insert(std::minmax(ends[0], ends[1]), s);
        }
    };
    for (const BrepLoop& loop : model_.faces[f].loops) {
        for (const BrepCoedge& coedge : loop.coedges) add(coedge.edge);
    }
    for (const BrepEdgeId edge : model_.faces[f].embeddedEdges) add(edge);
    return segments;
}

namespace {

/// Facets beside an edge that is off its face lean by the gap over their width: the finer they are the more. Normals ask for
/// nothing below this many gaps.
constexpr double kLeastSizeInGaps = 4.0;

double largestGapOf(const BrepFace& face)
{
    double largest = 0.0;
    for (const BrepLoop& loop : face.loops) {
        for (const BrepCoedge& coedge : loop.coedges) largest = std::max(largest, coedge.gap);
    }
    return largest;
}

/// The rings of a face, of which the mesh has the fans. Beyond their reach facets that are to follow the curvature are no shorter
/// than the sides of the ring.
std::vector<TipResolution> tipsOf(const FaceMesh& mesh, double elementsPerTurn)
{
    constexpr double kSidesOfRing = 6.0, kLeastReach = 2.0, kSlack = 1.1, kClearance = 0.4;
    std::vector<TipResolution> tips;
    for (std::uint32_t i = 0; i < mesh.triangleSlots(); ++i) {
        if (!mesh.triangle(TriangleId(i)).isAlive || !mesh.isOfFan(TriangleId(i))) continue;
        const auto& v = mesh.triangle(TriangleId(i)).v;
        unsigned k = 0;
        while (!mesh.vertex(v[k]).isPole()) ++k;
        const Vec3 &tip = mesh.position(v[k]), &a = mesh.position(v[nextCorner(k)]),
                   &b = mesh.position(v[previousCorner(k)]);
        auto known =
            std::find_if(tips.begin(), tips.end(), [&](const TipResolution& t) { return t.tip == tip; });
        if (known == tips.end()) known = tips.insert(tips.end(), {tip, 0.0, 0.0, 0.0});
        known->reach = std::max(kLeastReach, elementsPerTurn / kSidesOfRing) * length(a - tip);
        known->clearance = std::max(known->clearance, length(a - tip) + kClearance * length(b - a));
        known->leastSize = std::max(known->leastSize, kSlack * length(b - a));
    }
    return tips;
}

}  // namespace

void SampledFaces::makeFace(BrepFaceId f, const InitialFaceMesh& initial,
                            const IdVector<NodeId, MeshNode>& nodes, const FaceRefinementOptions& options)
{
    if (initial.facets.empty()) return;
    const BrepFace& face = model_.faces[f];
    Result<FaceMesh> mesh =
        FaceMesh::make(f, FaceGeometry(face), initial.facets, nodes, segmentsOf(f), initial.ringNodes);
    if (!mesh) {
        failures_.emplace_back(f, mesh.error());
        return;
    }
    FaceRefinementOptions ownOptions = options;
    ownOptions.splits.floor = std::max(options.splits.floor, 10.0 * face.tolerance);
    double& least = ownOptions.criteria.leastCurvatureSize;
    least = std::max(least, kLeastSizeInGaps * largestGapOf(face));
    ownOptions.criteria.tips = tipsOf(*mesh, options.criteria.elementsPerTurn);
    faces_[f] = std::make_unique<SampledFace>(face, std::move(*mesh), boundary_, ownOptions);
}

std::vector<SampledFace*> SampledFaces::activeFaces() const
{
    std::vector<SampledFace*> active;
    for (const auto& face : faces_) {
        if (face && face->isActive) active.push_back(face.get());
    }
    return active;
}

std::size_t SampledFaces::vertexCount() const
{
    std::size_t count = nodes_.size();
    for (const auto& face : faces_) {
        if (face) count += face->refiner.freeVertexCount();
    }
    return count;
}

FaceRefinementCounts SampledFaces::counts() const
{
    FaceRefinementCounts counts;
    for (const auto& face : faces_) {
        if (face) counts += face->refiner.counts();
    }
    return counts;
}

std::vector<BrepFaceId> SampledFaces::facesWithoutAngle() const
{
    std::vector<BrepFaceId> found;
    for (std::uint32_t f = 0; f < faces_.size(); ++f) {
        const auto& face = faces_[BrepFaceId(f)];
        if (face && face->refiner.hasGivenUpAngle()) found.push_back(BrepFaceId(f));
    }
    return found;
}

void SampledFaces::leaveFlatOnRims(const RegionSides& sides)
{
    rims_ = std::make_unique<WallRims>(*this, sides);
    for (const auto& face : faces_) {
        if (face) face->refiner.leaveFlatOn(*rims_);
    }
}

bool SampledFaces::keepRimsOf(std::vector<WallSides> walls, std::vector<WallSides> goodWalls,
                              std::vector<BrepFaceId> strips)
{
    rims_->keep(std::move(walls), std::move(goodWalls), std::move(strips));
    bool isAny = false;
    for (const auto& face : faces_) {
        if (!face || !face->refiner.hasFormerRim()) continue;
        face->refiner.queueAll();
        face->refiner.proposeSegments();
        face->isActive = true;
        isAny = true;
    }
    return isAny;
}

void SampledFaces::force(BrepFaceId face, TriangleId facet)
{
    faces_[face]->refiner.force(facet);
    faces_[face]->isActive = true;
}

std::vector<SegmentId> SampledFaces::takeProposals()
{
    std::vector<SegmentId> all;
    for (const auto& face : faces_) {
        if (!face) continue;
        const std::vector<SegmentId> proposals = face->refiner.takeProposals();
        // What waits for a segment is looked at again, whatever becomes of that.
        face->isActive = !proposals.empty();
        all.insert(all.end(), proposals.begin(), proposals.end());
    }
    const auto& segments = chains_.segments();
    // A face may propose a segment while it follows a split, that comes to its turn in the same round.
    std::erase_if(all, [&](SegmentId s) { return !chains_.isAlive(s); });
    std::sort(all.begin(), all.end(), [&](SegmentId a, SegmentId b) {
        return std::tuple(segments[a].edge, segments[a].parameter[0], a) <
               std::tuple(segments[b].edge, segments[b].parameter[0], b);
    });
    all.erase(std::unique(all.begin(), all.end()), all.end());
    return all;
}

/// In batches that do not take long, between which the run may end.
void SampledFaces::split(const std::vector<SegmentId>& segments, SamplingRounds& result, RunContext& context)
{
    constexpr std::size_t kMostInBatch = 4096;
    const std::span<const SegmentId> all(segments);
    for (std::size_t i = 0; i < all.size() && context.mayGoOn(); i += kMostInBatch)
        splitBatch(all.subspan(i, std::min(kMostInBatch, all.size() - i)), result, context);
}

void SampledFaces::splitBatch(std::span<const SegmentId> segments, SamplingRounds& result,
                              RunContext& context)
{
    IdVector<BrepFaceId, std::vector<SegmentVertex>> work(model_.faces.size());
    for (const SegmentId s : segments) {
        const SurfaceSegment whole = chains_.segments()[s];
        const std::optional<SegmentSplit> made = chains_.split(s, nodes_);
        isRefused_.resize(chains_.segments().size());
        const SegmentOrigin origin = originOf_[s];
        originOf_.resize(chains_.segments().size(), origin);
        if (!made) {
            isRefused_[s] = 1;
            ++result.refusedSplits;
            continue;
        }
        ++result.segmentSplits;
        const SegmentVertex vertex{s, whole.node, made->node, nodes_[made->node].position, made->halves};
        for (const BrepFaceId f : facesOf_[whole.edge]) work[f].push_back(vertex);
    }
    std::vector<BrepFaceId> faces;
    for (std::uint32_t f = 0; f < work.size(); ++f) {
        if (!work[BrepFaceId(f)].empty() && faces_[BrepFaceId(f)]) faces.push_back(BrepFaceId(f));
    }
    forEachInParallel(faces.size(), context, [&](std::size_t i) {
        SampledFace& face = *faces_[faces[i]];
        for (const SegmentVertex& vertex : work[faces[i]]) face.refiner.insertOnSegment(vertex);
        face.isActive = true;
    });
}

/// When edges have the sizes wanted, before anything is split for the sake of angles.
void SampledFaces::noteWholeLengths()
{
    for (std::uint32_t i = 0; i < originOf_.size(); ++i) {
        const SurfaceSegment& segment = chains_.segments()[SegmentId(i)];
        double& whole = originOf_[SegmentId(i)].wholeLength;
        if (segment.isAlive() && whole == 0.0)
            whole = length(nodes_[segment.node[1]].position - nodes_[segment.node[0]].position);
    }
}

void SampledFaces::prepareFaces(SamplingRounds& result, RunContext& context)
{
    if (isPrepared_) return;
    isPrepared_ = true;
    const std::vector<SampledFace*> faces = activeFaces();
    std::vector<std::size_t> flips(faces.size());
    forEachInParallel(faces.size(), context, [&](std::size_t i) {
        Budget budget(flipLimits(faces[i]->mesh), context);
        flips[i] = makeSurfaceDelaunay(faces[i]->mesh, faces[i]->geometry, budget).flips;
        faces[i]->refiner.queueAll();
        faces[i]->refiner.proposeSegments();
    });
    for (const std::size_t count : flips) result.flips += count;
}

bool SampledFaces::queueGivenUp(RunContext& context)
{
    bool isAny = false;
    for (const auto& face : faces_) {
        if (!face || !face->refiner.queueGivenUp(context)) continue;
        face->isActive = true;
        isAny = true;
    }
    return isAny;
}

/// False if the run is to end.
bool SampledFaces::tellProgress(RunContext& context)
{
    std::size_t open = 0;
    for (const auto& face : faces_) open += face ? face->refiner.openCount() : 0;
    const auto done = static_cast<double>(vertexCount());
    progress_ = std::max(progress_, done / (done + static_cast<double>(open) + 1.0));
    return context.reportProgress("surfaces", progress_);
}

/// All active faces as far as they can without the segments they propose, by turns that are short enough to be cancelled.
void SampledFaces::refineActive(const BudgetLimits& limits, SamplingRounds& result, RunContext& context)
{
    std::vector<SampledFace*> active = activeFaces();
    for (SampledFace* face : active) face->refiner.queueWaiting();
    BudgetLimits turn = limits;
    turn.maxOperations = std::min(limits.maxOperations, kOperationsPerReport);
    const bool isLastTurn = turn.maxOperations == limits.maxOperations;
    while (!active.empty()) {
        forEachInParallel(active.size(), context, [&](std::size_t i) {
            Budget budget(turn, context);
            active[i]->stopReason = active[i]->refiner.refine(budget);
        });
        std::erase_if(active, [&](const SampledFace* face) {
            const bool goesOn = face->stopReason == StopReason::OperationLimit && !isLastTurn;
            if (!goesOn && face->stopReason != StopReason::Done) result.stopReason = face->stopReason;
            return !goesOn;
        });
        if (vertexCount() >= limits.maxVertices) result.stopReason = StopReason::VertexLimit;
        if (!tellProgress(context)) result.stopReason = StopReason::Cancelled;
        if (result.stopReason != StopReason::Done) return;
    }
}

SamplingRounds SampledFaces::refine(const BudgetLimits& limits, int maxRounds, RunContext& context)
{
    SamplingRounds result;
    prepareFaces(result, context);
    // Edges first: inside, facets are then judged beside edges that stay.
    std::vector<SegmentId> proposals = takeProposals();
    while (!proposals.empty() && result.rounds < maxRounds && tellProgress(context) && context.mayGoOn() &&
           vertexCount() < limits.maxVertices) {
        ++result.rounds;
        split(proposals, result, context);
        proposals = takeProposals();
    }
    noteWholeLengths();
    for (const auto& face : faces_) {
        if (face) face->isActive = true;
    }
    for (int sweeps = 0;;) {
        refineActive(limits, result, context);
        proposals = takeProposals();
        if (result.stopReason != StopReason::Done) break;
        if (proposals.empty()) {
            if (sweeps++ >= kMostSweeps || !queueGivenUp(context)) break;
            continue;
        }
        if (result.rounds++ >= maxRounds) {
            result.stopReason = StopReason::OperationLimit;
            break;
        }
        split(proposals, result, context);
    }
    return result;
}

}  // namespace mesher
