#include "tetrahedralization/free_vertex_removal.h"

#include "predicates/orient3d.h"

#include <algorithm>

namespace mesher {

namespace {

/// Tetrahedra that the hole of a vertex may grow to.
constexpr std::size_t kMaxHole = 120;
/// A removal may make way for another.
constexpr int kPasses = 3;
constexpr std::size_t kTrialsPerReport = 64;

std::vector<VertexId> listFree(const ConstrainedTetrahedralization& tets, SurfaceScaffold scaffold)
{
    const Triangulation3d& mesh = tets.mesh();
    std::vector<VertexId> free;
    for (std::uint32_t i = 0; i < mesh.vertexLimit(); ++i) {
        const VertexId vertex(i);
        if (!mesh.isVertexAlive(vertex) || tets.nodeOf[vertex].isValid()) continue;
        const bool isKept = scaffold == SurfaceScaffold::Kept && mesh.classification(vertex).scaffold != 0;
        if (!isKept && mesh.region(mesh.incidentTet(vertex)) != kExteriorRegion) free.push_back(vertex);
    }
    return free;
}

}  // namespace

bool FreeVertexRemover::remove(VertexId vertex)
{
    mesh_.collectStar(vertex, hole_);
    if (std::any_of(hole_.begin(), hole_.end(), [&](TetId tet) { return mesh_.isGhostTet(tet); }))
        return false;
    if (tets_.delaunay->remove(vertex) == RemovalStatus::Removed) return true;
    if (contract(vertex)) return true;
    // Little is to be hoped for, at high cost, from a vertex that most of a solid is joined to.
    return hole_.size() <= kMaxHole && (contractAfterFlips(vertex) || removeWithNeighbours(vertex));
}

/// Removes edges at the vertex, one after the other, until a neighbour sees all that is left of its hole.
bool FreeVertexRemover::contractAfterFlips(VertexId vertex)
{
    const TetMeasure measure = [](const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
        return flatness(a, b, c, d);
    };
    flips_.accept();
    bool isImproved = true;
    while (isImproved) {
        isImproved = false;
        for (const VertexId other : neighboursOf(vertex)) {
            flips_.allowTrials(1);
            if (!flips_.removeEdge(vertex, other, TetId(), 0, measure)) continue;
            isImproved = true;
            if (contract(vertex)) return true;
        }
    }
    flips_.takeBackTo(0);
    return false;
}

std::vector<VertexId> FreeVertexRemover::neighboursOf(VertexId vertex)
{
    mesh_.collectStar(vertex, hole_);
    std::vector<VertexId> neighbours;
    for (const TetId tet : hole_) {
        for (const VertexId v : mesh_.tet(tet).vertex) {
            if (v != vertex && std::find(neighbours.begin(), neighbours.end(), v) == neighbours.end())
                neighbours.push_back(v);
        }
    }
    return neighbours;
}

bool FreeVertexRemover::removeWithNeighbours(VertexId vertex)
{
    mesh_.collectStar(vertex, hole_);
    if (!holes_.refill(hole_, vertex, kMaxHole)) return false;
    mesh_.removeVertex(vertex);
    return true;
}

/// Moves the vertex into a neighbour that sees all of the hole.
bool FreeVertexRemover::contract(VertexId vertex)
{
    for (const VertexId target : neighboursOf(vertex)) {
        if (!fillFrom(vertex, target)) continue;
        replacement_.replace(hole_, filling_);
        mesh_.removeVertex(vertex);
        return true;
    }
    return false;
}

bool FreeVertexRemover::fillFrom(VertexId vertex, VertexId target)
{
    filling_.clear();
    for (const TetId tet : hole_) {
        if (mesh_.slotOf(tet, target) >= 0) continue;
        const auto [a, b, c] = mesh_.faceVertices({tet, mesh_.slotOf(tet, vertex)});
        if (orient3d(mesh_.position(a), mesh_.position(b), mesh_.position(c), mesh_.position(target)) !=
            Sign::Positive) {
            return false;
        }
        filling_.push_back({a, b, c, target});
    }
    return true;
}

FreeVertexRemoval removeFreeVertices(ConstrainedTetrahedralization& tets, SurfaceScaffold scaffold,
                                     Budget& budget, RunContext& context)
{
    std::vector<VertexId> free = listFree(tets, scaffold);
    const std::size_t all = free.size();
    std::size_t tried = 0;
    const auto mayGoOn = [&] {
        if (++tried % kTrialsPerReport == 0)
            context.reportProgress("removal of free vertices",
                                   std::min(1.0, static_cast<double>(tried) / static_cast<double>(all)));
        return budget.allows({tets.mesh().vertexCount(), tets.mesh().tetCount()});
    };
    std::erase_if(
        free, [&](VertexId v) { return mayGoOn() && tets.delaunay->remove(v) == RemovalStatus::Removed; });
    FreeVertexRemover remover(tets);
    for (int pass = 0; pass < kPasses && !free.empty(); ++pass) {
        const std::size_t before = free.size();
        std::erase_if(free, [&](VertexId vertex) { return mayGoOn() && remover.remove(vertex); });
        if (free.size() == before) break;
    }
    return {static_cast<std::uint32_t>(all - free.size()), static_cast<std::uint32_t>(free.size())};
}

}  // namespace mesher
