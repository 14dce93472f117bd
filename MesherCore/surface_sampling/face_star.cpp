#include "surface_sampling/face_star.h"

#include "surface_sampling/facet_measures.h"

#include <algorithm>
#include <limits>

namespace mesher {
namespace {

/// Stars grow no further: on sound facets they have 6 sides.
constexpr std::size_t kMostSides = 128;

}  // namespace

void FaceStar::begin(const FaceVertex& vertex, Vec2 uv, StarExtent extent)
{
    vertex_ = vertex;
    uv_ = uv;
    extent_ = extent;
    isClosed_ = true;
    cavity_.clear();
    sides_.clear();
    open_.clear();
    spokes_ = {};
}

StarSide FaceStar::sideOf(TriangleId t, unsigned side, Vec2 shift, Vec2 uvVertex) const
{
    const FaceTriangle& record = mesh_.triangle(t);
    const unsigned from = nextCorner(side), to = previousCorner(side);
    return {record.v[from], record.v[to],   record.uv[from] + shift, record.uv[to] + shift,
            uvVertex,       record.n[side], record.s[side]};
}

void FaceStar::addTriangle(TriangleId t) { cavity_.push_back(t); }

void FaceStar::evaluateInside(TriangleId t, const FaceVertex& vertex, Vec2 uv, StarExtent extent)
{
    begin(vertex, uv, extent);
    addTriangle(t);
    // All three sides first: what grows at one of them must know the corners of the others.
    for (const unsigned side : {2u, 1u, 0u}) open_.push_back(sideOf(t, side, {}, uv));
    while (!open_.empty()) {
        const StarSide side = open_.back();
        open_.pop_back();
        grow(side);
    }
}

void FaceStar::evaluateOnSide(EdgeLink side, const FaceVertex& vertex, Vec2 uv, StarExtent extent,
                              const std::array<SegmentId, 2>& halves, std::optional<Vec2> uvBehind)
{
    begin(vertex, uv, extent);
    const TriangleId t = side.triangle();
    const EdgeLink other = mesh_.across(side);
    addTriangle(t);
    isClosed_ = other.isValid();
    std::size_t fromOther = 0;
    if (isClosed_) {
        const TriangleId s = other.triangle();
        const Vec2 shift = uvBehind ? Vec2{} : mesh_.shiftAcross(geometry_, side);
        const Vec2 uvThere = uvBehind.value_or(uv);
        addTriangle(s);
        open_.push_back(sideOf(s, previousCorner(other.edge()), shift, uvThere));
        open_.push_back(sideOf(s, nextCorner(other.edge()), shift, uvThere));
        fromOther = open_.size();
    }
    open_.push_back(sideOf(t, previousCorner(side.edge()), {}, uv));
    open_.push_back(sideOf(t, nextCorner(side.edge()), {}, uv));
    spokes_[0] = {0, halves[1]};
    bool isOtherBegun = false;
    while (!open_.empty()) {
        if (!isOtherBegun && open_.size() <= fromOther) {
            spokes_[1] = {sides_.size(), halves[0]};
            isOtherBegun = true;
        }
        const StarSide next = open_.back();
        open_.pop_back();
        grow(next);
    }
    if (!isOtherBegun) spokes_[1] = {sides_.size(), halves[0]};
}

bool FaceStar::isOnPolygon(VertexId v) const
{
    // Two vertices of one node are one corner to those who see nodes.
    const NodeId node = mesh_.vertex(v).node;
    const auto isSame = [&](VertexId other) {
        return other == v || (node.isValid() && mesh_.vertex(other).node == node);
    };
    const auto touches = [&](const StarSide& side) { return isSame(side.a) || isSame(side.b); };
    return std::any_of(sides_.begin(), sides_.end(), touches) ||
           std::any_of(open_.begin(), open_.end(), touches);
}

bool FaceStar::isToBeRemoved(const StarSide& side) const
{
    if (extent_ == StarExtent::Least || side.segment.isValid() || !side.outer.isValid()) return false;
    if (mesh_.isOnRing(side.a, side.b)) return false;
    if (sides_.size() + open_.size() >= kMostSides) return false;
    const VertexId apex = mesh_.apex(side.outer);
    const FaceTriangle& behind = mesh_.triangle(side.outer.triangle());
    const FaceVertex& a = mesh_.vertex(side.a);
    const FaceVertex& b = mesh_.vertex(side.b);
    const FaceVertex& c = mesh_.vertex(apex);
    if (oppositeAngleExcess(a.position, b.position, vertex_.position, c.position) <= kDelaunayTie)
        return false;
    if (isOnPolygon(apex)) return false;
    const Vec2 uvC = behind.uv[side.outer.edge()] + shiftBehind(side);
    const double after = std::min(facetAgreement(geometry_, vertex_, side.uvVertex, a, side.uvA, c, uvC),
                                  facetAgreement(geometry_, vertex_, side.uvVertex, c, uvC, b, side.uvB));
    if (after >= kUprightAgreement) return true;
    return after >= std::min(facetAgreement(geometry_, vertex_, side.uvVertex, a, side.uvA, b, side.uvB),
                             facetAgreement(geometry_, b, side.uvB, a, side.uvA, c, uvC));
}

/// Brings the triangle behind a side into the image of the side: by the corner that is no pole.
Vec2 FaceStar::shiftBehind(const StarSide& side) const
{
    const FaceTriangle& record = mesh_.triangle(side.outer.triangle());
    const unsigned a = previousCorner(side.outer.edge()), b = nextCorner(side.outer.edge());
    return mesh_.vertex(record.v[a]).isPole() ? geometry_.shiftBetween(record.uv[b], side.uvB)
                                              : geometry_.shiftBetween(record.uv[a], side.uvA);
}

void FaceStar::grow(const StarSide& side)
{
    if (!isToBeRemoved(side)) {
        sides_.push_back(side);
        return;
    }
    const TriangleId t = side.outer.triangle();
    const unsigned a = previousCorner(side.outer.edge()), b = nextCorner(side.outer.edge());
    const Vec2 shift = shiftBehind(side);
    addTriangle(t);
    // From a over the apex to b; the side opposite of b comes first.
    open_.push_back(sideOf(t, a, shift, side.uvVertex));
    open_.push_back(sideOf(t, b, shift, side.uvVertex));
}

bool FaceStar::isFolded(double leastAgreement) const
{
    double least = 1.0;
    for (const StarSide& side : sides_) {
        least = std::min(least, facetAgreement(geometry_, vertex_, side.uvVertex, mesh_.vertex(side.a),
                                               side.uvA, mesh_.vertex(side.b), side.uvB));
    }
    if (least >= leastAgreement) return false;
    double before = 1.0;
    for (const TriangleId t : cavity_) before = std::min(before, facetAgreement(geometry_, mesh_, t));
    return least < before;
}

double FaceStar::squaredSpokeLength() const
{
    double least = std::numeric_limits<double>::infinity();
    for (const StarSide& side : sides_) {
        least = std::min(least, squaredLength(mesh_.position(side.a) - vertex_.position));
        least = std::min(least, squaredLength(mesh_.position(side.b) - vertex_.position));
    }
    return least;
}

VertexId FaceStar::commit()
{
    const VertexId v = mesh_.addVertex(vertex_);
    const std::size_t count = sides_.size();
    made_.assign(cavity_.begin(), cavity_.end());
    while (made_.size() > count) {
        mesh_.freeTriangle(made_.back());
        made_.pop_back();
    }
    while (made_.size() < count) made_.push_back(mesh_.allocateTriangle());
    for (std::size_t i = 0; i < count; ++i) {
        const StarSide& side = sides_[i];
        mesh_.writeTriangle(made_[i], {v, side.a, side.b}, {side.uvVertex, side.uvA, side.uvB});
        mesh_.triangle(made_[i]).s[0] = side.segment;
        mesh_.vertex(side.a).triangle = made_[i];
        mesh_.vertex(side.b).triangle = made_[i];
    }
    for (std::size_t i = 0; i < count; ++i) {
        mesh_.link(EdgeLink(made_[i], 0), sides_[i].outer);
        if (i + 1 < count) {
            mesh_.link(EdgeLink(made_[i], 1), EdgeLink(made_[i + 1], 2));
        } else if (isClosed_) {
            mesh_.link(EdgeLink(made_[i], 1), EdgeLink(made_[0], 2));
        }
    }
    for (const Spoke& spoke : spokes_) {
        if (!spoke.segment.isValid()) continue;
        if (spoke.at < count) mesh_.triangle(made_[spoke.at]).s[2] = spoke.segment;
        if (spoke.at > 0 || isClosed_) {
            mesh_.triangle(made_[(spoke.at + count - 1) % count]).s[1] = spoke.segment;
        }
    }
    mesh_.vertex(v).triangle = made_[0];
    return v;
}

}  // namespace mesher
