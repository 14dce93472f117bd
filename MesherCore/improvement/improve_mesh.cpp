#include "improvement/improve_mesh.h"

#include "improvement/dihedral_score.h"
#include "improvement/tet_improver.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

namespace mesher {

namespace {

/// How much better than wanted, by the score, the tetrahedra about those left bad are to be: 37 degrees in place of 30.
constexpr double kSurroundings = 1.2;
/// Below so much of what is wanted, 7 degrees in place of 30, a small angle of the model is at work: a change only makes another bad
/// tetrahedron of one, flatter for less sharp.
constexpr double kHopeless = 0.25;
/// Rounds over those left bad with their surroundings; the first helps most of all that are helped.
constexpr int kSurroundingRounds = 4;

/// Tetrahedra that may be tried with their surroundings in vain, the worst first. One or two of ten thousand are left bad where they
/// can be helped, and most of them are; where far more are, small angles and thin walls made them.
std::uint64_t mostTriesInVain(std::uint32_t tets) { return 100 + tets / 10000; }

double sineOf(double degrees) { return std::sin(degrees * std::numbers::pi / 180.0); }

class ImprovementRun
{
public:
    ImprovementRun(TetComplex& complex, const IdVector<NodeId, MeshNode>& first, const BrepModel& model,
                   const ImprovementOptions& options, Budget& budget, RunContext& context)
        : complex_(complex),
          geometry_(model, complex, first, options.maxSag),
          improver_(complex, geometry_, options.boundary, result_.counts),
          options_(options),
          budget_(budget),
          context_(context),
          target_(sineOf(options.wantedAngle))
    {
    }

    Improvement run()
    {
        result_.scoreBefore = leastScore();
        result_.anglesBefore = dihedralRange();
        result_.counts.badBefore = badCount();
        while (result_.counts.passes < static_cast<std::uint64_t>(options_.maxPasses) && pass()) {
        }
        std::uint64_t triesLeft = mostTriesInVain(complex_.tetLimit());
        for (int round = 0; round < kSurroundingRounds && improveSurroundings(triesLeft); ++round) {
        }
        result_.scoreAfter = leastScore();
        result_.counts.badAfter = badCount();
        result_.stopReason =
            budget_.stopReason(result_.counts.badAfter == 0 ? StopReason::Done : StopReason::CannotImprove);
        return result_;
    }

private:
    /// The worst first. False when there was nothing to try, or the budget has run out.
    bool pass()
    {
        const std::vector<std::pair<double, TetId>> bad = badTets(tried_);
        if (bad.empty()) return false;
        ++result_.counts.passes;
        // The first round does nearly all; those after it are not told, as progress only grows.
        const bool isFirst = result_.counts.passes == 1;
        StageProgress progress(context_, "improvement", bad.size());
        for (const auto& [score, t] : bad) {
            const bool goesOn = !isFirst || progress.advance();
            if (!budget_.allows() || !goesOn) return false;
            if (!complex_.isAlive(t) || complex_.score(t) >= target_) continue;
            improver_.improve(t, target_);
            if (complex_.isAlive(t)) remember(t, tried_);
        }
        return true;
    }

    /// One round over those that nothing helped alone. False when there was nothing to try, or tries or budget are used up.
    bool improveSurroundings(std::uint64_t& triesLeft)
    {
        const std::vector<std::pair<double, TetId>> bad = badTets(triedAround_);
        for (const auto& [score, t] : bad) {
            if (!complex_.isAlive(t) || complex_.score(t) >= target_) continue;
            if (complex_.score(t) < kHopeless * target_) continue;
            if (triesLeft == 0 || !budget_.allows()) return false;
            ++result_.counts.surroundings;
            improver_.improveWithSurroundings(t, target_, {kHopeless * target_, kSurroundings * target_});
            if (!complex_.isAlive(t) || complex_.score(t) >= target_) continue;
            remember(t, triedAround_);
            --triesLeft;
        }
        return !bad.empty();
    }

    /// Those about which something has changed since they were tried.
    std::vector<std::pair<double, TetId>> badTets(IdVector<TetId, std::uint32_t>& tried) const
    {
        std::vector<std::pair<double, TetId>> bad;
        tried.resize(complex_.tetLimit(), 0);
        for (std::uint32_t i = 0; i < complex_.tetLimit(); ++i) {
            const TetId t(i);
            if (!complex_.isAlive(t) || complex_.score(t) >= target_) continue;
            if (tried[t] != versionOf(t)) bad.emplace_back(complex_.score(t), t);
        }
        std::sort(bad.begin(), bad.end());
        return bad;
    }

    /// Elements at its nodes as they are now have been tried.
    void remember(TetId t, IdVector<TetId, std::uint32_t>& tried) const
    {
        tried.resize(complex_.tetLimit(), 0);
        tried[t] = versionOf(t);
    }
    [[nodiscard]] std::uint32_t versionOf(TetId t) const
    {
        std::uint32_t sum = 0;
        for (const NodeId n : complex_.nodes(t)) sum += complex_.version(n);
        return sum;
    }

    [[nodiscard]] double leastScore() const
    {
        double least = 1.0;
        for (std::uint32_t i = 0; i < complex_.tetLimit(); ++i) {
            if (complex_.isAlive(TetId(i))) least = std::min(least, complex_.score(TetId(i)));
        }
        return least;
    }
    /// A tetrahedron with an angle beyond those known scores less than these allow, so that few need be asked.
    [[nodiscard]] DihedralRange dihedralRange() const
    {
        DihedralRange range;
        double reach = 1.0;
        for (std::uint32_t i = 0; i < complex_.tetLimit(); ++i) {
            const TetId t(i);
            if (!complex_.isAlive(t) || complex_.score(t) > reach) continue;
            for (const double angle : dihedralAngles(complex_.corners(complex_.nodes(t)))) {
                range.least = std::min(range.least, angle);
                range.largest = std::max(range.largest, angle);
            }
            reach = std::max(sineOf(range.least), kObtuseWeight * sineOf(range.largest)) * (1.0 + 1e-9);
        }
        return range;
    }
    [[nodiscard]] std::uint64_t badCount() const
    {
        std::uint64_t count = 0;
        for (std::uint32_t i = 0; i < complex_.tetLimit(); ++i) {
            if (complex_.isAlive(TetId(i)) && complex_.score(TetId(i)) < target_) ++count;
        }
        return count;
    }

    TetComplex& complex_;
    Improvement result_;
    BoundaryGeometry geometry_;
    TetImprover improver_;
    const ImprovementOptions& options_;
    Budget& budget_;
    RunContext& context_;
    double target_;
    IdVector<TetId, std::uint32_t> tried_;        ///< versionOf when they were tried alone
    IdVector<TetId, std::uint32_t> triedAround_;  ///< and with their surroundings
};

}  // namespace

Result<Improvement> improveMesh(ClassifiedMesh& mesh, const BrepModel& model,
                                const ImprovementOptions& options, RunContext& context)
{
    if (!(options.wantedAngle > 0.0 && options.wantedAngle <= 60.0)) {
        return Error{ErrorCode::InvalidArgument,
                     "wanted angle is out of range",
                     {},
                     {},
                     "choose more than 0 and at most 60 degrees"};
    }
    Budget budget(options.limits, context);
    TetComplex complex(mesh);
    const Improvement result = ImprovementRun(complex, mesh.nodes, model, options, budget, context).run();
    complex.writeTo(mesh);
    context.reportProgress("improvement", 1.0);
    return result;
}

}  // namespace mesher
