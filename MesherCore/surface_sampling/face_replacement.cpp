#include "surface_sampling/face_replacement.h"

#include "surface_sampling/facet_measures.h"

#include <algorithm>
#include <limits>

namespace mesher {
namespace {

constexpr double kLeastAgreement = 0.5;

struct OpenSide
{
    VertexId a;
    VertexId b;
    EdgeLink link;
    SegmentId segment;
};

}  // namespace

void replaceTriangles(FaceMesh& mesh, std::span<const TriangleId> removed,
                      std::span<const FacetCorners> added, std::span<const NewSegmentSide> segments,
                      std::vector<TriangleId>& made)
{
    std::vector<OpenSide> outer;
    for (const TriangleId t : removed) {
        for (unsigned i = 0; i < 3; ++i) {
            const EdgeLink side(t, i), other = mesh.across(side);
            const bool isInner = other.isValid() &&
                                 std::find(removed.begin(), removed.end(), other.triangle()) != removed.end();
            if (!isInner || mesh.segment(side).isValid()) {
                outer.push_back(
                    {mesh.from(side), mesh.to(side), isInner ? EdgeLink() : other, mesh.segment(side)});
            }
        }
    }
    for (const TriangleId t : removed) mesh.freeTriangle(t);
    made.clear();
    for (const FacetCorners& facet : added) {
        const TriangleId t = mesh.allocateTriangle();
        mesh.writeTriangle(t, facet.v, facet.uv);
        for (const VertexId v : facet.v) mesh.vertex(v).triangle = t;
        made.push_back(t);
    }
    for (const TriangleId t : made) {
        for (unsigned i = 0; i < 3; ++i) {
            const EdgeLink side(t, i);
            const VertexId a = mesh.from(side), b = mesh.to(side);
            for (const OpenSide& open : outer) {
                if (open.a != a || open.b != b) continue;
                mesh.triangle(t).s[i] = open.segment;
                if (open.link.isValid()) mesh.link(side, open.link);
            }
            for (const NewSegmentSide& given : segments) {
                if ((given.a == a && given.b == b) || (given.a == b && given.b == a)) {
                    mesh.triangle(t).s[i] = given.segment;
                }
            }
            for (const TriangleId s : made) {
                for (unsigned k = 0; k < 3; ++k) {
                    if (mesh.from(EdgeLink(s, k)) == b && mesh.to(EdgeLink(s, k)) == a) {
                        mesh.link(side, EdgeLink(s, k));
                    }
                }
            }
        }
    }
}

void FaceVertexRemoval::collectRing(VertexId v)
{
    removed_.clear();
    ring_.clear();
    leastAgreement_ = kLeastAgreement;
    Vec2 shift;
    EdgeLink previous;
    mesh_.forEachTriangleAround(v, [&](EdgeLink opposite) {
        const TriangleId t = opposite.triangle();
        const FaceTriangle& record = mesh_.triangle(t);
        if (previous.isValid()) {
            shift = shift +
                    mesh_.shiftAcross(geometry_, EdgeLink(previous.triangle(), nextCorner(previous.edge())));
        }
        previous = opposite;
        const unsigned from = nextCorner(opposite.edge());
        removed_.push_back(t);
        ring_.push_back({record.v[from], record.uv[from] + shift});
        leastAgreement_ = std::min(leastAgreement_, facetAgreement(geometry_, mesh_, t));
    });
}

FacetCorners FaceVertexRemoval::cornersOf(std::size_t ear) const
{
    const std::size_t count = ring_.size();
    const RingCorner& a = ring_[(ear + count - 1) % count];
    const RingCorner& b = ring_[ear];
    const RingCorner& c = ring_[(ear + 1) % count];
    return {{a.v, b.v, c.v}, {a.uv, b.uv, c.uv}};
}

/// Infinite for an ear that must not be cut.
double FaceVertexRemoval::costOf(std::size_t ear) const
{
    constexpr double kNever = std::numeric_limits<double>::infinity();
    const FacetCorners facet = cornersOf(ear);
    const FaceVertex& a = mesh_.vertex(facet.v[0]);
    const FaceVertex& b = mesh_.vertex(facet.v[1]);
    const FaceVertex& c = mesh_.vertex(facet.v[2]);
    if (facetAgreement(geometry_, a, facet.uv[0], b, facet.uv[1], c, facet.uv[2]) < leastAgreement_)
        return kNever;
    if (ring_.size() == 3) return 0.0;
    if (mesh_.areJoined(facet.v[0], facet.v[2])) return kNever;
    double cost = -1.0;
    for (const RingCorner& corner : ring_) {
        if (corner.v == facet.v[0] || corner.v == facet.v[1] || corner.v == facet.v[2]) continue;
        cost =
            std::max(cost, oppositeAngleExcess(a.position, c.position, b.position, mesh_.position(corner.v)));
    }
    return cost;
}

bool FaceVertexRemoval::evaluate(VertexId v)
{
    if (!mesh_.vertex(v).isFree) return false;
    vertex_ = v;
    collectRing(v);
    added_.clear();
    while (ring_.size() >= 3) {
        std::size_t best = 0;
        double least = std::numeric_limits<double>::infinity();
        for (std::size_t i = 0; i < ring_.size(); ++i) {
            const double cost = costOf(i);
            if (cost < least) {
                least = cost;
                best = i;
            }
        }
        if (!(least < std::numeric_limits<double>::infinity())) return false;
        added_.push_back(cornersOf(best));
        if (ring_.size() == 3) return true;
        ring_.erase(ring_.begin() + static_cast<std::ptrdiff_t>(best));
    }
    return false;
}

void FaceVertexRemoval::commit()
{
    replaceTriangles(mesh_, removed_, added_, {}, made_);
    mesh_.removeVertex(vertex_);
}

}  // namespace mesher
