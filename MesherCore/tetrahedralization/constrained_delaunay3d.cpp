#include "tetrahedralization/constrained_delaunay3d.h"

#include "delaunay/flips3d.h"
#include "predicates/insphere.h"
#include "predicates/orient3d.h"
#include "tetrahedralization/hole_refill.h"

#include <algorithm>
#include <deque>
#include <optional>

namespace mesher {

namespace {

/// Tetrahedra that are filled anew at once.
constexpr std::size_t kMaxCavity = 200;
constexpr std::uint32_t kTetsPerReport = 1u << 16;
constexpr std::uint64_t kFlipsPerReport = 1u << 12;
constexpr std::size_t kCavitiesPerReport = 16;

class LawsonFlips
{
public:
    LawsonFlips(Delaunay3d& delaunay, Budget& budget, RunContext& context)
        : mesh_(delaunay.triangulation()),
          filter_(delaunay.filter()),
          budget_(budget),
          context_(context),
          replacement_(mesh_),
          holes_(mesh_)
    {
    }

    ConstrainedDelaunayCounts run()
    {
        for (std::uint32_t i = 0; i < mesh_.tetLimit(); ++i) {
            const TetId tet(i);
            if (i % kTetsPerReport == 0 && !mayGoOn(static_cast<double>(i) / mesh_.tetLimit()))
                return counts_;
            if (!mesh_.isAlive(tet) || mesh_.isGhostTet(tet)) continue;
            for (int face = 0; face < 4; ++face) {
                if (tet < mesh_.neighbour(tet, face).tet()) pushIfNotDelaunay({tet, face});
            }
        }
        do {
            flipUntilStuck();
        } while (!budget_.exhausted() && fillStuckOnes());
        return counts_;
    }

private:
    struct Entry
    {
        TetFace face;
        std::uint16_t generation;
    };

    bool mayGoOn(double fraction)
    {
        context_.reportProgress("constrained Delaunay", fraction);
        return budget_.allows({mesh_.vertexCount(), mesh_.tetCount()});
    }

    [[nodiscard]] bool isCurrent(const Entry& entry) const
    {
        return mesh_.isAlive(entry.face.tet()) && mesh_.generation(entry.face.tet()) == entry.generation;
    }

    [[nodiscard]] bool isNotDelaunay(TetFace face) const
    {
        const TetFace other = mesh_.neighbour(face);
        if (mesh_.isGhostTet(face.tet()) || mesh_.isGhostTet(other.tet()) || mesh_.isFaceConstrained(face))
            return false;
        const auto& v = mesh_.tet(face.tet()).vertex;
        return insphere(filter_, mesh_.position(v[0]), mesh_.position(v[1]), mesh_.position(v[2]),
                        mesh_.position(v[3]),
                        mesh_.position(mesh_.vertex(other.tet(), other.face()))) == Sign::Positive;
    }

    void pushIfNotDelaunay(TetFace face)
    {
        if (isNotDelaunay(face)) queue_.push_back({face, mesh_.generation(face.tet())});
    }

    void pushCreated(const std::vector<TetId>& created)
    {
        for (const TetId tet : created) {
            for (int face = 0; face < 4; ++face) pushIfNotDelaunay({tet, face});
        }
    }

    bool mayFlip()
    {
        if (counts_.flips % kFlipsPerReport == kFlipsPerReport - 1) return mayGoOn(1.0);
        return budget_.allows({mesh_.vertexCount(), mesh_.tetCount()});
    }

    void flipQueue()
    {
        while (!queue_.empty()) {
            const Entry entry = queue_.front();
            queue_.pop_front();
            if (!isCurrent(entry) || !isNotDelaunay(entry.face)) continue;
            if (!mayFlip()) return;
            const std::optional<Flip3d> flip = findFlip(entry.face);
            if (!flip) {
                stuck_.push_back(entry);
                continue;
            }
            applyFlip(replacement_, *flip);
            ++counts_.flips;
            pushCreated(replacement_.created());
        }
    }

    /// A face may wait for a flip beside it.
    void flipUntilStuck()
    {
        std::uint64_t before = 0;
        do {
            before = counts_.flips;
            queue_.insert(queue_.end(), stuck_.begin(), stuck_.end());
            stuck_.clear();
            flipQueue();
        } while (counts_.flips > before && !stuck_.empty() && !budget_.exhausted());
    }

    /// The flip of the convex union of the tetrahedra at the face: 2-3 inside of it, 3-2 or 4-4 at an edge of it.
    [[nodiscard]] std::optional<Flip3d> findFlip(TetFace face) const
    {
        if (auto flip = evaluateFlip23(mesh_, face)) return flip;
        const TetFace other = mesh_.neighbour(face);
        const VertexId above = mesh_.vertex(face.tet(), face.face());
        const VertexId below = mesh_.vertex(other.tet(), other.face());
        const auto corner = mesh_.faceVertices(face);
        for (unsigned k = 0; k < 3; ++k) {
            const VertexId a = corner[k];
            const VertexId b = corner[(k + 1) % 3];
            const int edge = kEdgeOfSlots[mesh_.slotOf(face.tet(), a)][mesh_.slotOf(face.tet(), b)];
            const Sign bend = orient3d(filter_, mesh_.position(a), mesh_.position(b), mesh_.position(below),
                                       mesh_.position(above));
            if (bend == Sign::Zero) {
                if (auto flip = findFlip44(face.tet(), edge, above, below)) return flip;
            } else if (auto flip = evaluateFlip32(mesh_, face.tet(), edge)) {
                return flip;
            }
        }
        return {};
    }

    /// The 4-4 flip that joins the two apices, which lie in one plane with the edge.
    [[nodiscard]] std::optional<Flip3d> findFlip44(TetId tet, int edge, VertexId above, VertexId below) const
    {
        for (const int diagonal : {0, 1}) {
            auto flip = evaluateFlip44(mesh_, tet, edge, diagonal);
            if (!flip || !flip->constrainedFaces.empty()) continue;
            const TetCorners& corners = flip->after.front();
            const auto has = [&](VertexId v) {
                return std::find(corners.begin(), corners.end(), v) != corners.end();
            };
            if (has(above) && has(below)) return flip;
        }
        return {};
    }

    /// Fills the tetrahedra at stuck faces with Delaunay ones. Whether any was changed.
    bool fillStuckOnes()
    {
        std::vector<Entry> stuck;
        stuck.swap(stuck_);
        bool isChanged = false;
        std::size_t tried = 0;
        for (const Entry& entry : stuck) {
            if (!isCurrent(entry) || !isNotDelaunay(entry.face)) continue;
            if (++tried % kCavitiesPerReport == 0 ? !mayGoOn(1.0) : !mayFlip()) return false;
            const TetId tets[] = {entry.face.tet(), mesh_.neighbour(entry.face).tet()};
            if (!holes_.refill(tets, VertexId(), kMaxCavity)) continue;
            isChanged = true;
            ++counts_.cavities;
            pushCreated(holes_.created());
        }
        return isChanged;
    }

    Triangulation3d& mesh_;
    const StaticFilter3d& filter_;
    Budget& budget_;
    RunContext& context_;
    TetReplacement3d replacement_;
    HoleRefill holes_;
    ConstrainedDelaunayCounts counts_;
    std::deque<Entry> queue_;
    std::vector<Entry> stuck_;
};

}  // namespace

ConstrainedDelaunayCounts makeConstrainedDelaunay(ConstrainedTetrahedralization& tets, Budget& budget,
                                                  RunContext& context)
{
    return LawsonFlips(*tets.delaunay, budget, context).run();
}

}  // namespace mesher
