#include "triangulation2d/delaunay_refinement2d.h"

#include "base/backlog_watch.h"
#include "base/bucket_queue.h"
#include "predicates/coordinate_range.h"
#include "triangulation2d/encroachment2d.h"
#include "triangulation2d/refinement_criteria2d.h"
#include "triangulation2d/straight_walk2d.h"
#include "triangulation2d/triangle_shape2d.h"

#include <algorithm>
#include <cmath>
#include <deque>
#include <numbers>

namespace mesher {
namespace {

constexpr double kDegreesPerRadian = 180.0 / std::numbers::pi;
class Refiner
{
public:
    Refiner(const PlanarDomain& domain, const RefinementOptions2d& options, RunContext& context,
            Budget& budget, PlanarTriangulation& triangulation)
        : domain_(domain),
          options_(options),
          context_(context),
          budget_(budget),
          t_(triangulation),
          mesh_(triangulation.mesh()),
          splitter_(domain, triangulation),
          criteria_(domain, options, triangulation),
          hasSizing_(options.sizing.isActive()),
          isWatched_(options.minAngle > RefinementOptions2d{}.minAngle)
    {
    }

    Refinement2d run()
    {
        countMeshed();
        queueLongSubcurves();
        for (;;) {
            ++result_.sweeps;
            if (!queueAllTriangles() && subcurves_.empty()) break;
            processQueues();
            if (isStopped_) break;
        }
        result_.stopReason = isStopped_ ? budget_.stopReason(StopReason::Cancelled) : StopReason::Done;
        result_.splitting = splitter_.counters();
        collectLeft();
        return std::move(result_);
    }

private:
    enum class Attempt
    {
        Inserted,
        Deferred,  ///< subcurves are split first
        Impossible
    };

    // ---- what is to be done --------------------------------------------------------------------------------------

    void queueTriangle(TriangleId t)
    {
        const RefinementVerdict2d verdict = criteria_.judge(t);
        if (verdict.need == RefinementNeed2d::Nothing) return;
        (verdict.need == RefinementNeed2d::Size ? sizeQueue_ : qualityQueue_)
            .push(t, mesh_.triangle(t).generation, verdict.key);
    }

    bool queueAllTriangles()
    {
        for (std::uint32_t i = 0; i < mesh_.triangleSlots(); ++i) {
            const TriangleId t(i);
            if (mesh_.isAlive(t) && t_.isMeshed(t) && !isImpossible(t)) queueTriangle(t);
        }
        return !sizeQueue_.empty() || !qualityQueue_.empty();
    }

    void queueLongSubcurves()
    {
        for (std::uint32_t i = 0; i < t_.boundary.subcurves.size(); ++i) {
            if (t_.boundary.subcurves[SubcurveId(i)].isAlive) queueIfTooLong(SubcurveId(i));
        }
    }

    void queueIfTooLong(SubcurveId s)
    {
        if (criteria_.isTooLong(s)) queueSubcurve(s);
    }

    bool queueSubcurve(SubcurveId s)
    {
        Subcurve& subcurve = t_.boundary.subcurves[s];
        if (subcurve.isRefused) return false;
        if (!subcurve.isQueued) subcurves_.push_back(s);
        subcurve.isQueued = true;
        return true;
    }

    // ---- the loop ------------------------------------------------------------------------------------------------

    void processQueues()
    {
        for (;;) {
            if (!subcurves_.empty()) {
                if (!mayContinue()) return;
                processSubcurve();
                continue;
            }
            const bool isSize = !sizeQueue_.empty();
            auto entry = (isSize ? sizeQueue_ : qualityQueue_).pop();
            if (!entry) return;
            if (!isCurrent(entry->id, entry->generation)) continue;
            const RefinementVerdict2d verdict = criteria_.judge(entry->id);
            if (verdict.need == RefinementNeed2d::Nothing) continue;
            // A generation that has wrapped, or a length scale that has changed since: it queues up again.
            if ((verdict.need == RefinementNeed2d::Size) != isSize || verdict.key != entry->key) {
                queueTriangle(entry->id);
                continue;
            }
            if (!mayContinue()) return;
            if (verdict.need == RefinementNeed2d::Quality && isWatched_) watchBacklog();
            processTriangle(entry->id, verdict.need);
        }
    }

    [[nodiscard]] bool isCurrent(TriangleId t, std::uint16_t generation) const
    {
        return mesh_.isAlive(t) && mesh_.triangle(t).generation == generation && t_.isMeshed(t);
    }

    bool mayContinue()
    {
        constexpr std::uint64_t kOperationsPerReport = 4096;
        if (budget_.operations() % kOperationsPerReport == 0) {
            const double done = static_cast<double>(meshedTriangles_);
            const double open = static_cast<double>(sizeQueue_.size() + qualityQueue_.size());
            context_.reportProgress("refinement", done / (done + 4.0 * open + 1.0));
        }
        isStopped_ = !budget_.allows({mesh_.vertexCount(), meshedTriangles_});
        return !isStopped_;
    }

    /// Gives an angle up that more vertices do not bring nearer.
    void watchBacklog()
    {
        if (!backlog_.isDue(mesh_.vertexCount())) return;
        std::uint64_t bad = 0;
        for (std::uint32_t i = 0; i < mesh_.triangleSlots(); ++i) {
            const TriangleId t(i);
            if (!mesh_.isAlive(t) || !t_.isMeshed(t) || isImpossible(t)) continue;
            if (criteria_.judge(t).need == RefinementNeed2d::Quality) ++bad;
        }
        if (!backlog_.look(mesh_.vertexCount(), bad)) return;
        const double usual = RefinementOptions2d{}.minAngle;
        result_.unreachable = UnreachableAngle2d{usual, bad, meshedTriangles_};
        criteria_.setMinAngle(usual);
        isWatched_ = false;
    }

    void processTriangle(TriangleId t, RefinementNeed2d need)
    {
        switch (attempt(t)) {
            case Attempt::Inserted:
                ++(need == RefinementNeed2d::Size ? result_.sizeInsertions : result_.qualityInsertions);
                break;
            case Attempt::Deferred:
                ++result_.rejectedCircumcenters;
                queueTriangle(t);
                break;
            case Attempt::Impossible: impossible_.insertOrAssign(t, mesh_.triangle(t).generation); break;
        }
    }

    Attempt attempt(TriangleId t)
    {
        const Triangle2d& record = mesh_.triangle(t);
        const Vec2 centre = circumcenter(mesh_.position(record.v[0]), mesh_.position(record.v[1]),
                                         mesh_.position(record.v[2]));
        if (!isInExactRange(centre)) return Attempt::Impossible;
        spared_ = criteria_.smallAngleSpannedBy(t);
        const StraightWalk2d walk = walkStraight(mesh_, t_.delaunay.filterFor(centre), t, centre);
        if (walk.outcome == StraightWalk2d::Outcome::Lost) {
            ++result_.lostWalks;
            return Attempt::Impossible;
        }
        if (walk.outcome == StraightWalk2d::Outcome::Blocked) {
            return queueObstacle(t_.subcurveOf(walk.blocker)) ? Attempt::Deferred : Attempt::Impossible;
        }
        if (walk.location.kind == Location2d::Kind::OnVertex) return Attempt::Impossible;
        if (walk.location.kind == Location2d::Kind::OnEdge && mesh_.isConstrained(walk.location.edge)) {
            return queueObstacle(t_.subcurveOf(walk.location.edge)) ? Attempt::Deferred : Attempt::Impossible;
        }
        t_.delaunay.findCavity(centre, walk.location, cavity_, StarCheck::Trust);
        if (const Attempt outcome = queueEncroached(centre); outcome != Attempt::Inserted) return outcome;
        insert();
        return Attempt::Inserted;
    }

    /// False if the subcurve in the way of an insertion cannot be split, or must not be: a triangle beside a small angle may
    /// not have the angle's own subcurves split, from which a cascade could start.
    bool queueObstacle(SubcurveId s)
    {
        const bool isSpared = spared_.isValid() && t_.boundary.subcurves[s].wedge.isValid();
        return !isSpared && queueSubcurve(s);
    }

    /// Inserted if the cavity's point encroaches on no subcurve.
    Attempt queueEncroached(Vec2 point)
    {
        bool isEncroaching = false;
        bool isQueued = false;
        for (const EdgeLink edge : cavity_.constrained) {
            const VertexId from = mesh_.edgeFrom(edge);
            const VertexId to = mesh_.edgeTo(edge);
            if (!isInDiametralLens(mesh_.position(from), mesh_.position(to), point)) continue;
            isEncroaching = true;
            isQueued = queueObstacle(t_.subcurveOf(from, to)) || isQueued;
        }
        if (!isEncroaching) return Attempt::Inserted;
        return isQueued ? Attempt::Deferred : Attempt::Impossible;
    }

    void insert()
    {
        const double scale = hasSizing_ ? lengthScaleOfCavity(domain_, options_.sizing, mesh_, cavity_) : 0.0;
        const VertexId v = t_.delaunay.commit(cavity_);
        t_.delaunay.setOrigin(v, VertexOrigin::Face, 0);
        meshedTriangles_ += 2;
        if (hasSizing_) assignLengthScale(v, scale);
        for (const Cavity2d::BoundaryEdge& edge : cavity_.boundary) {
            queueTriangle(mesh_.across(edge.outer).triangle());
        }
    }

    /// With a user's field the scale can be lower than the neighbours allow; they are graded again.
    void assignLengthScale(VertexId v, double scale)
    {
        t_.delaunay.setLengthScale(v, scale);
        if (options_.sizing.field == nullptr) return;
        gradeAgainFrom(v, options_.sizing, t_, graded_);
        for (const VertexId w : graded_) queueAround(w);
    }

    // ---- subcurves -----------------------------------------------------------------------------------------------

    void processSubcurve()
    {
        const SubcurveId s = subcurves_.front();
        subcurves_.pop_front();
        // A copy: splitting makes the array grow.
        const Subcurve whole = t_.boundary.subcurves[s];
        if (!whole.isAlive || !whole.isQueued) return;
        const bool isForSize = criteria_.isTooLong(s);
        const SubcurveSplit2d split = splitter_.split(s);
        switch (split.outcome) {
            case SplitOutcome2d::Refused: refuse(s); break;
            case SplitOutcome2d::Blocked: putBlockerFirst(s, split.blocker); break;
            case SplitOutcome2d::Split:
                blockedInTurn_ = 0;
                ++(isForSize ? result_.sizeSplits : result_.encroachmentSplits);
                finishSplit(whole, split);
                break;
        }
    }

    void refuse(SubcurveId s)
    {
        t_.boundary.subcurves[s].isQueued = false;
        t_.boundary.subcurves[s].isRefused = true;
    }

    /// Fig. 2.10: the subcurve in the way is split before.
    void putBlockerFirst(SubcurveId s, SubcurveId blocker)
    {
        constexpr int kLongestChain = 1000;
        Subcurve& other = t_.boundary.subcurves[blocker];
        if (other.isRefused || ++blockedInTurn_ > kLongestChain) {
            refuse(s);
            return;
        }
        subcurves_.push_front(s);
        subcurves_.push_front(blocker);
        other.isQueued = true;
    }

    void finishSplit(const Subcurve& whole, const SubcurveSplit2d& split)
    {
        const VertexId v = t_.boundary.vertices[split.halves.vertex].vertex;
        const PccCurve& curve = domain_.curve(whole.curve);
        meshedTriangles_ += (curve.left.value != 0 ? 1u : 0u) + (curve.right.value != 0 ? 1u : 0u);
        meshedTriangles_ -= 2 * split.removedVertices;
        if (hasSizing_) {
            const double ceiling =
                interpolatedLengthScale(domain_, whole, t_.boundary.vertices[split.halves.vertex].parameter,
                                        mesh_.lengthScale(t_.boundary.vertices[whole.first].vertex),
                                        mesh_.lengthScale(t_.boundary.vertices[whole.last].vertex));
            const double graded = gradedLengthScale(t_, options_.sizing, v);
            const double wanted = wantedSize(domain_, options_.sizing, mesh_.position(v));
            assignLengthScale(v, std::min({ceiling, graded, wanted}));
        }
        queueEncroachedBy(v);
        for (const SubcurveId half : {split.halves.first, split.halves.last}) {
            if (criteria_.isTooLong(half) || isEncroachedByApex(half)) queueSubcurve(half);
        }
        queueAround(v);
        touched_ = splitter_.touchedVertices();
        std::sort(touched_.begin(), touched_.end());
        touched_.erase(std::unique(touched_.begin(), touched_.end()), touched_.end());
        for (const VertexId w : touched_) {
            if (mesh_.isAlive(w)) queueAround(w);
        }
    }

    void queueAround(VertexId v)
    {
        mesh_.forEachTriangleAround(v, [&](EdgeLink opposite) {
            if (t_.isMeshed(opposite.triangle())) queueTriangle(opposite.triangle());
            return true;
        });
    }

    /// Subcurves opposite of a new boundary vertex whose lens it lies in.
    void queueEncroachedBy(VertexId v)
    {
        mesh_.forEachTriangleAround(v, [&](EdgeLink opposite) {
            if (!mesh_.isConstrained(opposite) || !t_.isMeshed(opposite.triangle())) return true;
            const VertexId from = mesh_.edgeFrom(opposite);
            const VertexId to = mesh_.edgeTo(opposite);
            if (isInDiametralLens(mesh_.position(from), mesh_.position(to), mesh_.position(v))) {
                queueSubcurve(t_.subcurveOf(from, to));
            }
            return true;
        });
    }

    [[nodiscard]] bool isEncroachedByApex(SubcurveId s) const
    {
        const EdgeLink left = mesh_.findEdge(t_.firstVertex(s), t_.lastVertex(s));
        for (const EdgeLink side : {left, mesh_.across(left)}) {
            if (!t_.isMeshed(side.triangle())) continue;
            if (isInDiametralLens(t_.boundary.from(s), t_.boundary.to(s), mesh_.position(mesh_.apex(side))))
                return true;
        }
        return false;
    }

    // ---- the end -------------------------------------------------------------------------------------------------

    [[nodiscard]] bool isImpossible(TriangleId t) const
    {
        const std::uint16_t* generation = impossible_.find(t);
        return generation != nullptr && *generation == mesh_.triangle(t).generation;
    }

    void collectLeft()
    {
        for (std::uint32_t i = 0; i < mesh_.triangleSlots(); ++i) {
            const TriangleId t(i);
            if (!mesh_.isAlive(t) || !t_.isMeshed(t)) continue;
            const Triangle2d& record = mesh_.triangle(t);
            const TriangleShape2d shape = TriangleShape2d::of(
                mesh_.position(record.v[0]), mesh_.position(record.v[1]), mesh_.position(record.v[2]));
            LeftTriangle2d left;
            left.triangle = t;
            left.smallAngle = criteria_.smallAngleSpannedBy(record, shape);
            const bool isBad = criteria_.hasSmallAngle(shape);
            if (left.smallAngle.isValid() ? !isBad : criteria_.judge(t).need == RefinementNeed2d::Nothing)
                continue;
            left.reason = left.smallAngle.isValid() ? LeftReason2d::SmallInputAngle
                          : isImpossible(t)         ? LeftReason2d::Resolution
                                                    : LeftReason2d::Unfinished;
            if (left.smallAngle.isValid()) left.inputAngle = inputAngleAt(record, shape, left.smallAngle);
            measureAngles(record, left);
            result_.left.push_back(left);
        }
    }

    /// Between the curves that the ends of the triangle's shortest edge lie on.
    [[nodiscard]] std::uint32_t inputAngleAt(const Triangle2d& record, const TriangleShape2d& shape,
                                             SmallAngleId complex) const
    {
        const auto spokeOf = [&](VertexId v) { return t_.boundary.vertices[t_.boundaryVertexOf(v)].spoke; };
        return t_.smallAngles.complexes[complex].angleBetween(
            spokeOf(record.v[nextCorner(shape.shortestEdge)]),
            spokeOf(record.v[previousCorner(shape.shortestEdge)]));
    }

    void measureAngles(const Triangle2d& record, LeftTriangle2d& left) const
    {
        left.smallestAngle = 180.0;
        for (unsigned i = 0; i < 3; ++i) {
            const Vec2 p = mesh_.position(record.v[i]);
            const Vec2 u = mesh_.position(record.v[nextCorner(i)]) - p;
            const Vec2 w = mesh_.position(record.v[previousCorner(i)]) - p;
            const double angle = std::atan2(cross(u, w), dot(u, w)) * kDegreesPerRadian;
            left.smallestAngle = std::min(left.smallestAngle, angle);
            left.largestAngle = std::max(left.largestAngle, angle);
        }
    }

    void countMeshed()
    {
        for (std::uint32_t i = 0; i < mesh_.triangleSlots(); ++i) {
            if (mesh_.isAlive(TriangleId(i)) && t_.isMeshed(TriangleId(i))) ++meshedTriangles_;
        }
    }

    const PlanarDomain& domain_;
    const RefinementOptions2d& options_;
    RunContext& context_;
    Budget& budget_;
    PlanarTriangulation& t_;
    const Triangulation2d& mesh_;
    SubcurveSplitter2d splitter_;
    RefinementCriteria2d criteria_;
    bool hasSizing_;
    bool isWatched_;  ///< an angle above the default may be out of reach
    BacklogWatch backlog_;

    std::deque<SubcurveId> subcurves_;
    BucketQueue<TriangleId> sizeQueue_;
    BucketQueue<TriangleId> qualityQueue_;
    /// Triangles that cannot be refined, with the generation for which this holds.
    IndexedMap<TriangleId, std::uint16_t> impossible_;
    SmallAngleId spared_;  ///< the small angle that the triangle in hand spans
    int blockedInTurn_ = 0;
    std::uint64_t meshedTriangles_ = 0;
    bool isStopped_ = false;

    Refinement2d result_;
    Cavity2d cavity_;
    std::vector<VertexId> graded_;
    std::vector<VertexId> touched_;
};

}  // namespace

Refinement2d refine(const PlanarDomain& domain, const RefinementOptions2d& options, RunContext& context,
                    Budget& budget, PlanarTriangulation& triangulation)
{
    return Refiner(domain, options, context, budget, triangulation).run();
}

}  // namespace mesher
