#include "surface_sampling/face_flips.h"

#include "base/assert.h"
#include "surface_sampling/facet_measures.h"

#include <algorithm>

namespace mesher {
namespace {

constexpr double kLeastAgreement = 0.5;

struct OuterSide
{
    EdgeLink link;
    SegmentId segment;

    OuterSide(const FaceTriangle& record, unsigned side) : link(record.n[side]), segment(record.s[side]) {}
};

void attach(FaceMesh& mesh, EdgeLink side, const OuterSide& outer)
{
    mesh.triangle(side.triangle()).s[side.edge()] = outer.segment;
    mesh.link(side, outer.link);
}

}  // namespace

FlipObstacle obstacleToFlip(const FaceMesh& mesh, const FaceGeometry& geometry, EdgeLink side)
{
    const EdgeLink other = mesh.across(side);
    if (!other.isValid() || mesh.segment(side).isValid() || mesh.isOfFan(side))
        return FlipObstacle::Constrained;
    const VertexId near = mesh.apex(side), far = mesh.apex(other);
    const NodeId node = mesh.vertex(near).node;
    const bool isOneNode = node.isValid() && node == mesh.vertex(far).node;
    if (near == far || isOneNode || mesh.areJoined(near, far)) return FlipObstacle::Joined;
    const FaceVertex& a = mesh.vertex(mesh.from(side));
    const FaceVertex& b = mesh.vertex(mesh.to(side));
    const FaceVertex& c = mesh.vertex(near);
    const FaceVertex& d = mesh.vertex(far);
    const FaceTriangle &first = mesh.triangle(side.triangle()), &second = mesh.triangle(other.triangle());
    const Vec2 uvA = first.uv[nextCorner(side.edge())], uvB = first.uv[previousCorner(side.edge())],
               uvC = first.uv[side.edge()], uvD = second.uv[other.edge()] + mesh.shiftAcross(geometry, side);
    const double after = std::min(facetAgreement(geometry, c, uvC, a, uvA, d, uvD),
                                  facetAgreement(geometry, c, uvC, d, uvD, b, uvB));
    if (after >= kLeastAgreement) return FlipObstacle::None;
    const double before = std::min(facetAgreement(geometry, c, uvC, a, uvA, b, uvB),
                                   facetAgreement(geometry, d, uvD, b, uvB, a, uvA));
    return after > before ? FlipObstacle::None : FlipObstacle::Folds;
}

EdgeLink flip(FaceMesh& mesh, const FaceGeometry& geometry, EdgeLink side)
{
    MESHER_PRECONDITION(obstacleToFlip(mesh, geometry, side) == FlipObstacle::None);
    const EdgeLink other = mesh.across(side);
    const TriangleId t = side.triangle(), s = other.triangle();
    const unsigned i = side.edge(), k = other.edge();
    const Vec2 shift = mesh.shiftAcross(geometry, side);
    const FaceTriangle first = mesh.triangle(t), second = mesh.triangle(s);
    const VertexId a = first.v[nextCorner(i)], b = first.v[previousCorner(i)], c = first.v[i],
                   d = second.v[k];
    const Vec2 uvA = first.uv[nextCorner(i)], uvB = first.uv[previousCorner(i)], uvC = first.uv[i];
    const Vec2 uvD = second.uv[k] + shift;
    // The quadrilateral is c, a, d, b, counter-clockwise.
    const OuterSide sideBC(first, nextCorner(i)), sideCA(first, previousCorner(i));
    const OuterSide sideAD(second, nextCorner(k)), sideDB(second, previousCorner(k));
    mesh.writeTriangle(t, {a, d, c}, {uvA, uvD, uvC});
    mesh.writeTriangle(s, {b, c, d}, {uvB, uvC, uvD});
    attach(mesh, EdgeLink(t, 1), sideCA);
    attach(mesh, EdgeLink(t, 2), sideAD);
    attach(mesh, EdgeLink(s, 1), sideDB);
    attach(mesh, EdgeLink(s, 2), sideBC);
    mesh.link(EdgeLink(t, 0), EdgeLink(s, 0));
    for (const VertexId v : {a, c, d}) mesh.vertex(v).triangle = t;
    mesh.vertex(b).triangle = s;
    return EdgeLink(t, 0);
}

bool isLocallyDelaunay(const FaceMesh& mesh, EdgeLink side)
{
    const EdgeLink other = mesh.across(side);
    if (!other.isValid() || mesh.segment(side).isValid() || mesh.isOfFan(side)) return true;
    return oppositeAngleExcess(mesh.position(mesh.from(side)), mesh.position(mesh.to(side)),
                               mesh.position(mesh.apex(side)),
                               mesh.position(mesh.apex(other))) <= kDelaunayTie;
}

FaceFlips restoreSurfaceDelaunay(FaceMesh& mesh, const FaceGeometry& geometry, std::vector<EdgeLink> suspects,
                                 Budget& budget)
{
    FaceFlips result;
    while (!suspects.empty()) {
        const EdgeLink side = suspects.back();
        suspects.pop_back();
        if (!mesh.triangle(side.triangle()).isAlive || isLocallyDelaunay(mesh, side)) continue;
        if (obstacleToFlip(mesh, geometry, side) != FlipObstacle::None) {
            ++result.refused;
            continue;
        }
        if (!budget.allows()) break;
        const EdgeLink diagonal = flip(mesh, geometry, side);
        ++result.flips;
        for (const EdgeLink half : {diagonal, mesh.across(diagonal)}) {
            suspects.emplace_back(half.triangle(), 1u);
            suspects.emplace_back(half.triangle(), 2u);
        }
    }
    result.stopReason = budget.stopReason();
    return result;
}

BudgetLimits flipLimits(const FaceMesh& mesh) { return {.maxOperations = 1000 + 100 * mesh.triangleCount()}; }

FaceFlips makeSurfaceDelaunay(FaceMesh& mesh, const FaceGeometry& geometry, Budget& budget)
{
    std::vector<EdgeLink> sides;
    for (auto i = static_cast<std::uint32_t>(mesh.triangleSlots()); i-- > 0;) {
        if (!mesh.triangle(TriangleId(i)).isAlive) continue;
        for (unsigned k = 0; k < 3; ++k) {
            const EdgeLink side(TriangleId(i), k), other = mesh.across(side);
            if (other.isValid() && side < other) sides.push_back(side);
        }
    }
    return restoreSurfaceDelaunay(mesh, geometry, std::move(sides), budget);
}

}  // namespace mesher
