#include "refinement/delaunay_refinement3d.h"

#include "base/bucket_queue.h"
#include "refinement/encroachment3d.h"
#include "refinement/refinement_check.h"

#include <algorithm>
#include <bit>
#include <cmath>

namespace mesher {

namespace {

/// Coordinates below it are taken for zero, so that all of them are on the grid of the exact range.
constexpr double kSmallestCoordinate = 0x1p-147;

Vec3 onGrid(const Vec3& p)
{
    const auto rounded = [](double x) { return std::abs(x) < kSmallestCoordinate ? 0.0 : x; };
    return {rounded(p.x), rounded(p.y), rounded(p.z)};
}

class Refiner
{
public:
    Refiner(ConstrainedTetrahedralization& t, SurfaceSplitter& splitter,
            const DelaunayRefinementOptions3d& options, Budget& budget, RunContext& context)
        : t_(t),
          mesh_(t.mesh()),
          splitter_(splitter),
          options_(options),
          budget_(budget),
          context_(context),
          scale_(t, options.sizing),
          criteria_(mesh_, scale_, options.quality),
          guard_(t, splitter.mesh()),
          boundary_(t, splitter)
    {
    }

    DelaunayRefinement3d run()
    {
        scale_.setInitial();
        countTets();
        insertSinks();
        if (options_.boundary == BoundaryPolicy::Split) {
            queueSegments();
            drain(Phase::Boundary);
            queueFacets();
            drain(Phase::Boundary);
        }
        queueTets();
        drain(Phase::Size);
        drain(Phase::Quality);
        collectLeft();
        result_.counts.boundary = boundary_.counts();
        result_.counts.cavityRepairs = t_.delaunay->counters().cavityRepairs;
        const bool isComplete = result_.left.empty();
        result_.stopReason = budget_.stopReason(isComplete ? StopReason::Done : StopReason::CannotImprove);
        return std::move(result_);
    }

private:
    using Face = std::array<VertexId, 3>;
    using TetEntry = BucketQueue<TetId>::Entry;

    enum class Phase
    {
        Boundary,
        Size,
        Quality
    };

    enum class Attempt
    {
        Inserted,
        Rejected,  ///< something of the boundary was queued: try again when it is split
        Impossible
    };

    // ---- the run

    bool mayGoOn()
    {
        constexpr std::uint64_t kOperationsPerReport = 512;
        const std::uint64_t done = budget_.operations();
        if (done % kOperationsPerReport == 0) {
            const std::size_t waiting =
                segments_.size() + facets_.size() + sizes_.size() + qualities_.size() + sinks_.size();
            const auto total = static_cast<double>(done) + static_cast<double>(waiting) + 1.0;
            progress_ = std::max(progress_, 0.99 * static_cast<double>(done) / total);
            if (!context_.reportProgress("refinement", progress_)) context_.requestCancel();
        }
        if (!budget_.allows({mesh_.vertexCount(), meshedTets()})) return false;
        if (context_.checkLevel() == CheckLevel::Full && std::has_single_bit(budget_.operations())) {
            MESHER_INVARIANT(checkRefinement(t_, splitter_.mesh()).isValid());
        }
        return true;
    }

    void drain(Phase phase)
    {
        while (!isStopped_) {
            if (!segments_.empty() || !facets_.empty()) {
                if (!mayGoOn()) return stop();
                if (!segments_.empty()) {
                    takeSegment();
                } else {
                    takeFacet();
                }
                continue;
            }
            if (phase == Phase::Boundary) return;
            if (takeTet(sizes_, TetNeed::Size)) continue;
            if (phase == Phase::Size || !takeTet(qualities_, TetNeed::Quality)) return;
        }
    }

    void stop() { isStopped_ = true; }

    [[nodiscard]] bool isMeshed(TetId tet) const
    {
        return mesh_.isAlive(tet) && mesh_.region(tet) != kExteriorRegion && !mesh_.isGhostTet(tet);
    }

    /// Those outside of all solids hardly change in number.
    [[nodiscard]] std::uint64_t meshedTets() const { return mesh_.tetCount() - exteriorTets_; }

    void countTets()
    {
        exteriorTets_ = mesh_.tetCount();
        for (std::uint32_t i = 0; i < mesh_.tetLimit(); ++i) exteriorTets_ -= isMeshed(TetId(i)) ? 1u : 0u;
    }

    // ---- tetrahedra

    void queueTet(TetId tet)
    {
        const TetVerdict verdict = criteria_.judge(tet);
        if (verdict.need == TetNeed::Nothing) return;
        if (isSinkPhase_) {
            if (criteria_.isSink(tet)) sinks_.push(tet, mesh_.generation(tet), verdict.key);
            return;
        }
        BucketQueue<TetId>& queue = verdict.need == TetNeed::Size ? sizes_ : qualities_;
        queue.push(tet, mesh_.generation(tet), verdict.key);
    }

    void queueTets()
    {
        for (std::uint32_t i = 0; i < mesh_.tetLimit(); ++i) {
            if (isMeshed(TetId(i))) queueTet(TetId(i));
        }
    }

    void insertSinks()
    {
        isSinkPhase_ = true;
        queueTets();
        while (!isStopped_) {
            const std::optional<TetEntry> entry = sinks_.popCurrent(
                [&](const TetEntry& e) { return mesh_.generation(e.id) == e.generation && isMeshed(e.id); });
            if (!entry) break;
            if (!mayGoOn()) {
                stop();
                break;
            }
            if (attempt(entry->id) == Attempt::Inserted) ++result_.counts.sinkInsertions;
        }
        sinks_.clear();
        isSinkPhase_ = false;
    }

    /// False when the queue has nothing more.
    bool takeTet(BucketQueue<TetId>& queue, TetNeed need)
    {
        const std::optional<TetEntry> entry = queue.popCurrent([&](const TetEntry& e) {
            if (mesh_.generation(e.id) != e.generation || !isMeshed(e.id)) return false;
            const TetVerdict verdict = criteria_.judge(e.id);
            return verdict.need == need && verdict.key == e.key;
        });
        if (!entry) return false;
        if (!mayGoOn()) {
            stop();
            return true;
        }
        switch (attempt(entry->id)) {
            case Attempt::Inserted:
                ++(need == TetNeed::Size ? result_.counts.sizeInsertions : result_.counts.qualityInsertions);
                break;
            case Attempt::Rejected: queue.push(entry->id, entry->generation, entry->key); break;
            case Attempt::Impossible: break;
        }
        return true;
    }

    Attempt attemptAt(TetId tet, const Vec3& point)
    {
        const Cavity3d& conflicts = t_.delaunay->findConflicts(point, tet);
        const Encroached3d encroached = findEncroached(mesh_, conflicts, t_.delaunay->filter());
        if (encroached.segment[0].isValid() || encroached.facet.isValid()) return reject(tet, encroached);
        if (encroached.hasFacetBehind) {
            const TetFace blocking = firstConstraintTowards(mesh_, tet, point, t_.delaunay->filter());
            if (blocking.isValid()) return reject(tet, {{}, blocking, true});
        }
        const RegionId region = mesh_.region(tet);
        const Cavity3d& cavity = t_.delaunay->makeStarShaped();
        if (cavity.status != CavityStatus::Ready) {
            ++result_.counts.abortedInsertions;
            return Attempt::Impossible;
        }
        insert(region);
        return Attempt::Inserted;
    }

    /// The circumcentre of the tetrahedron; where that is lost in rounding, of its largest face, which is in conflict too.
    Attempt attempt(TetId tet)
    {
        const std::optional<Vec3> centre = criteria_.circumcentre(tet);
        const Attempt first = centre ? attemptAt(tet, onGrid(*centre)) : Attempt::Impossible;
        if (first != Attempt::Impossible || isSinkPhase_) return first;
        if (!criteria_.isNearlyFlat(tet)) return centre ? insertShortOf(tet, *centre) : first;
        const std::optional<Vec3> ofFace = criteria_.centreOfLargestFace(tet);
        if (!ofFace) return Attempt::Impossible;
        ++result_.counts.flatTets;
        return attemptAt(tet, onGrid(*ofFace));
    }

    /// Where the boundary cannot be split: the circumcentre all the same, or a vertex halfway to the facet before it, if
    /// that leaves room around it.
    Attempt insertShortOf(TetId tet, const Vec3& centre)
    {
        const TetFace blocking = firstConstraintTowards(mesh_, tet, centre, t_.delaunay->filter());
        Vec3 point = centre;
        if (blocking.isValid()) {
            Vec3 start;
            for (const VertexId v : mesh_.tet(tet).vertex) start = start + 0.25 * mesh_.position(v);
            point = start + 0.5 * crossingOf(blocking, start, centre) * (centre - start);
        }
        if (!isFinite(point)) return Attempt::Impossible;
        const RegionId region = mesh_.region(tet);
        t_.delaunay->findConflicts(onGrid(point), tet);
        const Cavity3d& cavity = t_.delaunay->makeStarShaped();
        if (cavity.status != CavityStatus::Ready || !hasRoom(cavity, tet)) return Attempt::Impossible;
        ++result_.counts.shortInsertions;
        insert(region);
        return Attempt::Inserted;
    }

    /// Where the line from `start` (0) to `end` (1) meets the plane of a face.
    [[nodiscard]] double crossingOf(TetFace face, const Vec3& start, const Vec3& end) const
    {
        const auto [a, b, c] = mesh_.faceVertices(face);
        const Vec3& origin = mesh_.position(a);
        const Vec3 normal = cross(mesh_.position(b) - origin, mesh_.position(c) - origin);
        return dot(origin - start, normal) / dot(end - start, normal);
    }

    /// Whether all of the cavity's surface that counts keeps a part of the length scale away.
    [[nodiscard]] bool hasRoom(const Cavity3d& cavity, TetId tet) const
    {
        constexpr double kLeastShare = 0.4;
        double room = 0.0;
        for (const VertexId v : mesh_.tet(tet).vertex) room += 0.25 * kLeastShare * scale_.guard(v);
        for (const CavityFace3d& face : cavity.faces) {
            for (const VertexId v : face.vertex) {
                if (length(mesh_.position(v) - cavity.point) < room) return false;
            }
        }
        return std::all_of(
            cavity.constrainedFaces.begin(), cavity.constrainedFaces.end(), [&](TetFace outer) {
                const auto [a, b, c] = mesh_.faceVertices(mesh_.neighbour(outer));
                const Vec3& origin = mesh_.position(a);
                const Vec3 normal = cross(mesh_.position(b) - origin, mesh_.position(c) - origin);
                return dot(cavity.point - origin, normal) >= 0.5 * room * length(normal);
            });
    }

    void insert(RegionId region)
    {
        VertexClass classification;
        classification.entity = (region.value - 1) & VertexClass::kNoEntity;
        const VertexId v = t_.delaunay->commit(classification).vertex;
        if (t_.nodeOf.size() <= v.value) t_.nodeOf.resize(v.value + v.value / 4u + 16u);
        t_.nodeOf[v] = NodeId();
        const bool isLow = scale_.assign(v, t_.delaunay->neighboursOfCommitted());
        const auto star = t_.delaunay->created();
        for (const TetId created : star) queueTet(created);
        if (isLow) gradeAround(v);
    }

    void gradeAround(VertexId v)
    {
        scale_.gradeAgainFrom(v, lowered_);
        for (const VertexId w : lowered_) queueStar(w);
    }

    void queueStar(VertexId v)
    {
        mesh_.collectStar(v, star_);
        for (const TetId tet : star_) {
            if (isMeshed(tet)) queueTet(tet);
        }
    }

    // ---- encroachment

    Attempt reject(TetId tet, const Encroached3d& encroached)
    {
        if (isSinkPhase_) return Attempt::Impossible;
        ++result_.counts.rejectedCentres;
        if (encroached.segment[0].isValid() && !wouldShrink(tet, encroached.segment)) {
            const SegmentId* segment =
                t_.segmentOf.find(unorderedPair(encroached.segment[0], encroached.segment[1]));
            if (segment != nullptr && pushSegment(*segment)) return Attempt::Rejected;
        }
        const bool mayPush =
            encroached.facet.isValid() && !wouldShrink(tet, mesh_.faceVertices(encroached.facet));
        if (mayPush && pushFacetAt(encroached.facet)) return Attempt::Rejected;
        return Attempt::Impossible;
    }

    /// Beside a small angle of the input a bad tetrahedron must not make edges shorter than its own, or they would get
    /// shorter and shorter.
    template <std::size_t N>
    bool wouldShrink(TetId tet, const std::array<VertexId, N>& entity)
    {
        if (!guard_.hasAny() || criteria_.judge(tet).need != TetNeed::Quality) return false;
        if (!isBesideSmallAngle(entity)) return false;
        double longest = 0.0;
        for (std::size_t i = 0; i < N; ++i) {
            longest = std::max(
                longest, squaredLength(mesh_.position(entity[(i + 1) % N]) - mesh_.position(entity[i])));
        }
        if (0.25 * longest >= shortestSquaredEdge(tet)) return false;
        ++result_.counts.guardedSplits;
        return true;
    }

    /// Whether the entity has a vertex on a small angle: there the two sides of the angle always encroach upon each other.
    template <std::size_t N>
    [[nodiscard]] bool isBesideSmallAngle(const std::array<VertexId, N>& entity) const
    {
        return guard_.hasAny() && std::any_of(entity.begin(), entity.end(), [&](VertexId v) {
                   const NodeId node = t_.nodeOf[v];
                   return node.isValid() && guard_.isSmallAt(splitter_.mesh().nodes[node].entity);
               });
    }

    [[nodiscard]] double shortestSquaredEdge(TetId tet) const
    {
        const auto& v = mesh_.tet(tet).vertex;
        double shortest = squaredLength(mesh_.position(v[1]) - mesh_.position(v[0]));
        for (const auto& [from, to] : kEdgeSlots) {
            shortest = std::min(shortest, squaredLength(mesh_.position(v[static_cast<unsigned>(to)]) -
                                                        mesh_.position(v[static_cast<unsigned>(from)])));
        }
        return shortest;
    }

    bool pushFacetAt(TetFace face)
    {
        Face corners = mesh_.faceVertices(face);
        std::sort(corners.begin(), corners.end());
        const FacetId* facet = t_.facetOf.find(corners);
        return facet != nullptr && pushFacet(*facet);
    }

    /// Whether the segment waits for its split now.
    bool pushSegment(SegmentId segment)
    {
        if (options_.boundary == BoundaryPolicy::Frozen || isRefused(refusedSegments_, segment.value))
            return false;
        const auto& ends = splitter_.mesh().segments[segment].node;
        const Vec3 along = mesh_.position(t_.vertexOf[ends[1]]) - mesh_.position(t_.vertexOf[ends[0]]);
        segments_.push(segment, 0, length(along) / t_.scale);
        return true;
    }

    bool pushFacet(FacetId facet)
    {
        if (options_.boundary == BoundaryPolicy::Frozen || isRefused(refusedFacets_, facet.value))
            return false;
        const std::optional<ProtectingBall> ball = ballOf(facet);
        if (!ball) return false;
        facets_.push(facet, 0, std::sqrt(ball->squaredRadius) / t_.scale);
        return true;
    }

    [[nodiscard]] Face cornersOf(FacetId facet) const
    {
        const auto& node = splitter_.mesh().facets[facet].node;
        return {t_.vertexOf[node[0]], t_.vertexOf[node[1]], t_.vertexOf[node[2]]};
    }

    [[nodiscard]] std::optional<ProtectingBall> ballOf(FacetId facet) const
    {
        const Face corner = cornersOf(facet);
        return ProtectingBall::ofFacet(mesh_.position(corner[0]), mesh_.position(corner[1]),
                                       mesh_.position(corner[2]));
    }

    static bool isRefused(const std::vector<char>& refused, std::uint32_t id)
    {
        return id < refused.size() && refused[id] != 0;
    }

    static void refuse(std::vector<char>& refused, std::uint32_t id)
    {
        if (refused.size() <= id) refused.resize(id + id / 2 + 16, 0);
        refused[id] = 1;
    }

    /// Queues what the tetrahedron's own vertices encroach upon.
    void queueEncroachedAt(TetId tet)
    {
        if (!isMeshed(tet) || (mesh_.flags(tet) & tet_flag::kConstraints) == 0) return;
        for (int face = 0; face < 4; ++face) {
            if (!mesh_.isFaceConstrained({tet, face})) continue;
            const auto [a, b, c] = mesh_.faceVertices({tet, face});
            const auto ball =
                ProtectingBall::ofFacet(mesh_.position(a), mesh_.position(b), mesh_.position(c));
            if (!ball || !ball->contains(mesh_.position(mesh_.vertex(tet, face)))) continue;
            if (!isBesideSmallAngle(std::array{a, b, c})) pushFacetAt({tet, face});
        }
        for (int edge = 0; edge < 6; ++edge) {
            if (!mesh_.isEdgeConstrained(tet, edge)) continue;
            const VertexId a = mesh_.vertex(tet, kEdgeSlots[edge][0]);
            const VertexId b = mesh_.vertex(tet, kEdgeSlots[edge][1]);
            const ProtectingBall ball = ProtectingBall::ofSegment(mesh_.position(a), mesh_.position(b));
            const bool isEncroached =
                std::any_of(mesh_.tet(tet).vertex.begin(), mesh_.tet(tet).vertex.end(),
                            [&](VertexId v) { return v != a && v != b && ball.contains(mesh_.position(v)); });
            const SegmentId* segment = isEncroached ? t_.segmentOf.find(unorderedPair(a, b)) : nullptr;
            if (segment != nullptr) pushSegment(*segment);
        }
    }

    // ---- segments and facets

    void queueSegments()
    {
        const SurfaceMesh& surface = splitter_.mesh();
        for (std::uint32_t i = 0; i < surface.segments.size(); ++i) {
            if (surface.segments[SegmentId(i)].isAlive() && isTooLong(SegmentId(i)))
                pushSegment(SegmentId(i));
        }
        for (std::uint32_t i = 0; i < mesh_.tetLimit(); ++i) {
            if ((mesh_.flags(TetId(i)) & tet_flag::kEdges) != 0) queueEncroachedAt(TetId(i));
        }
        facets_.clear();
    }

    void queueFacets()
    {
        const SurfaceMesh& surface = splitter_.mesh();
        for (std::uint32_t i = 0; i < surface.facets.size(); ++i) {
            if (surface.facets[FacetId(i)].isAlive() && criteria_.isTooLarge(cornersOf(FacetId(i))))
                pushFacet(FacetId(i));
        }
        for (std::uint32_t i = 0; i < mesh_.tetLimit(); ++i) queueEncroachedAt(TetId(i));
    }

    [[nodiscard]] bool isTooLong(SegmentId segment) const
    {
        const auto& ends = splitter_.mesh().segments[segment].node;
        return criteria_.isTooLong(t_.vertexOf[ends[0]], t_.vertexOf[ends[1]]);
    }

    void takeSegment()
    {
        const SegmentId segment = segments_.pop()->id;
        const SurfaceSegment whole = splitter_.mesh().segments[segment];
        if (!whole.isAlive() || isRefused(refusedSegments_, segment.value)) return;
        const VertexId a = t_.vertexOf[whole.node[0]];
        const VertexId b = t_.vertexOf[whole.node[1]];
        const bool isAllowed = (criteria_.isTooLong(a, b) || criteria_.maySplit(a, b)) &&
                               length(mesh_.position(b) - mesh_.position(a)) > 2.0 * floor();
        if (isAllowed) {
            const BoundarySplit3d split = boundary_.splitSegment(segment);
            if (split.outcome == SplitOutcome3d::Split) {
                ++result_.counts.segmentSplits;
                finishSplit(split);
                return;
            }
        }
        refuse(refusedSegments_, segment.value);
        ++result_.counts.refusedSegments;
    }

    void takeFacet()
    {
        const FacetId facet = facets_.pop()->id;
        if (!splitter_.mesh().facets[facet].isAlive() || isRefused(refusedFacets_, facet.value)) return;
        const Face corners = cornersOf(facet);
        const std::optional<ProtectingBall> ball = ballOf(facet);
        const bool isAllowed = ball && (criteria_.isTooLarge(corners) || criteria_.maySplit(corners)) &&
                               ball->squaredRadius > floor() * floor();
        if (isAllowed && trySplit(facet)) return;
        refuse(refusedFacets_, facet.value);
        ++result_.counts.refusedFacets;
    }

    /// False if nothing can be done for it.
    bool trySplit(FacetId facet)
    {
        const auto mayEncroach = [&](SegmentId s) { return isRefused(refusedSegments_, s.value); };
        const BoundarySplit3d split = boundary_.splitFacet(facet, mayEncroach);
        switch (split.outcome) {
            case SplitOutcome3d::Split:
                ++result_.counts.facetSplits;
                finishSplit(split);
                return true;
            case SplitOutcome3d::EncroachesSegment:
                // The facet comes again, if it is still there.
                return pushSegment(split.encroached) && pushFacet(facet);
            case SplitOutcome3d::TooSmall: return false;
            case SplitOutcome3d::NotFound:
            case SplitOutcome3d::NotStarShaped: return splitLongestSide(facet);
        }
        return false;
    }

    /// The segment that is its longest side, or the facet behind that side, in the place of the facet.
    bool splitLongestSide(FacetId facet)
    {
        const Face corner = cornersOf(facet);
        unsigned longest = 0;
        const auto squaredSide = [&](unsigned k) {
            return squaredLength(mesh_.position(corner[(k + 1) % 3]) - mesh_.position(corner[k]));
        };
        for (unsigned k = 1; k < 3; ++k) {
            if (squaredSide(k) > squaredSide(longest)) longest = k;
        }
        const VertexId from = corner[longest];
        const VertexId to = corner[(longest + 1) % 3];
        // Once only, or two facets could wait for each other.
        if (isRefused(deferredFacets_, facet.value)) return false;
        refuse(deferredFacets_, facet.value);
        const SegmentId* segment = t_.segmentOf.find(unorderedPair(from, to));
        const bool isWaiting =
            segment != nullptr ? pushSegment(*segment) : pushFacet(facetBehind(facet, from, to));
        if (!isWaiting) return false;
        ++result_.counts.neighbourSplits;
        return pushFacet(facet);
    }

    /// The other facet at a side, which is no segment; invalid if there is none.
    [[nodiscard]] FacetId facetBehind(FacetId facet, VertexId from, VertexId to)
    {
        const TetId at = mesh_.findEdge(from, to);
        if (!at.isValid()) return {};
        mesh_.collectEdgeRing(at, from, to, star_);
        for (const TetId tet : star_) {
            for (int face = 0; face < 4; ++face) {
                if (!mesh_.isFaceConstrained({tet, face})) continue;
                Face corners = mesh_.faceVertices({tet, face});
                std::sort(corners.begin(), corners.end());
                const FacetId* other = t_.facetOf.find(corners);
                const bool isAtSide = std::count(corners.begin(), corners.end(), from) +
                                          std::count(corners.begin(), corners.end(), to) ==
                                      2;
                if (isAtSide && other != nullptr && *other != facet) return *other;
            }
        }
        return {};
    }

    void finishSplit(const BoundarySplit3d& split)
    {
        const VertexId v = split.vertex;
        const bool isLow = scale_.assign(v, t_.delaunay->neighboursOfCommitted(), ceilingAt(split));
        const SurfaceSplitResult& made = boundary_.made();
        for (const SegmentId half : made.halves) {
            if (half.isValid() && isTooLong(half)) pushSegment(half);
        }
        for (const FacetId facet : made.added) {
            if (criteria_.isTooLarge(cornersOf(facet))) pushFacet(facet);
        }
        for (const TetId tet : boundary_.created()) {
            if (!isMeshed(tet)) continue;
            queueEncroachedAt(tet);
            queueTet(tet);
        }
        if (isLow) gradeAround(v);
    }

    /// Mean of the scales of the vertices around, weighted by the inverse of their distance (thesis section 4.4). Between
    /// the ends of a segment that is linear interpolation.
    [[nodiscard]] double ceilingAt(const BoundarySplit3d& split) const
    {
        double weights = 0.0;
        double sizes = 0.0;
        for (const VertexId w : split.surround) {
            const double weight = 1.0 / length(mesh_.position(w) - mesh_.position(split.vertex));
            weights += weight;
            sizes += weight * scale_.size(w);
        }
        return sizes / weights;
    }

    [[nodiscard]] double floor() const { return options_.floor * t_.scale; }

    // ---- the end

    void collectLeft()
    {
        guard_.collectPlaces(splitter_.mesh());
        for (std::uint32_t i = 0; i < mesh_.tetLimit(); ++i) {
            const TetId tet(i);
            if (!isMeshed(tet)) continue;
            const TetVerdict verdict = criteria_.judge(tet);
            if (verdict.need == TetNeed::Nothing && !criteria_.isBad(tet)) continue;
            result_.left.push_back(explain(tet, verdict));
        }
    }

    LeftTet3d explain(TetId tet, const TetVerdict& verdict)
    {
        LeftTet3d left;
        left.tet = tet;
        left.reason = LeftReason3d::Unfinished;
        if (isStopped_) return left;
        left.angle = blameFor(tet);
        if (left.angle) {
            left.reason = LeftReason3d::SmallInputAngle;
        } else if (verdict.need == TetNeed::Nothing) {
            left.reason = LeftReason3d::LengthScale;
        } else {
            left.entity = boundaryInTheWay(tet);
            left.reason =
                left.entity.index != EntityRef::kNone ? LeftReason3d::Boundary : LeftReason3d::Resolution;
        }
        return left;
    }

    [[nodiscard]] std::optional<SmallInputAngle> blameFor(TetId tet) const
    {
        constexpr double kReach = 2.0;  // in length scales
        Vec3 centroid;
        double scale = 0.0;
        for (const VertexId v : mesh_.tet(tet).vertex) {
            centroid = centroid + 0.25 * mesh_.position(v);
            scale += 0.25 * scale_.guard(v);
        }
        return guard_.blameFor((1.0 / t_.scale) * centroid, kReach * scale / t_.scale);
    }

    [[nodiscard]] EntityRef boundaryInTheWay(TetId tet)
    {
        const std::optional<Vec3> centre = criteria_.circumcentre(tet);
        if (!centre) return {};
        const Cavity3d& conflicts = t_.delaunay->findConflicts(onGrid(*centre), tet);
        const Encroached3d encroached = findEncroached(mesh_, conflicts, t_.delaunay->filter());
        if (encroached.segment[0].isValid()) {
            const SegmentId* segment =
                t_.segmentOf.find(unorderedPair(encroached.segment[0], encroached.segment[1]));
            if (segment != nullptr) return {1, splitter_.mesh().segments[*segment].edge.value};
        }
        TetFace face = encroached.facet;
        if (!face.isValid())
            face = firstConstraintTowards(mesh_, tet, onGrid(*centre), t_.delaunay->filter());
        if (!face.isValid()) return {};
        Face corners = mesh_.faceVertices(face);
        std::sort(corners.begin(), corners.end());
        const FacetId* facet = t_.facetOf.find(corners);
        return facet == nullptr ? EntityRef{} : EntityRef{2, splitter_.mesh().facets[*facet].face.value};
    }

    ConstrainedTetrahedralization& t_;
    Triangulation3d& mesh_;
    SurfaceSplitter& splitter_;
    const DelaunayRefinementOptions3d& options_;
    Budget& budget_;
    RunContext& context_;
    LengthScale3d scale_;
    RefinementCriteria3d criteria_;
    SmallAngleGuard guard_;
    BoundarySplitter3d boundary_;

    BucketQueue<SegmentId> segments_;
    BucketQueue<FacetId> facets_;
    BucketQueue<TetId> sinks_;
    BucketQueue<TetId> sizes_;
    BucketQueue<TetId> qualities_;
    std::vector<char> refusedSegments_;
    std::vector<char> refusedFacets_;
    std::vector<char> deferredFacets_;  ///< that have waited for a neighbour
    std::vector<VertexId> lowered_;
    std::vector<TetId> star_;
    std::uint32_t exteriorTets_ = 0;  ///< at the start, ghosts included
    double progress_ = 0.0;
    bool isSinkPhase_ = false;
    bool isStopped_ = false;
    DelaunayRefinement3d result_;
};

}  // namespace

DelaunayRefinement3d refineDelaunay3d(ConstrainedTetrahedralization& tetrahedralization,
                                      SurfaceSplitter& splitter, const DelaunayRefinementOptions3d& options,
                                      Budget& budget, RunContext& context)
{
    return Refiner(tetrahedralization, splitter, options, budget, context).run();
}

}  // namespace mesher
