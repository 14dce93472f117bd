#include "tetrahedralization/free_vertex_removal.h"

#include "delaunay/cavity_retriangulation.h"
#include "predicates/orient3d.h"
#include "tetrahedralization/flip_search.h"

#include <algorithm>

namespace mesher {

namespace {

/// Tetrahedra that the hole of a vertex may grow to.
constexpr std::size_t kMaxHole = 120;
/// A removal may make way for another.
constexpr int kPasses = 3;

class FreeVertexRemover
{
public:
    FreeVertexRemover(ConstrainedTetrahedralization& tets, SurfaceScaffold scaffold)
        : tets_(tets),
          scaffold_(scaffold),
          mesh_(tets.mesh()),
          flips_(mesh_),
          replacement_(mesh_),
          cavities_(mesh_)
    {
    }

    FreeVertexRemoval run()
    {
        FreeVertexRemoval result;
        std::vector<VertexId> free = listFree();
        const std::size_t all = free.size();
        std::erase_if(free, [&](VertexId v) { return tets_.delaunay->remove(v) == RemovalStatus::Removed; });
        for (int pass = 0; pass < kPasses && !free.empty(); ++pass) {
            const std::size_t before = free.size();
            std::erase_if(free, [&](VertexId vertex) { return remove(vertex); });
            if (free.size() == before) break;
        }
        result.removed = static_cast<std::uint32_t>(all - free.size());
        result.left = static_cast<std::uint32_t>(free.size());
        return result;
    }

private:
    [[nodiscard]] std::vector<VertexId> listFree() const
    {
        std::vector<VertexId> free;
        for (std::uint32_t i = 0; i < mesh_.vertexLimit(); ++i) {
            const VertexId vertex(i);
            if (!mesh_.isVertexAlive(vertex) || tets_.nodeOf[vertex].isValid()) continue;
            const bool isKept =
                scaffold_ == SurfaceScaffold::Kept && mesh_.classification(vertex).scaffold != 0;
            if (!isKept && mesh_.region(mesh_.incidentTet(vertex)) != kExteriorRegion) free.push_back(vertex);
        }
        return free;
    }

    bool remove(VertexId vertex)
    {
        if (tets_.delaunay->remove(vertex) == RemovalStatus::Removed) return true;
        if (contract(vertex)) return true;
        // Little is to be hoped for, at high cost, from a vertex that most of a solid is joined to.
        return hole_.size() <= kMaxHole && (contractAfterFlips(vertex) || removeWithNeighbours(vertex));
    }

    /// Removes edges at the vertex, one after the other, until a neighbour sees all that is left of its hole.
    bool contractAfterFlips(VertexId vertex)
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
                if (!flips_.removeEdge(vertex, other, 0, measure)) continue;
                isImproved = true;
                if (contract(vertex)) return true;
            }
        }
        flips_.takeBackTo(0);
        return false;
    }

    std::vector<VertexId> neighboursOf(VertexId vertex)
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

    /// The hole grows where its surface is not Delaunay, up to constrained faces.
    bool removeWithNeighbours(VertexId vertex)
    {
        mesh_.collectStar(vertex, hole_);
        while (true) {
            CavityShell shell;
            std::vector<VertexId> inside;
            if (!makeShell(vertex, shell, inside)) return false;
            filling_.clear();
            if (cavities_.fillDelaunay(shell, inside, filling_)) break;
            if (cavities_.missing().empty() || !enlarge(shell)) return false;
        }
        if (!keepsConstrainedEdges()) return false;
        replacement_.replace(hole_, filling_);
        mesh_.removeVertex(vertex);
        return true;
    }

    bool enlarge(const CavityShell& shell)
    {
        for (const auto& key : cavities_.missing()) {
            const TetFace outer = shell.faces().at(key).outer;
            if (mesh_.isFaceConstrained(outer) || mesh_.isGhostTet(outer.tet())) return false;
            if (std::find(hole_.begin(), hole_.end(), outer.tet()) == hole_.end())
                hole_.push_back(outer.tet());
        }
        return hole_.size() <= kMaxHole;
    }

    bool makeShell(VertexId vertex, CavityShell& shell, std::vector<VertexId>& inside) const
    {
        std::vector<VertexId> onShell;
        for (const TetId tet : hole_) {
            for (int face = 0; face < 4; ++face) {
                const TetFace outer = mesh_.neighbour(tet, face);
                if (std::find(hole_.begin(), hole_.end(), outer.tet()) != hole_.end()) {
                    if (mesh_.isFaceConstrained(outer)) return false;
                    continue;
                }
                const auto corner = mesh_.faceVertices({tet, face});
                if (!shell.add({corner, outer})) return false;
                onShell.insert(onShell.end(), corner.begin(), corner.end());
            }
        }
        for (const TetId tet : hole_) {
            for (const VertexId v : mesh_.tet(tet).vertex) {
                if (v != vertex && std::find(onShell.begin(), onShell.end(), v) == onShell.end() &&
                    std::find(inside.begin(), inside.end(), v) == inside.end()) {
                    inside.push_back(v);
                }
            }
        }
        return true;
    }

    [[nodiscard]] bool keepsConstrainedEdges() const
    {
        for (const TetId tet : hole_) {
            for (int edge = 0; edge < 6; ++edge) {
                if (!mesh_.isEdgeConstrained(tet, edge)) continue;
                const VertexId a = mesh_.vertex(tet, kEdgeSlots[edge][0]);
                const VertexId b = mesh_.vertex(tet, kEdgeSlots[edge][1]);
                const bool isKept =
                    std::any_of(filling_.begin(), filling_.end(), [&](const TetCorners& corners) {
                        return std::find(corners.begin(), corners.end(), a) != corners.end() &&
                               std::find(corners.begin(), corners.end(), b) != corners.end();
                    });
                if (!isKept) return false;
            }
        }
        return true;
    }

    /// Moves the vertex into a neighbour that sees all of the hole.
    bool contract(VertexId vertex)
    {
        for (const VertexId target : neighboursOf(vertex)) {
            if (!fillFrom(vertex, target)) continue;
            replacement_.replace(hole_, filling_);
            mesh_.removeVertex(vertex);
            return true;
        }
        return false;
    }

    bool fillFrom(VertexId vertex, VertexId target)
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

    ConstrainedTetrahedralization& tets_;
    SurfaceScaffold scaffold_;
    Triangulation3d& mesh_;
    FlipSearch flips_;
    TetReplacement3d replacement_;
    CavityRetriangulation cavities_;
    std::vector<TetId> hole_;
    std::vector<TetCorners> filling_;
};

}  // namespace

FreeVertexRemoval removeFreeVertices(ConstrainedTetrahedralization& tets, SurfaceScaffold scaffold)
{
    return FreeVertexRemover(tets, scaffold).run();
}

}  // namespace mesher
