#include "tetrahedralization/segment_recovery.h"

namespace mesher {

namespace {

constexpr std::uint32_t kTrialsPerDepth[] = {100, 400, 1000, 4000};
/// Steps that only change what the line passes through, without lessening it, before an edge is given up.
constexpr int kSidewaysPerDepth[] = {0, 20, 60, 120};

}  // namespace

/// A line through the inside of an edge is a special position that a flip may turn into one through a face.
std::uint32_t SegmentRecovery::weigh(const std::vector<EdgeCrossing>& crossings)
{
    std::uint32_t weight = 0;
    for (const EdgeCrossing& crossing : crossings) {
        weight += crossing.kind == EdgeCrossing::Kind::Face ? 1u : 2u;
    }
    return weight;
}

RecoveryStatus SegmentRecovery::findObstacle(VertexId a, VertexId b)
{
    const Triangulation3d& mesh = constraints_.mesh();
    for (const EdgeCrossing& crossing : found_) {
        obstacle_ = {crossing.vertex, crossingPoint(mesh, a, b, crossing)};
        switch (crossing.kind) {
            case EdgeCrossing::Kind::Vertex: return RecoveryStatus::VertexInWay;
            case EdgeCrossing::Kind::Edge:
                if (constraints_.isConstraint(crossing.face.tet(), crossing.vertex[0], crossing.vertex[1]))
                    return RecoveryStatus::Intersection;
                break;
            case EdgeCrossing::Kind::Face:
                if (mesh.isFaceConstrained(crossing.face)) return RecoveryStatus::Intersection;
                break;
        }
    }
    return RecoveryStatus::Stuck;
}

RecoveryStatus SegmentRecovery::recover(VertexId a, VertexId b, int depth)
{
    flips_.accept();
    flips_.allowTrials(kTrialsPerDepth[depth]);
    int sideways = kSidewaysPerDepth[depth];
    RecoveryStatus status = RecoveryStatus::Stuck;
    while (true) {
        crossings_.find(a, b, found_);
        if (found_.empty()) {
            flips_.accept();
            constraints_.lockEdge(constraints_.mesh().findEdge(a, b), a, b);
            return RecoveryStatus::Recovered;
        }
        status = findObstacle(a, b);
        if (status != RecoveryStatus::Stuck) break;
        if (depth > 0) loosenFacets(a, b);
        const std::uint32_t weight = weigh(found_);
        if (improve(a, b, depth, weight, 0)) continue;
        if (sideways-- <= 0 || !improve(a, b, depth, weight + 1, random_.below(1u << 16))) break;
    }
    if (flips_.mark() > 0) {
        flips_.takeBackTo(0);
        crossings_.find(a, b, found_);
        if (status != RecoveryStatus::Stuck) status = findObstacle(a, b);
    }
    return status;
}

void SegmentRecovery::loosenFacets(VertexId a, VertexId b)
{
    constraints_.loosenFacetsAt(a);
    constraints_.loosenFacetsAt(b);
    for (const EdgeCrossing& crossing : found_) {
        for (const VertexId vertex : crossing.vertex) {
            if (vertex.isValid()) constraints_.loosenFacetsAt(vertex);
        }
    }
}

/// Tries the crossings from both ends to the middle: those next to an end have the best chance to be undone for good.
bool SegmentRecovery::improve(VertexId a, VertexId b, int depth, std::uint32_t limit, std::uint32_t first)
{
    const std::vector<EdgeCrossing> crossings = found_;
    for (std::size_t n = 0; n < crossings.size(); ++n) {
        const std::size_t i = (n + first) % crossings.size();
        const std::size_t index = i % 2 == 0 ? i / 2 : crossings.size() - 1 - i / 2;
        if (tryAt(crossings[index], a, b, i % 2 == 0 ? a : b, depth, limit)) return true;
    }
    return false;
}

bool SegmentRecovery::lessens(VertexId a, VertexId b, std::size_t mark, std::uint32_t limit)
{
    crossings_.find(a, b, trial_);
    if (weigh(trial_) < limit) return true;
    flips_.takeBackTo(mark);
    return false;
}

bool SegmentRecovery::tryAt(const EdgeCrossing& crossing, VertexId a, VertexId b, VertexId apex, int depth,
                            std::uint32_t limit)
{
    const Vec3 end = constraints_.mesh().position(apex);
    // A fan about the end of the line has no face for the line to pass, so those tetrahedra are preferred.
    const TetMeasure measure = [end](const Vec3& p, const Vec3& q, const Vec3& r, const Vec3& s) {
        const bool isFan = p == end || q == end || r == end || s == end;
        return flatness(p, q, r, s) + (isFan ? 2.0 : 0.0);
    };
    const std::size_t mark = flips_.mark();
    if (crossing.kind == EdgeCrossing::Kind::Edge) {
        if (flips_.removeEdge(crossing.vertex[0], crossing.vertex[1], crossing.face.tet(), depth, measure) &&
            lessens(a, b, mark, limit))
            return true;
        // The last resort before a vertex on the edge itself.
        return depth == maxDepth_ && swap_.swap({crossing.vertex[0], crossing.vertex[1]}, a, b) &&
               lessens(a, b, mark, limit);
    }
    if (flips_.flipFace(crossing.face) && lessens(a, b, mark, limit)) return true;
    for (unsigned k = 0; k < 3; ++k) {
        if (flips_.removeEdge(crossing.vertex[k], crossing.vertex[(k + 1) % 3], crossing.face.tet(), depth,
                              measure) &&
            lessens(a, b, mark, limit)) {
            return true;
        }
    }
    for (unsigned k = 0; k < 3 && depth == maxDepth_; ++k) {
        if (swap_.swap({crossing.vertex[k], crossing.vertex[(k + 1) % 3]}, a, b) &&
            lessens(a, b, mark, limit))
            return true;
    }
    return false;
}

}  // namespace mesher
