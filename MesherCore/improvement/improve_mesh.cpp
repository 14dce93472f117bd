#include "improvement/improve_mesh.h"

#include "improvement/dihedral_score.h"
#include "improvement/edge_contraction.h"
#include "improvement/face_removal.h"
#include "improvement/vertex_insertion.h"
#include "improvement/vertex_smoothing.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

namespace mesher {

namespace {

double sineOf(double degrees) { return std::sin(degrees * std::numbers::pi / 180.0); }

/// The edges of a tetrahedron, that of the largest dihedral angle first: to do without it helps flat ones most.
std::array<std::size_t, 6> edgesByAngle(const TetCorners& p)
{
    const std::array<Vec3, 4> face = {cross(p[2] - p[1], p[3] - p[1]), cross(p[3] - p[0], p[2] - p[0]),
                                      cross(p[1] - p[0], p[3] - p[0]), cross(p[2] - p[0], p[1] - p[0])};
    std::array<double, 4> size{};
    for (std::size_t i = 0; i < 4; ++i) size[i] = length(face[i]);
    std::array<std::pair<double, std::size_t>, 6> order;
    for (std::size_t e = 0; e < 6; ++e) {
        const auto& [k, l] = kTetEdgeCorners[5 - e];
        order[e] = {-dot(face[k], face[l]) / (size[k] * size[l]), e};
    }
    std::sort(order.begin(), order.end());
    std::array<std::size_t, 6> edges{};
    for (std::size_t e = 0; e < 6; ++e) edges[e] = order[e].second;
    return edges;
}

class ImprovementRun
{
public:
    ImprovementRun(TetComplex& complex, const IdVector<NodeId, MeshNode>& first, const BrepModel& model,
                   const ImprovementOptions& options, Budget& budget, RunContext& context)
        : complex_(complex),
          geometry_(model, complex, first, options.maxSag),
          smoothing_(complex, geometry_, options.boundary),
          insertion_(complex, smoothing_),
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
        result_.scoreAfter = leastScore();
        result_.counts.badAfter = badCount();
        result_.stopReason =
            budget_.stopReason(result_.counts.badAfter == 0 ? StopReason::Done : StopReason::CannotImprove);
        return result_;
    }

private:
    enum class Kind
    {
        None,
        Edge,
        Swap,
        Face
    };

    /// The worst first. False when there was nothing to try, or the budget has run out.
    bool pass()
    {
        const std::vector<std::pair<double, TetId>> bad = badTets();
        if (bad.empty()) return false;
        ++result_.counts.passes;
        StageProgress progress(context_, "improvement", bad.size());
        for (const auto& [score, t] : bad) {
            const bool goesOn = progress.advance();
            if (!budget_.allows() || !goesOn) return false;
            if (!complex_.isAlive(t) || complex_.score(t) >= target_) continue;
            improve(t);
            if (complex_.isAlive(t)) remember(t);
        }
        return true;
    }

    std::vector<std::pair<double, TetId>> badTets()
    {
        std::vector<std::pair<double, TetId>> bad;
        tried_.resize(complex_.tetLimit(), 0);
        for (std::uint32_t i = 0; i < complex_.tetLimit(); ++i) {
            const TetId t(i);
            if (!complex_.isAlive(t) || complex_.score(t) >= target_) continue;
            if (tried_[t] != versionOf(t)) bad.emplace_back(complex_.score(t), t);
        }
        std::sort(bad.begin(), bad.end());
        return bad;
    }

    void improve(TetId t)
    {
        if (reconnect(t)) return;
        if (moveNodes(t)) return;
        if (contract(t)) return;
        insert(t);
    }

    /// Takes the best of the changes that do without an edge or a face of a tetrahedron, the first that reaches the target.
    bool reconnect(TetId t)
    {
        best_.clear();
        Kind kind = Kind::None;
        const TetNodes v = complex_.nodes(t);
        for (const std::size_t e : edgesByAngle(complex_.corners(v))) {
            if (best_.score >= target_) break;
            const auto& [i, j] = kTetEdgeCorners[e];
            if (!evaluateEdgeRemoval(complex_, geometry_, v[i], v[j], {options_.boundary, best_.score},
                                     change_))
                continue;
            kind = change_.swapsFacets ? Kind::Swap : Kind::Edge;
            std::swap(best_, change_);
        }
        for (std::size_t i = 0; i < 4 && best_.score < target_; ++i) {
            if (!evaluateFaceRemoval(complex_, t, i, best_.score, change_)) continue;
            kind = Kind::Face;
            std::swap(best_, change_);
        }
        if (kind == Kind::None) return false;
        apply(best_, complex_, geometry_);
        ++(kind == Kind::Edge   ? result_.counts.edgeRemovals
           : kind == Kind::Swap ? result_.counts.boundarySwaps
                                : result_.counts.faceRemovals);
        return true;
    }

    bool moveNodes(TetId t)
    {
        const TetNodes v = complex_.nodes(t);
        bool isMoved = false;
        for (const NodeId n : v) {
            if (complex_.score(t) >= target_) break;
            if (!smoothing_.evaluate(n, target_)) continue;
            const BoundaryMove& move = smoothing_.move();
            const auto dimension = complex_.node(n).entity.dimension;
            if (dimension < 3) geometry_.commit(move);
            complex_.move(n, move.position, move.parameters);
            ++(dimension == 3   ? result_.counts.innerMoves
               : dimension == 2 ? result_.counts.faceMoves
                                : result_.counts.edgeMoves);
            isMoved = true;
        }
        return isMoved;
    }

    bool contract(TetId t)
    {
        const TetNodes v = complex_.nodes(t);
        for (const NodeId n : v) {
            if (!evaluateContraction(complex_, n, change_)) continue;
            apply(change_, complex_, geometry_);
            ++result_.counts.contractions;
            return true;
        }
        return false;
    }

    void insert(TetId t)
    {
        if (!insertion_.evaluate(t, leastBetter(complex_.score(t)), target_, change_)) return;
        apply(change_, complex_, geometry_);
        ++result_.counts.insertions;
    }

    /// Elements at its nodes as they are now have been tried.
    void remember(TetId t)
    {
        tried_.resize(complex_.tetLimit(), 0);
        tried_[t] = versionOf(t);
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
    BoundaryGeometry geometry_;
    VertexSmoothing smoothing_;
    VertexInsertion insertion_;
    const ImprovementOptions& options_;
    Budget& budget_;
    RunContext& context_;
    double target_;
    Improvement result_;
    LocalChange best_;
    LocalChange change_;
    IdVector<TetId, std::uint32_t> tried_;
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
