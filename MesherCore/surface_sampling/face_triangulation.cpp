#include "surface_sampling/face_triangulation.h"

#include "predicates/orient2d.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

namespace mesher {

Vec3 FaceTriangulation::unitNormal(const SurfacePoint& point)
{
    constexpr double kSingular = 1e-10;
    const Vec3 normal = point.normal();
    const double size = length(normal);
    const double u = length(point.du), v = length(point.dv);
    const bool isRegular = size > kSingular * u * v && std::min(u, v) > kSingular * std::max(u, v);
    return isRegular ? 1.0 / size * normal : Vec3{};
}

namespace {

// The least width of a face beside a curved piece, in sags of the piece; a third of the area there is missing then.
constexpr double kSagFactor = 2.0;

}  // namespace

bool FaceTriangulation::isNarrowBeside(const OutlinePiece& piece, const Vec3& a, const Vec3& b, const Vec3& p)
{
    const Vec3 chord = b - a;
    const double share = dot(p - a, chord) / squaredLength(chord);
    if (!(share > 0.0 && share < 1.0)) return false;
    const Vec3 sag = 4.0 * share * (1.0 - share) * piece.sag;
    const Vec3 fromCurve = p - a - share * chord - sag;
    return squaredLength(fromCurve) < kSagFactor * kSagFactor * squaredLength(sag);
}

namespace {

constexpr int kUnknown = std::numeric_limits<int>::min();
// A piece that bulges by less of the outline's size is straight.
constexpr double kStraight = 1e-9;

/// The pieces on one edge: which way they run, in sum, from the lower vertex to the higher.
struct EdgeUse
{
    std::uint32_t piece = 0;
    int net = 0;
};

class OutlineTriangulator
{
public:
    OutlineTriangulator(const BrepModel& model, BrepFaceId id, const CurveChains& chains,
                        const IdVector<NodeId, MeshNode>& nodes, const FaceOutline& outline)
        : id_(id), face_(model.faces[id]), chains_(chains), nodes_(nodes), outline_(outline)
    {
        result_.scaling = outline.scaling;
        result_.size = outline.size;
    }

    Result<FaceTriangulation> run()
    {
        if (auto inserted = insertPoints(); !inserted) return inserted.error();
        if (auto recovered = recoverPieces(); !recovered) return recovered.error();
        if (!result_.tooCoarse.empty()) return std::move(result_);
        if (auto classified = classify(); !classified) return classified.error();
        if (result_.tooCoarse.empty()) findHiddenVertices();
        return std::move(result_);
    }

private:
    Result<void> insertPoints()
    {
        std::vector<Vec2> points;
        points.reserve(outline_.points.size());
        for (const OutlinePoint& point : outline_.points) points.push_back(rounded(point.plane));
        auto inserted = result_.delaunay.insertPoints(points);
        if (!inserted) return failure(0, "its parameters are out of range", "heal the shape");
        vertices_ = std::move(inserted->vertices);
        if (result_.delaunay.dimension() < 2)
            return failure(0, "its boundary has no area in the parameters",
                           "remove the face or heal the shape");
        result_.points.resize(result_.mesh().vertexSlots());
        for (std::uint32_t i = 0; i < points.size(); ++i) {
            const OutlinePoint& point = outline_.points[i];
            FacePoint& target = result_.points[vertices_[i]];
            if (target.node.isValid() && target.node != point.node) {
                return failure(i, "two of its boundary's points coincide in the parameters",
                               "heal the shape, or merge the small edge there");
            }
            target = {point.uv,     nodes_[point.node].position, normalAt(point), point.node,
                      point.isPole, point.isPoleAlongU};
        }
        return {};
    }

    /// None at a pole: its line is shorter than the model's tolerance, and what it makes of a normal is noise.
    [[nodiscard]] Vec3 normalAt(const OutlinePoint& point) const
    {
        if (point.isPole) return {};
        return FaceTriangulation::unitNormal(face_.surface->evaluate(point.uv));
    }

    /// Without digits far below the outline's size, which the predicates would have to carry along.
    [[nodiscard]] Vec2 rounded(Vec2 p) const
    {
        const double step =
            std::ldexp(1.0, std::ilogb(std::max(outline_.size, std::numeric_limits<double>::min())) - 60);
        return {step * std::nearbyint(p.x / step), step * std::nearbyint(p.y / step)};
    }

    Result<void> recoverPieces()
    {
        for (std::uint32_t i = 0; i < outline_.pieces.size(); ++i) {
            const OutlinePiece& piece = outline_.pieces[i];
            const VertexId a = vertices_[piece.from], b = vertices_[piece.to];
            if (a == b) {
                return failure(piece.from, "an edge has no length in the parameters", "heal the shape");
            }
            const bool isEdge = result_.delaunay.recoverSegment(a, b).hasValue() &&
                                result_.delaunay.lastSegment().size() == 2;
            if (!isEdge) {
                if (auto named = nameCrossing(i); !named) return named;
                continue;
            }
            EdgeUse& use = uses_[unorderedPair(a, b)];
            use.piece = i;
            if (!piece.isEmbedded) use.net += a < b ? 1 : -1;
            result_.pieceOf.insertOrAssign(unorderedPair(a, b), i);
        }
        return {};
    }

    [[nodiscard]] bool isSplittable(const OutlinePiece& piece) const
    {
        return piece.segment.isValid() && chains_.splitPlace(piece.segment).has_value();
    }
    [[nodiscard]] bool isCurved(const OutlinePiece& piece) const
    {
        return std::abs(piece.bulge) > kStraight * outline_.size;
    }

    /// Of the pieces that meet in a crossing the curved ones are too coarse; straight ones cross for good.
    Result<void> nameCrossing(std::uint32_t index)
    {
        bool isNamed = propose(index);
        for (std::uint32_t j = 0; j < outline_.pieces.size(); ++j) {
            if (j != index && meets(outline_.pieces[index], outline_.pieces[j]))
                isNamed = propose(j) || isNamed;
        }
        if (isNamed) return {};
        return failure(outline_.pieces[index].from, "its edges cross",
                       "repair the face's wires, or lower the tolerance");
    }

    bool propose(std::uint32_t index)
    {
        const OutlinePiece& piece = outline_.pieces[index];
        if (!isCurved(piece) || !isSplittable(piece)) return false;
        result_.tooCoarse.push_back(piece.segment);
        return true;
    }

    /// Do they cross, or does one end in the other?
    [[nodiscard]] bool meets(const OutlinePiece& p, const OutlinePiece& q) const
    {
        const VertexId a = vertices_[p.from], b = vertices_[p.to], c = vertices_[q.from], d = vertices_[q.to];
        const auto side = [&](VertexId x, VertexId y, VertexId z) {
            return static_cast<int>(orient2d(positionOf(x), positionOf(y), positionOf(z)));
        };
        if (a == c || a == d || b == c || b == d) {
            if (unorderedPair(a, b) == unorderedPair(c, d)) return false;
            const VertexId other = (a == c || b == c) ? d : c;
            return side(a, b, other) == 0;
        }
        return side(a, b, c) * side(a, b, d) <= 0 && side(c, d, a) * side(c, d, b) <= 0;
    }

    [[nodiscard]] Vec2 positionOf(VertexId v) const { return result_.mesh().position(v); }

    /// How often the loops wind around each triangle.
    void computeWindings()
    {
        const Triangulation2d& mesh = result_.mesh();
        windings_.assign(mesh.triangleSlots(), kUnknown);
        std::vector<TriangleId> stack;
        for (std::uint32_t i = 0; i < mesh.triangleSlots() && stack.empty(); ++i) {
            if (mesh.isAlive(TriangleId(i)) && mesh.triangle(TriangleId(i)).isGhost())
                stack.push_back(TriangleId(i));
        }
        windings_[stack.front().value] = 0;
        while (!stack.empty()) {
            const TriangleId t = stack.back();
            stack.pop_back();
            for (unsigned k = 0; k < 3; ++k) {
                const EdgeLink side(t, k);
                const TriangleId next = mesh.across(side).triangle();
                if (windings_[next.value] != kUnknown) continue;
                windings_[next.value] = windings_[t.value] - netAlong(side);
                stack.push_back(next);
            }
        }
    }

    /// Pieces that run along the triangle's side with it on their left, less those that run the other way.
    [[nodiscard]] int netAlong(EdgeLink side) const
    {
        if (!result_.mesh().isConstrained(side)) return 0;
        const VertexId a = result_.mesh().edgeFrom(side), b = result_.mesh().edgeTo(side);
        const EdgeUse* use = uses_.find(unorderedPair(a, b));
        if (use == nullptr) return 0;
        return a < b ? use->net : -use->net;
    }

    Result<void> classify()
    {
        computeWindings();
        const Triangulation2d& mesh = result_.mesh();
        int low = 0, high = 0;
        for (const int w : windings_) {
            if (w == kUnknown) continue;
            low = std::min(low, w);
            high = std::max(high, w);
        }
        // Loops that run the wrong way around, all of them, still tell what they enclose.
        const int inside = high == 0 && low == -1 ? -1 : 1;
        if (high == 0 && low == 0) return failure(0, "its loops enclose nothing", "heal the shape");
        if (inside == 1 && (low < 0 || high > 1)) return nameOverlap();
        for (std::uint32_t i = 0; i < mesh.triangleSlots(); ++i) {
            if (!mesh.isAlive(TriangleId(i))) continue;
            result_.delaunay.setRegion(TriangleId(i),
                                       windings_[i] == inside ? FaceTriangulation::kInside : RegionId(0));
        }
        return {};
    }

    /// Loops overlap: curved pieces around what is enclosed twice or from the wrong side are too coarse.
    Result<void> nameOverlap()
    {
        const Triangulation2d& mesh = result_.mesh();
        std::uint32_t somewhere = 0;
        for (std::uint32_t i = 0; i < mesh.triangleSlots(); ++i) {
            if (windings_[i] == kUnknown || windings_[i] == 0 || windings_[i] == 1) continue;
            for (unsigned k = 0; k < 3; ++k) {
                const EdgeLink side(TriangleId(i), k);
                if (!mesh.isConstrained(side)) continue;
                const auto* piece =
                    result_.pieceOf.find(unorderedPair(mesh.edgeFrom(side), mesh.edgeTo(side)));
                if (piece == nullptr) continue;
                somewhere = outline_.pieces[*piece].from;
                propose(*piece);
            }
        }
        if (result_.tooCoarse.empty()) findHiddenVertices();
        if (!result_.tooCoarse.empty()) return {};
        return failure(somewhere, "its loops overlap", "repair the face's wires");
    }

    /// A vertex between a piece and its parameter curve is on the wrong side of the piece; one that is not much farther away
    /// sees a piece where the face has much more or less width.
    void findHiddenVertices()
    {
        const Triangulation2d& mesh = result_.mesh();
        for (const auto& [ends, index] : result_.pieceOf) {
            const OutlinePiece& piece = outline_.pieces[index];
            if (!piece.segment.isValid()) continue;
            const EdgeLink left = mesh.findEdge(vertices_[piece.from], vertices_[piece.to]);
            for (const EdgeLink side : {left, mesh.across(left)}) {
                if (mesh.triangle(side.triangle()).isGhost()) continue;
                const bool isBulgeSide = (side == left) == (piece.bulge > 0.0);
                const VertexId apex = mesh.apex(side);
                if (isBulgeSide && isUnderBulge(piece, positionOf(apex))) {
                    propose(index);
                } else if (result_.isInside(side.triangle()) && isNarrow(piece, apex) &&
                           isSplittable(piece)) {
                    result_.tooCoarse.push_back(piece.segment);
                }
            }
        }
    }

    [[nodiscard]] bool isNarrow(const OutlinePiece& piece, VertexId apex) const
    {
        const auto placeOf = [&](std::uint32_t point) {
            return nodes_[outline_.points[point].node].position;
        };
        return FaceTriangulation::isNarrowBeside(piece, placeOf(piece.from), placeOf(piece.to),
                                                 result_.points[apex].position);
    }

    [[nodiscard]] bool isUnderBulge(const OutlinePiece& piece, Vec2 p) const
    {
        const Vec2 a = positionOf(vertices_[piece.from]), b = positionOf(vertices_[piece.to]);
        const Vec2 chord = b - a;
        const double share = dot(p - a, chord) / squaredLength(chord);
        if (!(share > 0.0 && share < 1.0)) return false;
        const double height = std::abs(cross(chord, p - a)) / length(chord);
        return height <= std::abs(piece.bulge) * 4.0 * share * (1.0 - share);
    }

    [[nodiscard]] Error failure(std::uint32_t point, std::string message, std::string remedy) const
    {
        Error error;
        error.code = ErrorCode::DegenerateInput;
        error.entity = nameOf(id_);
        error.message = std::move(message);
        if (point < outline_.points.size()) error.point = nodes_[outline_.points[point].node].position;
        error.remedy = std::move(remedy);
        return error;
    }

    BrepFaceId id_;
    const BrepFace& face_;
    const CurveChains& chains_;
    const IdVector<NodeId, MeshNode>& nodes_;
    const FaceOutline& outline_;
    FaceTriangulation result_;
    std::vector<VertexId> vertices_;  ///< by point of the outline
    IndexedMap<std::pair<VertexId, VertexId>, EdgeUse> uses_;
    std::vector<int> windings_;  ///< by triangle
};

}  // namespace

Result<FaceTriangulation> triangulateOutline(const BrepModel& model, BrepFaceId face,
                                             const CurveChains& chains,
                                             const IdVector<NodeId, MeshNode>& nodes,
                                             const FaceOutline& outline)
{
    return OutlineTriangulator(model, face, chains, nodes, outline).run();
}

}  // namespace mesher
