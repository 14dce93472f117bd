#include "triangulation2d/delaunay_refinement2d.h"

#include "base/bucket_queue.h"
#include "predicates/coordinate_range.h"
#include "triangulation2d/encroachment2d.h"
#include "triangulation2d/straight_walk2d.h"
#include "triangulation2d/triangle_shape2d.h"

#include <algorithm>
#include <cmath>
#include <deque>
#include <limits>
#include <numbers>

namespace mesher {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kDegreesPerRadian = 180.0 / std::numbers::pi;
/// Thesis section 2.4.3: a triangle is too large if r / LS exceeds sqrt(2) / 2.
constexpr double kSquaredSizeBound = 0.5;
/// A user's size is an edge length: halves of edges above sqrt(2) times it are nearer to it than the whole.
constexpr double kLongestOverWanted = std::numbers::sqrt2;

class Refiner
{
public:
    Refiner(const PlanarDomain& domain, const RefinementOptions2d& options, RunContext& context, Budget& budget,
            PlanarTriangulation& triangulation)
        : domain_(domain), options_(options), context_(context), budget_(budget), t_(triangulation),
          mesh_(triangulation.mesh()), splitter_(domain, triangulation), hasSizing_(options.sizing.isActive()),
          hasField_(options.sizing.field != nullptr)
    {
        const double sine = std::sin(options.minAngle / kDegreesPerRadian);
        // A hair beyond the bound, so that triangles exactly at it are not refined for a rounding error.
        squaredBound_ = options.minAngle > 0.0 ? (1.0 + 1e-12) / (4.0 * sine * sine) : kInfinity;
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
    enum class Need
    {
        Nothing,
        Size,
        Quality
    };

    struct Verdict
    {
        Need need = Need::Nothing;
        double key = 0.0;
    };

    enum class Attempt
    {
        Inserted,
        Deferred,  ///< subcurves are split first
        Impossible
    };

    // ---- what is to be done --------------------------------------------------------------------------------------

    [[nodiscard]] Verdict judge(TriangleId t) const
    {
        const Triangle2d& record = mesh_.triangle(t);
        const Vec2 a = mesh_.position(record.v[0]);
        const Vec2 b = mesh_.position(record.v[1]);
        const Vec2 c = mesh_.position(record.v[2]);
        const TriangleShape2d shape = TriangleShape2d::of(a, b, c);
        Verdict verdict;
        if (hasSizing_) {
            const double mean = (mesh_.lengthScale(record.v[0]) + mesh_.lengthScale(record.v[1]) +
                                 mesh_.lengthScale(record.v[2])) / 3.0;
            double squaredSize = kSquaredSizeBound * mean * mean;
            if (hasField_) squaredSize = std::min(squaredSize, squaredFieldBound(a, b, c, shape, squaredSize));
            if (shape.squaredRadius > squaredSize) verdict = {Need::Size, sizeClass(shape.squaredRadius / squaredSize)};
        }
        if (verdict.need == Need::Nothing && shape.squaredRatio() > squaredBound_) {
            verdict = {Need::Quality, shape.squaredRatio()};
        }
        if (verdict.need != Need::Nothing && smallAngleSpannedBy(record, shape).isValid()) return {};
        return verdict;
    }

    /// Too large by a factor of 1 to 2, 2 to 4, and so on. Finer steps give 2 % fewer triangles, but sweep over the domain
    /// once for each step, which costs a third of the time in cache misses.
    [[nodiscard]] static double sizeClass(double squaredFactor)
    {
        return std::ldexp(1.0, 2 * (std::ilogb(squaredFactor) / 2));
    }

    /// A triangle may hide a small place of the field between its vertices.
    [[nodiscard]] double squaredFieldBound(Vec2 a, Vec2 b, Vec2 c, const TriangleShape2d& shape, double known) const
    {
        if (shape.squaredRadius > known) return known;
        const Vec2 centroid = (1.0 / 3.0) * (a + b + c);
        const double radius = std::sqrt(shape.squaredRadius) / domain_.scale();
        const double near =
            domain_.scale() * options_.sizing.field->smallestNear(domain_.toSpace(centroid), 0.5 * radius);
        return near * near;
    }

    [[nodiscard]] SmallAngleId smallAngleSpannedBy(const Triangle2d& record, const TriangleShape2d& shape) const
    {
        const BoundaryVertexId a = t_.boundaryVertexOf(record.v[nextCorner(shape.shortestEdge)]);
        const BoundaryVertexId b = t_.boundaryVertexOf(record.v[previousCorner(shape.shortestEdge)]);
        if (!a.isValid() || !b.isValid()) return {};
        const BoundaryVertex& first = t_.boundary.vertices[a];
        const BoundaryVertex& last = t_.boundary.vertices[b];
        const bool isOnOneShell =
            first.shell.isValid() && first.shell == last.shell && first.shellRadius == last.shellRadius;
        return isOnOneShell ? first.shell : SmallAngleId();
    }

    void queueTriangle(TriangleId t)
    {
        const Verdict verdict = judge(t);
        if (verdict.need == Need::Nothing) return;
        (verdict.need == Need::Size ? sizeQueue_ : qualityQueue_).push(t, mesh_.triangle(t).generation, verdict.key);
    }

    bool queueAllTriangles()
    {
        for (std::uint32_t i = 0; i < mesh_.triangleSlots(); ++i) {
            const TriangleId t(i);
            if (mesh_.isAlive(t) && t_.isMeshed(t) && !isImpossible(t)) queueTriangle(t);
        }
        return !sizeQueue_.empty() || !qualityQueue_.empty();
    }

    [[nodiscard]] bool isTooLong(SubcurveId s) const
    {
        if (!hasSizing_) return false;
        const double edge = t_.boundary.edgeLength(s);
        if (edge > mesh_.lengthScale(t_.firstVertex(s)) + mesh_.lengthScale(t_.lastVertex(s))) return true;
        if (!hasField_) return false;
        const Vec2 middle = 0.5 * (t_.boundary.from(s) + t_.boundary.to(s));
        const double near = domain_.scale() *
                            options_.sizing.field->smallestNear(domain_.toSpace(middle), 0.25 * edge / domain_.scale());
        return edge > kLongestOverWanted * near;
    }

    void queueLongSubcurves()
    {
        for (std::uint32_t i = 0; i < t_.boundary.subcurves.size(); ++i) {
            if (t_.boundary.subcurves[SubcurveId(i)].isAlive) queueIfTooLong(SubcurveId(i));
        }
    }

    void queueIfTooLong(SubcurveId s)
    {
        if (isTooLong(s)) queueSubcurve(s);
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
            const Verdict verdict = judge(entry->id);
            if (verdict.need == Need::Nothing) continue;
            // A generation that has wrapped, or a length scale that has changed since: it queues up again.
            if ((verdict.need == Need::Size) != isSize || verdict.key != entry->key) {
                queueTriangle(entry->id);
                continue;
            }
            if (!mayContinue()) return;
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

    void processTriangle(TriangleId t, Need need)
    {
        switch (attempt(t)) {
            case Attempt::Inserted:
                ++(need == Need::Size ? result_.sizeInsertions : result_.qualityInsertions);
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
        const Vec2 centre =
            circumcenter(mesh_.position(record.v[0]), mesh_.position(record.v[1]), mesh_.position(record.v[2]));
        if (!isInExactRange(centre)) return Attempt::Impossible;
        const StraightWalk2d walk = walkStraight(mesh_, t_.delaunay.filterFor(centre), t, centre);
        if (walk.outcome == StraightWalk2d::Outcome::Lost) {
            ++result_.lostWalks;
            return Attempt::Impossible;
        }
        if (walk.outcome == StraightWalk2d::Outcome::Blocked) {
            return queueSubcurve(t_.subcurveOf(walk.blocker)) ? Attempt::Deferred : Attempt::Impossible;
        }
        if (walk.location.kind == Location2d::Kind::OnVertex) return Attempt::Impossible;
        if (walk.location.kind == Location2d::Kind::OnEdge && mesh_.isConstrained(walk.location.edge())) {
            return queueSubcurve(t_.subcurveOf(walk.location.edge())) ? Attempt::Deferred : Attempt::Impossible;
        }
        t_.delaunay.findCavity(centre, walk.location, cavity_, StarCheck::Trust);
        if (const Attempt outcome = queueEncroached(centre); outcome != Attempt::Inserted) return outcome;
        insert(centre);
        return Attempt::Inserted;
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
            isQueued = queueSubcurve(t_.subcurveOf(from, to)) || isQueued;
        }
        if (!isEncroaching) return Attempt::Inserted;
        return isQueued ? Attempt::Deferred : Attempt::Impossible;
    }

    void insert(Vec2 point)
    {
        const double scale = hasSizing_ ? lengthScaleFor(point) : 0.0;
        const VertexId v = t_.delaunay.commit(cavity_);
        t_.delaunay.setOrigin(v, VertexOrigin::Face, 0);
        meshedTriangles_ += 2;
        if (hasSizing_) setLengthScale(v, scale);
        for (const Cavity2d::BoundaryEdge& edge : cavity_.boundary) {
            queueTriangle(mesh_.across(edge.outer).triangle());
        }
    }

    // ---- length scales -------------------------------------------------------------------------------------------

    /// Equation 2.1 over the neighbours that the vertex will have, and the user's wish.
    [[nodiscard]] double lengthScaleFor(Vec2 point) const
    {
        const double perDistance = 1.0 / options_.sizing.grading;
        double scale = kInfinity;
        for (const Cavity2d::BoundaryEdge& edge : cavity_.boundary) {
            const VertexId w = mesh_.edgeFrom(edge.outer);
            scale = std::min(scale, mesh_.lengthScale(w) + length(point - mesh_.position(w)) * perDistance);
        }
        return hasField_ ? std::min(scale, wantedSize(domain_, options_.sizing, point)) : scale;
    }

    /// Sets it, and grades the neighbourhood again if it is lower than the neighbours allow.
    void setLengthScale(VertexId v, double scale)
    {
        t_.delaunay.setLengthScale(v, scale);
        if (!hasField_) return;
        graded_.assign(1, v);
        while (!graded_.empty()) {
            const VertexId w = graded_.back();
            graded_.pop_back();
            bool isLowered = false;
            mesh_.forEachTriangleAround(w, [&](EdgeLink opposite) {
                const VertexId neighbour = mesh_.edgeFrom(opposite);
                if (neighbour == kGhostVertex || !t_.isMeshed(opposite.triangle())) return true;
                const double allowed = mesh_.lengthScale(w) +
                                       length(mesh_.position(neighbour) - mesh_.position(w)) / options_.sizing.grading;
                if (mesh_.lengthScale(neighbour) <= allowed * (1.0 + 1e-9)) return true;
                t_.delaunay.setLengthScale(neighbour, allowed);
                graded_.push_back(neighbour);
                isLowered = true;
                return true;
            });
            if (isLowered || w != v) queueAround(w);
        }
    }

    /// Equation 2.1 at a vertex of the mesh.
    [[nodiscard]] double gradedScaleAt(VertexId v) const
    {
        double scale = kInfinity;
        mesh_.forEachTriangleAround(v, [&](EdgeLink opposite) {
            if (!t_.isMeshed(opposite.triangle())) return true;
            for (const VertexId w : {mesh_.edgeFrom(opposite), mesh_.edgeTo(opposite)}) {
                const double distance = length(mesh_.position(w) - mesh_.position(v));
                scale = std::min(scale, mesh_.lengthScale(w) + distance / options_.sizing.grading);
            }
            return true;
        });
        return scale;
    }

    /// The ceiling at a split: between the length scales of the ends, by arc length. Thesis section 2.4.3.
    [[nodiscard]] double interpolatedScale(const Subcurve& whole, double t, double firstScale, double lastScale) const
    {
        const TangentVariation& table = domain_.variation(whole.curve);
        const double before = table.arcLength(whole.part.first, t);
        const double after = table.arcLength(t, whole.part.last);
        return before + after > 0.0 ? (firstScale * after + lastScale * before) / (before + after) : firstScale;
    }

    // ---- subcurves -----------------------------------------------------------------------------------------------

    void processSubcurve()
    {
        const SubcurveId s = subcurves_.front();
        subcurves_.pop_front();
        // A copy: splitting makes the array grow.
        const Subcurve whole = t_.boundary.subcurves[s];
        if (!whole.isAlive || !whole.isQueued) return;
        const bool isForSize = isTooLong(s);
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
            const double first = mesh_.lengthScale(t_.boundary.vertices[whole.first].vertex);
            const double last = mesh_.lengthScale(t_.boundary.vertices[whole.last].vertex);
            const double ceiling =
                interpolatedScale(whole, t_.boundary.vertices[split.halves.vertex].parameter, first, last);
            // The new vertex still has length scale 0, which its own star does not ask for.
            double scale = std::min(ceiling, gradedScaleAt(v));
            if (hasField_) scale = std::min(scale, wantedSize(domain_, options_.sizing, mesh_.position(v)));
            setLengthScale(v, scale);
        }
        queueEncroachedBy(v);
        for (const SubcurveId half : {split.halves.first, split.halves.last}) {
            if (isTooLong(half) || isEncroachedByApex(half)) queueSubcurve(half);
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
            if (isInDiametralLens(t_.boundary.from(s), t_.boundary.to(s), mesh_.position(mesh_.apex(side)))) return true;
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
            left.smallAngle = smallAngleSpannedBy(record, shape);
            const bool isBad = shape.squaredRatio() > squaredBound_;
            if (left.smallAngle.isValid() ? !isBad : judge(t).need == Need::Nothing) continue;
            left.reason = left.smallAngle.isValid() ? LeftReason2d::SmallInputAngle
                          : isImpossible(t)         ? LeftReason2d::Resolution
                                                    : LeftReason2d::Unfinished;
            measureAngles(record, left);
            result_.left.push_back(left);
        }
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
    bool hasSizing_;
    bool hasField_;
    double squaredBound_ = 0.0;

    std::deque<SubcurveId> subcurves_;
    BucketQueue<TriangleId> sizeQueue_;
    BucketQueue<TriangleId> qualityQueue_;
    /// Triangles that cannot be refined, with the generation for which this holds.
    IndexedMap<TriangleId, std::uint16_t> impossible_;
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
