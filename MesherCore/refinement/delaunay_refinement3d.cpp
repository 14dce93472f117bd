#include "refinement/delaunay_refinement3d.h"

#include "base/backlog_watch.h"
#include "refinement/bad_tet_queue.h"
#include "refinement/boundary_queue3d.h"
#include "refinement/facet_swap3d.h"
#include "refinement/insert_circumcentre.h"
#include "refinement/left_tets3d.h"
#include "refinement/non_delaunay_faces3d.h"
#include "refinement/refinement_check.h"
#include "refinement/refinement_state3d.h"
#include "refinement/stubborn_tets3d.h"

#include <algorithm>
#include <bit>
#include <cmath>

namespace mesher {

namespace {

class Refiner
{
public:
    Refiner(ConstrainedTetrahedralization& t, SurfaceSplitter& splitter,
            const DelaunayRefinementOptions3d& options, Budget& budget, RunContext& context)
        : state_(t, splitter, options, context),
          badTets_(state_),
          boundary_(state_, badTets_),
          insertion_(state_, badTets_, boundary_),
          swap_(state_),
          stubborn_(state_, boundary_, insertion_, swap_),
          budget_(budget),
          context_(context)
    {
    }

    DelaunayRefinement3d run()
    {
        state_.scale.setInitial();
        countTets();
        flipAll(FacetSwap3d::kNearlyPlane);
        state_.walls.find(state_.splitter.mesh(), state_.options.maxWallTets, state_.options.flatFacets);
        state_.strips.find(state_.splitter.mesh(), state_.options.flatStrips);
        insertSinks();
        if (state_.options.boundary == BoundaryPolicy::Split) {
            boundary_.pushSegments();
            drain(Phase::Boundary);
            boundary_.pushFacets();
            drain(Phase::Boundary);
        }
        badTets_.pushAll();
        drain(Phase::Size);
        drain(Phase::Quality);
        tryHeldBack();
        DelaunayRefinement3d result;
        result.nonDelaunayFaces = makeDelaunay();
        if (insistOnStubborn()) result.nonDelaunayFaces = makeDelaunay();
        result.unreachable = unreachable_;
        result.hasStalled = hasStalled_;
        constexpr std::size_t kMostEntities = 5;
        if (hasStalled_) result.costliest = state_.ledger.costliest(kMostEntities);
        result.left = collectLeftTets(state_, isStopped_ && !hasStalled_, result.costliest);
        state_.counts.delaunayFlips = state_.flips.counts().flips;
        state_.counts.delaunayCavities = state_.flips.counts().cavities;
        result.walls = state_.walls.walls();
        result.gaps = boundary_.narrowGaps();
        state_.counts.boundary = boundary_.splitCounts();
        state_.counts.cavityRepairs = state_.t.delaunay->counters().cavityRepairs;
        result.counts = state_.counts;
        const bool isComplete = result.left.empty();
        result.stopReason = budget_.stopReason(isComplete ? StopReason::Done : StopReason::CannotImprove);
        return result;
    }

private:
    enum class Phase
    {
        Boundary,
        Size,
        Quality
    };

    bool mayGoOn()
    {
        constexpr std::uint64_t kOperationsPerReport = 512;
        const std::uint64_t done = budget_.operations();
        if (done % kOperationsPerReport == 0) {
            const std::size_t waiting = boundary_.size() + badTets_.size();
            const auto total = static_cast<double>(done) + static_cast<double>(waiting) + 1.0;
            progress_ = std::max(progress_, 0.99 * static_cast<double>(done) / total);
            if (!context_.reportProgress("refinement", progress_)) context_.requestCancel();
        }
        if (!budget_.allows({state_.mesh.vertexCount(), meshedTets()})) return false;
        if (budget_.operations() > liftedUntil_) state_.isLambdaLifted = false;
        hasStalled_ = state_.ledger.isSpent();
        if (hasStalled_) return false;
        if (context_.checkLevel() == CheckLevel::Full && std::has_single_bit(budget_.operations())) {
            MESHER_INVARIANT(checkRefinement(state_.t, state_.splitter.mesh()).isValid());
        }
        return true;
    }

    void insertSinks()
    {
        // What is out of reach would be found out of reach in the quality phase only, after sinks without end.
        if (state_.criteria.asksForMoreThanUsual()) state_.criteria.settleForUsual();
        badTets_.beginSinks();
        badTets_.pushAll();
        while (!isStopped_) {
            const std::optional<BadTetQueue::Entry> entry = badTets_.takeSink();
            if (!entry) break;
            if (!mayGoOn()) {
                isStopped_ = true;
            } else if (insertion_.attempt(entry->id) == Attempt::Inserted) {
                ++state_.counts.sinkInsertions;
            }
        }
        badTets_.endSinks();
        state_.criteria.returnToWanted();
        state_.ledger.settle();
    }

    /// The boundary before sizes, sizes before quality.
    void drain(Phase phase)
    {
        while (!isStopped_) {
            if (!boundary_.isEmpty()) {
                isStopped_ = !mayGoOn();
                if (!isStopped_) boundary_.serveNext();
                continue;
            }
            if (phase == Phase::Boundary) return;
            if (serveTet(TetNeed::Size)) continue;
            if (phase == Phase::Size || !serveTet(TetNeed::Quality)) return;
        }
    }

    /// What lambda has held back is tried with it lifted, now that the mesh around is good, and so is what that makes: mostly a
    /// few that would be a little too small. An allowance of operations ends what would go on.
    void tryHeldBack()
    {
        constexpr std::uint64_t kFewOperations = 1000;
        constexpr std::uint64_t kOperationsForEach = 20;
        if (isStopped_ || !badTets_.hasHeldBack()) return;
        state_.liftLambda();
        state_.counts.heldBackTets = badTets_.pushHeldBack();
        boundary_.forgetRefusals();
        liftedUntil_ =
            budget_.operations() + kFewOperations + kOperationsForEach * state_.counts.heldBackTets;
        drain(Phase::Quality);
    }

    /// Bad tetrahedra that nothing could be done for are tried once more if they are few. Whether anything was changed.
    bool insistOnStubborn()
    {
        constexpr int kMostRounds = 4;
        constexpr std::size_t kFew = 50;
        const auto changes = [&] {
            return state_.counts.qualityInsertions + state_.counts.segmentSplits + state_.counts.facetSplits +
                   state_.counts.facetSwaps;
        };
        const std::uint64_t atFirst = changes();
        for (int round = 0; round < kMostRounds && !isStopped_; ++round) {
            const std::uint64_t before = changes();
            for (const TetId tet : stubborn_.findFew(kFew)) insistOn(tet);
            drain(Phase::Quality);
            if (changes() == before) break;
        }
        return changes() != atFirst;
    }

    void insistOn(TetId tet)
    {
        constexpr int kMostSplits = 4;
        const std::uint16_t generation = state_.mesh.generation(tet);
        const auto isThere = [&] {
            return state_.isMeshed(tet) && state_.mesh.generation(tet) == generation;
        };
        // It may be another one in the place of one that an earlier try has removed.
        if (!isThere() || state_.judge(tet).need != TetNeed::Quality) return;
        Attempt attempt = Attempt::Rejected;
        for (int k = 0; k < kMostSplits && attempt == Attempt::Rejected && isThere() && !isStopped_; ++k) {
            attempt = stubborn_.attempt(tet);
            if (attempt == Attempt::Inserted) ++state_.counts.qualityInsertions;
            pushNew(stubborn_.changed());
            drain(Phase::Boundary);
        }
        if (!isThere()) ++state_.counts.stubbornTets;
    }

    /// Flips and refinement in turn, since flips can make slivers, until both are content. Returns what is left.
    std::vector<NonDelaunayFaces3d> makeDelaunay()
    {
        constexpr int kMostRounds = 8;
        bool isChanged = true;
        for (int round = 0; round < kMostRounds && isChanged; ++round) {
            isChanged = flipAll(swap_.mostHeight());
            if (isChanged) drain(Phase::Quality);
        }
        state_.counts.nonDelaunayFaces = 0;
        if (!isChanged && state_.flips.stuck().empty()) return {};
        std::vector<NonDelaunayFaces3d> left = explainNonDelaunayFaces(state_, !isChanged);
        for (const NonDelaunayFaces3d& faces : left) state_.counts.nonDelaunayFaces += faces.count;
        return left;
    }

    /// Makes all faces Delaunay as far as possible. False if nothing was to be changed.
    bool flipAll(double mostHeight)
    {
        bool isChanged = expelSlivers();
        state_.flips.pushAll(state_.flipBudget);
        do {
            state_.flips.clearCreated();
            state_.flips.flipAndFill(state_.flipBudget);
            isChanged = isChanged || !state_.flips.created().empty();
            pushNew(state_.flips.created());
        } while (swapStuck(mostHeight));
        return isChanged;
    }

    /// Tetrahedra without height on two facets of one plane.
    bool expelSlivers()
    {
        bool isChanged = false;
        for (std::uint32_t i = 0; i < state_.mesh.tetLimit(); ++i) {
            if ((state_.mesh.flags(TetId(i)) & tet_flag::kFaces) == 0 || !swap_.expel(TetId(i))) continue;
            isChanged = true;
            pushNew(swap_.changed());
        }
        return isChanged;
    }

    /// Swaps the diagonals of facets that keep faces from being flipped. Whether there were any.
    bool swapStuck(double mostHeight)
    {
        bool isChanged = false;
        const std::vector<TetFace> stuck = state_.flips.stuck();
        for (const TetFace face : stuck) {
            if (!state_.isMeshed(face.tet()) || !state_.flips.isNotDelaunay(face)) continue;
            if (!swap_.swapAt(face, mostHeight)) continue;
            isChanged = true;
            state_.flips.push(swap_.changed());
            pushNew(swap_.changed());
        }
        return isChanged;
    }

    void pushNew(const std::vector<TetId>& tets)
    {
        for (const TetId tet : tets) {
            if (!state_.isMeshed(tet)) continue;
            boundary_.pushEncroachedAt(tet);
            badTets_.push(tet);
        }
    }

    /// False when the queue has nothing more.
    bool serveTet(TetNeed need)
    {
        const std::optional<BadTetQueue::Entry> entry = badTets_.take(need);
        if (!entry) return false;
        if (!mayGoOn()) {
            isStopped_ = true;
            return true;
        }
        if (need == TetNeed::Quality && isOutOfReach(entry->key)) {
            // Keys change with the limits.
            badTets_.pushAll();
            return true;
        }
        const Attempt attempt = insertion_.attempt(entry->id);
        if (attempt != Attempt::Inserted) state_.ledger.charge(insertion_.inTheWay());
        switch (attempt) {
            case Attempt::Inserted:
                state_.ledger.settle();
                if (state_.isLambdaLifted) ++state_.counts.liftedInsertions;
                ++(need == TetNeed::Size ? state_.counts.sizeInsertions : state_.counts.qualityInsertions);
                break;
            case Attempt::Rejected: badTets_.pushAgain(*entry, need); break;
            case Attempt::Impossible: break;
        }
        return true;
    }

    /// Whether limits above the measure's own have just been given up, since more vertices do not bring them nearer.
    bool isOutOfReach(double key)
    {
        if (unreachable_ || !state_.criteria.asksForMoreThanUsual()) return false;
        const std::uint64_t vertices = state_.mesh.vertexCount();
        // The worst comes first, so that all that wait score as much.
        if (isBacklogKnown_) bestScore_ = std::max(bestScore_, 1.0 / std::sqrt(key));
        if (!backlog_.isDue(vertices)) return false;
        isBacklogKnown_ = true;
        UnreachableQuality3d found{.tets = meshedTets()};
        for (std::uint32_t i = 0; i < state_.mesh.tetLimit(); ++i) {
            if (state_.isMeshed(TetId(i)) && state_.judge(TetId(i)).need == TetNeed::Quality) ++found.bad;
        }
        if (!backlog_.look(vertices, found.bad)) return false;
        found.best = bestScore_;
        unreachable_ = found;
        state_.criteria.settleForUsual();
        return true;
    }

    /// Those outside of all solids hardly change in number.
    [[nodiscard]] std::uint64_t meshedTets() const { return state_.mesh.tetCount() - exteriorTets_; }

    void countTets()
    {
        exteriorTets_ = state_.mesh.tetCount();
        for (std::uint32_t i = 0; i < state_.mesh.tetLimit(); ++i)
            exteriorTets_ -= state_.isMeshed(TetId(i)) ? 1u : 0u;
    }

    RefinementState3d state_;
    BadTetQueue badTets_;
    BoundaryQueue3d boundary_;
    CircumcentreInsertion insertion_;
    FacetSwap3d swap_;
    StubbornTets stubborn_;
    Budget& budget_;
    RunContext& context_;
    BacklogWatch backlog_;
    bool isBacklogKnown_ = false;
    double bestScore_ = 0.0;
    std::optional<UnreachableQuality3d> unreachable_;
    std::uint32_t exteriorTets_ = 0;  ///< at the start, ghosts included
    std::uint64_t liftedUntil_ = 0;   ///< operations of the budget after which lambda holds again
    double progress_ = 0.0;
    bool isStopped_ = false;
    bool hasStalled_ = false;
};

}  // namespace

DelaunayRefinement3d refineDelaunay3d(ConstrainedTetrahedralization& tetrahedralization,
                                      SurfaceSplitter& splitter, const DelaunayRefinementOptions3d& options,
                                      Budget& budget, RunContext& context)
{
    return Refiner(tetrahedralization, splitter, options, budget, context).run();
}

}  // namespace mesher
