#include "surface_sampling/face_refinement.h"

#include "surface_sampling/apex_rings.h"
#include "surface_sampling/face_folds.h"
#include "surface_sampling/face_points.h"
#include "surface_sampling/face_seeds.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

namespace mesher {

namespace {

// Relative to the outline's size: no side below is split.
constexpr double kFloorShare = 2e-4;
// Sides along which the surface turns by less are straight, as 1 - cos.
constexpr double kSlightTurn = 1e-4;

struct QueuedTriangle
{
    TriangleId triangle;
    std::uint16_t generation = 0;
};

/// How a lifted triangle departs from the surface.
struct Departure
{
    bool isBad = false;
    bool isInside = false;         ///< only the surface in the middle departs, the sides lie well
    std::array<double, 3> turn{};  ///< of the surface along each side: sum of 1 - cos of the halves
};

class Follower
{
public:
    Follower(const BrepFace& face, const FaceOutline& outline, const CurveChains& chains,
             const InitialFaceMeshOptions& options, FaceTriangulation& t)
        : face_(face), outline_(outline), chains_(chains), options_(options), t_(t)
    {
        cosine_ = std::cos(options.maxNormalDeviation * std::numbers::pi / 180.0);
        floor_ = std::max(kFloorShare * t.size, 10.0 * face.tolerance);
        edgesAt_.resize(t.mesh().vertexSlots());
        for (const auto& [ends, index] : t.pieceOf) {
            const SegmentId segment = outline.pieces[index].segment;
            if (!segment.isValid()) continue;
            edgesAt_[ends.first].push_back(chains.segments()[segment].edge);
            edgesAt_[ends.second].push_back(chains.segments()[segment].edge);
        }
    }

    FaceRefinement run()
    {
        // What is wrong with the chains comes first: points inside of the face cannot mend it.
        for (std::uint32_t i = 0; i < t_.mesh().triangleSlots(); ++i) enqueue(TriangleId(i));
        const std::size_t count = queue_.size();
        while (next_ < count) improve(queue_[next_++].triangle);
        phase_ = t_.tooCoarse.empty() ? Phase::Points : Phase::Named;
        while (next_ < queue_.size()) {
            const QueuedTriangle entry = queue_[next_++];
            const Triangle2d& triangle = t_.mesh().triangle(entry.triangle);
            if (!t_.mesh().isAlive(entry.triangle) || triangle.generation != entry.generation) continue;
            if (result_.insertions >= options_.maxPointsPerFace) {
                result_.isComplete = false;
                break;
            }
            improve(entry.triangle);
        }
        std::sort(t_.tooCoarse.begin(), t_.tooCoarse.end());
        t_.tooCoarse.erase(std::unique(t_.tooCoarse.begin(), t_.tooCoarse.end()), t_.tooCoarse.end());
        if (!t_.tooCoarse.empty()) result_.isComplete = true;
        return result_;
    }

private:
    enum class Phase
    {
        Chains,  ///< segments are named, what takes points is left for later
        Points,
        Named  ///< segments were named after points had been inserted: the face is begun anew with finer chains
    };

    /// A triangle that takes points has to wait until the chains are well.
    void postpone(TriangleId t)
    {
        if (phase_ == Phase::Chains) enqueue(t);
    }

    void enqueue(TriangleId t)
    {
        if (t_.mesh().isAlive(t) && t_.isInside(t)) queue_.push_back({t, t_.mesh().triangle(t).generation});
    }

    [[nodiscard]] const FacePoint& corner(TriangleId t, unsigned i) const
    {
        return t_.points[t_.mesh().triangle(t).v[i]];
    }

    /// Triangles with two corners in a pole or a node vanish in space.
    [[nodiscard]] bool vanishes(TriangleId t) const
    {
        for (unsigned i = 0; i < 3; ++i) {
            const FacePoint &a = corner(t, i), &b = corner(t, nextCorner(i));
            if (a.isPole && b.isPole && a.node == b.node) return true;
        }
        return false;
    }

    [[nodiscard]] Departure departureOf(TriangleId t) const
    {
        Departure departure;
        const std::array<const FacePoint*, 3> p{&corner(t, 0), &corner(t, 1), &corner(t, 2)};
        const Vec3 facet = cross(p[1]->position - p[0]->position, p[2]->position - p[0]->position);
        const double limit = cosine_ * length(facet);
        bool isSideBad = !(squaredLength(facet) > 0.0);
        const auto departs = [&](const Vec3& normal) {
            return dot(facet, normal) < limit && normal != Vec3{};
        };
        for (unsigned i = 0; i < 3; ++i) {
            const FacePoint &a = *p[nextCorner(i)], &b = *p[previousCorner(i)];
            const Vec3 middle = normalAt(liftedMiddleOf(a, b));
            isSideBad = isSideBad || departs(p[i]->normal) || departs(middle);
            if (middle == Vec3{}) continue;
            if (a.normal != Vec3{}) departure.turn[i] += 1.0 - dot(a.normal, middle);
            if (b.normal != Vec3{}) departure.turn[i] += 1.0 - dot(b.normal, middle);
        }
        departure.isInside = !isSideBad && departs(normalAt(centreOf(t)));
        departure.isBad = isSideBad || departure.isInside;
        return departure;
    }

    [[nodiscard]] Vec3 normalAt(Vec2 uv) const
    {
        return FaceTriangulation::unitNormal(face_.surface->evaluate(uv));
    }
    [[nodiscard]] Vec2 centreOf(TriangleId t) const
    {
        return 1.0 / 3.0 * (corner(t, 0).uv + corner(t, 1).uv + corner(t, 2).uv);
    }

    void improve(TriangleId t)
    {
        if (vanishes(t)) return;
        if (nameNarrowSide(t)) return;
        const Departure departure = departureOf(t);
        if (!departure.isBad) return;
        const bool isAtPole = corner(t, 0).isPole || corner(t, 1).isPole || corner(t, 2).isPole;
        const bool isNarrow = isWithinTolerance(face_, {&corner(t, 0), &corner(t, 1), &corner(t, 2)});
        if (isNarrow && !isAtPole) return leave();
        if (phase_ != Phase::Points && (isAtPole || departure.isInside)) return postpone(t);
        if (ringPole(t)) return;
        if (levelPole(t)) {
            // It may not be one of the triangles that the new image changed.
            enqueue(t);
            return;
        }
        if (isNarrow) return leave();
        if (departure.isInside && insertAt(centreOf(t), t)) return;
        std::array<unsigned, 3> sides{0, 1, 2};
        const double most = *std::max_element(departure.turn.begin(), departure.turn.end());
        std::stable_sort(sides.begin(), sides.end(), [&](unsigned a, unsigned b) {
            // Along a meridian of a pole there is nothing to be gained by further points of the meridian.
            if (endsInPole(t, a) != endsInPole(t, b)) return endsInPole(t, a);
            return most > kSlightTurn && !endsInPole(t, a) ? departure.turn[a] > departure.turn[b]
                                                           : sideLength(t, a) > sideLength(t, b);
        });
        for (const unsigned side : sides) {
            const bool isPiece = t_.mesh().isConstrained(EdgeLink(t, side));
            if (!isPiece && phase_ != Phase::Points) return postpone(t);
            if (splitSide(EdgeLink(t, side))) return;
        }
        leave();
    }

    void leave() { ++result_.givenUp; }

    [[nodiscard]] bool endsInPole(TriangleId t, unsigned i) const
    {
        return corner(t, nextCorner(i)).isPole || corner(t, previousCorner(i)).isPole;
    }

    [[nodiscard]] double sideLength(TriangleId t, unsigned i) const
    {
        return length(corner(t, nextCorner(i)).position - corner(t, previousCorner(i)).position);
    }

    /// Names the segment of an outline's piece, inserts the middle of any other side; false if neither can be.
    bool splitSide(EdgeLink side)
    {
        if (sideLength(side.triangle(), side.edge()) < floor_) return false;
        const VertexId a = t_.mesh().edgeFrom(side), b = t_.mesh().edgeTo(side);
        if (!t_.mesh().isConstrained(side))
            return replaceFlat(side) || insertAt(middleOf(t_.points[a], t_.points[b]), side.triangle());
        const OutlinePiece* piece = pieceAt(side);
        return piece != nullptr && name(piece->segment);
    }

    /// A triangle between nodes of one edge that is flat at a side gives way to a point as far beyond that side as makes a right
    /// angle, which lies in its circle. The middle of the side would be as near to the edge as the triangle is flat: along a rim
    /// that runs with the parameters such points come ever nearer to it.
    bool replaceFlat(EdgeLink side)
    {
        constexpr double kFlat = 0.12, kClearance = 0.25, kRounding = 1e-6;
        const Triangulation2d& mesh = t_.mesh();
        const TriangleId flat = side.triangle(), beyond = mesh.across(side).triangle();
        if (!liesOnOneEdge(flat)) return false;
        const Vec2 a = mesh.position(mesh.edgeFrom(side)), along = mesh.position(mesh.edgeTo(side)) - a;
        const Vec2 up = mesh.position(mesh.apex(side)) - a;
        const double height = cross(along, up), share = dot(along, up), square = squaredLength(along);
        if (!(height < kFlat * square && share > 0.0 && share < square)) return false;
        const std::uint16_t generation = mesh.triangle(flat).generation;
        const Vec2 uv = t_.scaling.toParameters(a + 0.5 * along + 0.5 * Vec2{along.y, -along.x});
        if (isOnPiece(face_, t_, uv, beyond)) return false;
        const auto vertex = insertFacePoint(face_, uv, beyond, t_, kRounding, kClearance * length(along));
        if (!vertex) return false;
        enqueueAround(*vertex);
        return !mesh.isAlive(flat) || mesh.triangle(flat).generation != generation;
    }

    [[nodiscard]] bool liesOnOneEdge(TriangleId t) const
    {
        const auto& v = t_.mesh().triangle(t).v;
        const auto isOn = [&](VertexId vertex, BrepEdgeId edge) {
            if (vertex.value >= edgesAt_.size()) return false;
            return std::find(edgesAt_[vertex].begin(), edgesAt_[vertex].end(), edge) !=
                   edgesAt_[vertex].end();
        };
        if (v[0].value >= edgesAt_.size()) return false;
        return std::any_of(edgesAt_[v[0]].begin(), edgesAt_[v[0]].end(),
                           [&](BrepEdgeId edge) { return isOn(v[1], edge) && isOn(v[2], edge); });
    }

    /// The piece of a segment, none along a pole.
    [[nodiscard]] const OutlinePiece* pieceAt(EdgeLink side) const
    {
        const auto ends = unorderedPair(t_.mesh().edgeFrom(side), t_.mesh().edgeTo(side));
        const std::uint32_t* piece = t_.pieceOf.find(ends);
        return piece == nullptr || !outline_.pieces[*piece].segment.isValid() ? nullptr
                                                                              : &outline_.pieces[*piece];
    }

    /// Points nearer to a curve than its segment is would make facets that lie across the surface, and ever more of them; what
    /// the segment is off by less than the tolerance does not count.
    bool nameNarrowSide(TriangleId t)
    {
        for (unsigned k = 0; k < 3; ++k) {
            const EdgeLink side(t, k);
            if (!t_.mesh().isConstrained(side)) continue;
            const OutlinePiece* piece = pieceAt(side);
            if (piece == nullptr || length(piece->sag) < face_.tolerance) continue;
            const Vec3& a = corner(t, nextCorner(k)).position;
            const Vec3& b = corner(t, previousCorner(k)).position;
            if (FaceTriangulation::isNarrowBeside(*piece, a, b, corner(t, k).position) &&
                name(piece->segment))
                return true;
        }
        return false;
    }

    bool name(SegmentId segment)
    {
        if (!chains_.splitPlace(segment)) return false;
        t_.tooCoarse.push_back(segment);
        if (phase_ == Phase::Points) phase_ = Phase::Named;
        return true;
    }

    /// Where a triangle at a pole has two corners on about the same way to the pole, it is flat in space: inserts a point level
    /// with the pole's image and as far from the pole as the nearer corner, the next one of a ring around the pole.
    bool ringPole(TriangleId t)
    {
        for (unsigned i = 0; i < 3; ++i) {
            const FacePoint pole = corner(t, i);
            const FacePoint &a = corner(t, nextCorner(i)), &b = corner(t, previousCorner(i));
            if (!pole.isPole || a.isPole || b.isPole) continue;
            const bool isANearer = length(a.position - pole.position) < length(b.position - pole.position);
            const FacePoint& nearer = isANearer ? a : b;
            return insertAt(pole.isPoleAlongU ? Vec2{pole.uv.x, nearer.uv.y} : Vec2{nearer.uv.x, pole.uv.y},
                            t);
        }
        return false;
    }

    /// A triangle at a pole is lifted to what lies between its other corners, not to what it covers in the plane: brings an
    /// image of the pole level with one of them.
    bool levelPole(TriangleId t)
    {
        for (unsigned i = 0; i < 3; ++i) {
            if (!corner(t, i).isPole) continue;
            const VertexId pole = t_.mesh().triangle(t).v[i];
            for (const unsigned k : {nextCorner(i), previousCorner(i)}) {
                const FacePoint other = corner(t, k);
                if (other.isPole) continue;
                const auto vertex = insertPoleImage(pole, other, t, t_);
                if (vertex) return enqueueAround(*vertex);
            }
        }
        return false;
    }

    bool insertAt(Vec2 uv, TriangleId hint)
    {
        if (isOnPiece(face_, t_, uv, hint)) return false;
        const auto vertex = insertFacePoint(face_, uv, hint, t_);
        if (!vertex) return false;
        return enqueueAround(*vertex);
    }

    bool enqueueAround(VertexId vertex)
    {
        ++result_.insertions;
        t_.mesh().forEachTriangleAround(vertex, [&](EdgeLink link) {
            enqueue(link.triangle());
            return true;
        });
        return true;
    }

    const BrepFace& face_;
    const FaceOutline& outline_;
    const CurveChains& chains_;
    const InitialFaceMeshOptions& options_;
    FaceTriangulation& t_;
    double cosine_ = 0.5;
    double floor_ = 0.0;
    IdVector<VertexId, std::vector<BrepEdgeId>> edgesAt_;  ///< of the outline's vertices
    std::vector<QueuedTriangle> queue_;                    ///< first in, first out
    std::size_t next_ = 0;
    Phase phase_ = Phase::Chains;
    FaceRefinement result_;
};

}  // namespace

std::size_t seedFace(const BrepModel& model, BrepFaceId id, const CurveChains& chains, FaceTriangulation& t)
{
    const BrepFace& face = model.faces[id];
    // What is there already does for a seed beside it.
    constexpr double kClearance = 0.02;
    std::size_t inserted = 0;
    for (const Vec2 seed : seedsOf(face)) {
        if (isAtFan(model, id, chains, face.surface->position(seed))) continue;
        if (insertFacePoint(face, seed, TriangleId(), t, kClearance)) ++inserted;
    }
    return inserted;
}

FaceRefinement followSurface(const BrepFace& face, const FaceOutline& outline, const CurveChains& chains,
                             const InitialFaceMeshOptions& options, FaceTriangulation& t)
{
    return Follower(face, outline, chains, options, t).run();
}

}  // namespace mesher
