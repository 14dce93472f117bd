#include "tetrahedralization/constraint_recovery.h"

#include <algorithm>

namespace mesher {

namespace {

constexpr std::uint64_t kInsertedBesides = 1000;
constexpr std::uint64_t kTrialsPerReport = 16;

}  // namespace

ConstraintRecovery::ConstraintRecovery(SurfaceConstraints& constraints,
                                       const TetrahedralizationOptions& options, Budget& budget,
                                       Tetrahedralization& result, RunContext& context)
    : constraints_(constraints),
      options_(options),
      budget_(budget),
      result_(result),
      context_(context),
      flips_(constraints.mesh()),
      segments_(constraints, flips_, options.flipDepth, result.counts.attempts),
      facets_(constraints, flips_),
      splits_(constraints),
      lifts_(constraints),
      remover_(constraints.tets()),
      expected_(constraints.missingEdges.size() + constraints.missingFacets.size() + 1),
      maxInserted_(kInsertedBesides +
                   static_cast<std::uint64_t>(options.maxInsertedShare * result.counts.nodes)),
      // Exact points may not be where they would help, so half of the allowance is kept for those that are.
      maxExact_(maxInserted_ / 2)
{
}

bool ConstraintRecovery::mayInsert() const
{
    const TetrahedralizationCounts& counts = result_.counts;
    const TemporarySplits* temporary = constraints_.temporarySplits();
    return counts.exactSplits + (temporary == nullptr ? 0 : temporary->made().size()) < maxInserted_;
}

bool ConstraintRecovery::mayGoOn()
{
    if (tried_++ % kTrialsPerReport == 0) {
        const auto tried = static_cast<double>(tried_);
        context_.reportProgress("recovery", tried / (tried + static_cast<double>(expected_)));
    }
    return budget_.allows({constraints_.mesh().vertexCount(), constraints_.mesh().tetCount()});
}

Result<void> ConstraintRecovery::run()
{
    while (!constraints_.missingEdges.empty() || !constraints_.missingFacets.empty()) {
        if (Result<void> edges = recoverEdges(); !edges) return edges;
        if (!result_.failures.empty() || budget_.exhausted()) break;
        if (Result<void> facets = recoverFacets(); !facets) return facets;
        if (!result_.failures.empty() || budget_.exhausted()) break;
    }
    failAll();
    if (result_.failures.empty()) {
        if (Result<void> left = leaveTemporarySplits(); !left) result_.failures.push_back(left.error());
    }
    result_.tets.nodeOf.resize(constraints_.mesh().vertexLimit());
    result_.counts.recoveryFlips = flips_.flips();
    result_.stopReason =
        budget_.stopReason(result_.failures.empty() ? StopReason::Done : StopReason::CannotImprove);
    return {};
}

/// Takes back what was split off the exact geometry, the last one first.
Result<void> ConstraintRecovery::leaveTemporarySplits()
{
    const TemporarySplits* temporary = constraints_.temporarySplits();
    if (temporary == nullptr) return {};
    TetrahedralizationCounts& counts = result_.counts;
    const auto& made = temporary->made();
    counts.temporarySplits = static_cast<std::uint32_t>(made.size());
    std::size_t left = made.size();
    // One that is taken back may make way for another.
    for (std::size_t before = left + 1; left > 0 && left < before;) {
        before = left;
        for (std::size_t i = made.size(); i > 0; --i) {
            if (!mayGoOn()) return {};
            if (made[i - 1].isTakenBack || !temporary->mayTakeBack(i - 1) || !lift(made[i - 1])) continue;
            constraints_.takeBack(i - 1);
            --left;
        }
    }
    for (const TemporarySplits::Made& split : made) {
        if (split.isTakenBack) continue;
        const bool isEdge = split.split.segment.isValid() || split.split.removed.size() > 1;
        ++(isEdge ? counts.edgeSteiner : counts.facetSteiner);
    }
    return constraints_.endTemporarySplits();
}

bool ConstraintRecovery::lift(const TemporarySplits::Made& made)
{
    if (!lifts_.lift(made)) {
        // Free vertices at a distance of hardly more than rounding may be what blocks.
        bool isRemoved = false;
        for (const VertexId vertex : lifts_.freeNeighbours()) isRemoved |= remover_.remove(vertex);
        if (!isRemoved || !lifts_.lift(made)) return false;
    }
    result_.counts.starVertices += lifts_.addedVertices();
    return true;
}

// --- edges

bool ConstraintRecovery::isWanted(const EdgeKey& edge)
{
    return constraints_.segmentAt(edge.first, edge.second).isValid() ||
           !constraints_.facetsAt(edge.first, edge.second).empty();
}

Result<void> ConstraintRecovery::recoverEdges()
{
    std::vector<EdgeKey>& missing = constraints_.missingEdges;
    for (int depth = 0; depth <= options_.flipDepth && !missing.empty(); ++depth) {
        std::vector<EdgeKey> edges;
        edges.swap(missing);
        for (const EdgeKey& edge : edges) {
            if (!mayGoOn()) {
                missing.push_back(edge);
                continue;
            }
            const Result<bool> recovered = recoverEdge(edge, depth);
            if (!recovered) return recovered.error();
            if (!*recovered) missing.push_back(edge);
        }
    }
    std::vector<EdgeKey> edges;
    edges.swap(missing);
    for (const EdgeKey& edge : edges) {
        if (!mayGoOn()) {
            missing.push_back(edge);
            continue;
        }
        // Splits made since may have helped.
        const Result<bool> recovered = recoverEdge(edge, options_.flipDepth);
        if (!recovered) return recovered.error();
        if (*recovered || splitEdge(edge)) continue;
        const Vec3& a = constraints_.mesh().position(edge.first);
        const Vec3& b = constraints_.mesh().position(edge.second);
        fail(constraints_.nameOfEdge(edge.first, edge.second), 0.5 * (a + b),
             "an edge could not be recovered");
    }
    return {};
}

Result<bool> ConstraintRecovery::recoverEdge(const EdgeKey& edge, int depth)
{
    if (!isWanted(edge)) return true;
    switch (segments_.recover(edge.first, edge.second, depth)) {
        case RecoveryStatus::Recovered: ++result_.counts.edgesByFlips; return true;
        case RecoveryStatus::Stuck: return false;
        case RecoveryStatus::VertexInWay: {
            const VertexId vertex = segments_.obstacle().vertex[0];
            if (!clearVertex(vertex))
                return intersection(constraints_.nameOfEdge(edge.first, edge.second), segments_.obstacle());
            if (!constraints_.mesh().isVertexAlive(vertex)) return recoverEdge(edge, depth);
            if (constraints_.temporarySplits() == nullptr) return false;
            splits_.splitEdgeAt(edge.first, edge.second, vertex);
            return true;
        }
        case RecoveryStatus::Intersection: break;
    }
    if (splitPierced(segments_.obstacle())) {
        constraints_.missingEdges.push_back(edge);
        return true;
    }
    return intersection(constraints_.nameOfEdge(edge.first, edge.second), segments_.obstacle());
}

/// True if the vertex is none of the input's: then it was removed, or, if it is alive still, may become a node.
bool ConstraintRecovery::clearVertex(VertexId vertex)
{
    if (constraints_.nodeAt(vertex).isValid()) return false;
    result_.tets.delaunay->remove(vertex);
    return true;
}

bool ConstraintRecovery::splitEdge(const EdgeKey& edge)
{
    TetrahedralizationCounts& counts = result_.counts;
    if (!mayInsert()) return false;
    const bool isExact = constraints_.temporarySplits() == nullptr && counts.exactSplits < maxExact_;
    if (isExact && splits_.splitEdgeExactly(edge.first, edge.second)) {
        ++counts.exactSplits;
        // A new point on the face need not part the edge.
        if (isWanted(edge)) constraints_.missingEdges.push_back(edge);
        return true;
    }
    if (constraints_.startTemporarySplits()) {
        constraints_.missingEdges.push_back(edge);
        return true;
    }
    return splits_.splitEdgeAtCrossing(edge.first, edge.second, segments_.crossings());
}

// --- facets

bool ConstraintRecovery::hasItsEdges(FacetId facet) const
{
    const auto corner = constraints_.cornersOf(facet);
    const Triangulation3d& mesh = std::as_const(constraints_).mesh();
    for (unsigned k = 0; k < 3; ++k) {
        if (!mesh.findEdge(corner[k], corner[(k + 1) % 3]).isValid()) return false;
    }
    return true;
}

Result<void> ConstraintRecovery::recoverFacets()
{
    std::vector<FacetId>& missing = constraints_.missingFacets;
    // Easy ones first: each that is there clears the way of its neighbours.
    for (int pass = 0; pass < 2 && !missing.empty(); ++pass) {
        std::vector<FacetId> facets;
        facets.swap(missing);
        for (const FacetId facet : facets) {
            if (!mayGoOn() || !constraints_.missingEdges.empty()) {
                missing.push_back(facet);
                continue;
            }
            const int depth = pass == 0 ? std::min(options_.flipDepth, 1) : options_.flipDepth;
            const Result<bool> recovered =
                recoverFacet(facet, depth, pass == 0 ? FacetEffort::Cavity : FacetEffort::Star);
            if (!recovered) return recovered.error();
            if (!*recovered) missing.push_back(facet);
        }
    }
    std::vector<FacetId> facets;
    facets.swap(missing);
    for (const FacetId facet : facets) {
        if (!mayGoOn() || !constraints_.missingEdges.empty()) {
            missing.push_back(facet);
            continue;
        }
        const Result<bool> recovered = recoverFacet(facet, 0, FacetEffort::Star);
        if (!recovered) return recovered.error();
        if (*recovered || splitFacet(facet)) continue;
        const auto corner = constraints_.cornersOf(facet);
        const Triangulation3d& mesh = constraints_.mesh();
        fail(constraints_.nameOfFacet(facet),
             (1.0 / 3.0) * (mesh.position(corner[0]) + mesh.position(corner[1]) + mesh.position(corner[2])),
             "a facet could not be recovered");
    }
    return {};
}

Result<bool> ConstraintRecovery::recoverFacet(FacetId facet, int depth, FacetEffort effort)
{
    if (!constraints_.surface().facets[facet].isAlive()) return true;
    MESHER_INVARIANT(hasItsEdges(facet));
    TetrahedralizationCounts& counts = result_.counts;
    const RecoveryStatus status = facets_.recover(facet, depth, effort);
    switch (status) {
        case RecoveryStatus::Recovered:
            counts.facetsByFlips += facets_.method() == FacetMethod::Flips ? 1 : 0;
            counts.facetsByCavity += facets_.method() == FacetMethod::Cavity ? 1 : 0;
            counts.facetsByStar += facets_.method() == FacetMethod::Star ? 1 : 0;
            counts.starVertices += facets_.addedVertices();
            return true;
        case RecoveryStatus::Stuck: return false;
        case RecoveryStatus::VertexInWay: {
            const VertexId vertex = facets_.obstacle().vertex[0];
            if (!clearVertex(vertex))
                return intersection(constraints_.nameOfFacet(facet), facets_.obstacle());
            if (!constraints_.mesh().isVertexAlive(vertex)) return recoverFacet(facet, depth, effort);
            if (constraints_.temporarySplits() == nullptr) return false;
            splits_.splitFacetAt(facet, vertex);
            return true;
        }
        case RecoveryStatus::Intersection: break;
    }
    if (splitPierced(facets_.obstacle())) {
        constraints_.missingFacets.push_back(facet);
        return true;
    }
    return intersection(constraints_.nameOfFacet(facet), facets_.obstacle());
}

bool ConstraintRecovery::splitFacet(FacetId facet)
{
    TetrahedralizationCounts& counts = result_.counts;
    if (!mayInsert()) return false;
    const bool isExact = constraints_.temporarySplits() == nullptr && counts.exactSplits < maxExact_;
    if (isExact && splits_.splitFacetExactly(facet)) {
        ++counts.exactSplits;
        if (constraints_.surface().facets[facet].isAlive()) constraints_.missingFacets.push_back(facet);
        return true;
    }
    if (constraints_.startTemporarySplits()) {
        constraints_.missingFacets.push_back(facet);
        return true;
    }
    return splits_.splitFacetAtCrossing(facet, facets_.crossing());
}

/// Facets of two curved faces may cross where the faces do not: then the one in the way is refined on its face.
bool ConstraintRecovery::splitPierced(const RecoveryObstacle& obstacle)
{
    TetrahedralizationCounts& counts = result_.counts;
    if (constraints_.temporarySplits() != nullptr || counts.exactSplits >= maxExact_) return false;
    const auto& v = obstacle.vertex;
    bool isSplit = false;
    if (v[2].isValid()) {
        auto key = v;
        std::sort(key.begin(), key.end());
        const FacetId* facet = result_.tets.facetOf.find(key);
        isSplit = facet != nullptr && splits_.splitFacetExactly(*facet);
    } else {
        isSplit = splits_.splitEdgeExactly(v[0], v[1]);
    }
    counts.exactSplits += isSplit ? 1 : 0;
    return isSplit;
}

// --- what went wrong

Error ConstraintRecovery::intersection(const std::string& name, const RecoveryObstacle& obstacle)
{
    const auto& v = obstacle.vertex;
    std::string other;
    if (!v[1].isValid()) {
        other = constraints_.nameOfVertex(v[0]);
    } else if (!v[2].isValid()) {
        other = constraints_.nameOfEdge(v[0], v[1]);
    } else {
        auto key = v;
        std::sort(key.begin(), key.end());
        const FacetId* facet = result_.tets.facetOf.find(key);
        if (facet != nullptr) other = constraints_.nameOfFacet(*facet);
    }
    return {ErrorCode::IntersectingConstraints, "the surface mesh intersects itself", name + " and " + other,
            constraints_.modelPosition(obstacle.point),
            "repair the model there, or make the surface mesh finer where it is curved"};
}

void ConstraintRecovery::fail(const std::string& entity, const Vec3& kernelPoint, const std::string& what)
{
    result_.failures.push_back({ErrorCode::DegenerateInput, what, entity,
                                constraints_.modelPosition(kernelPoint),
                                "make the surface mesh finer there"});
}

void ConstraintRecovery::failAll()
{
    const Triangulation3d& mesh = constraints_.mesh();
    for (const EdgeKey& edge : constraints_.missingEdges) {
        if (!isWanted(edge)) continue;
        fail(constraints_.nameOfEdge(edge.first, edge.second),
             0.5 * (mesh.position(edge.first) + mesh.position(edge.second)), "an edge was not recovered");
    }
    for (const FacetId facet : constraints_.missingFacets) {
        if (!constraints_.surface().facets[facet].isAlive()) continue;
        const auto corner = constraints_.cornersOf(facet);
        fail(constraints_.nameOfFacet(facet), mesh.position(corner[0]), "a facet was not recovered");
    }
}

}  // namespace mesher
