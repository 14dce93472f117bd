#include "improvement/boundary_geometry.h"

#include <algorithm>
#include <cmath>

namespace mesher {

namespace {

constexpr double kNodeDistance = 1e-7;  // model units, of a node from adjoining faces
constexpr double kSlack = 1e-9;         // relative, for rounding

double intoPeriod(double value, double start, double period)
{
    return period > 0.0 ? value - period * std::floor((value - start) / period) : value;
}

/// Cosine of the smallest angle: roots and quotients are the same on every machine, angles are not.
double largestCosineOf(const std::array<Vec3, 3>& p)
{
    double largest = -1.0;
    for (std::size_t k = 0; k < 3; ++k) {
        const Vec3 a = p[(k + 1) % 3] - p[k];
        const Vec3 b = p[(k + 2) % 3] - p[k];
        const double lengths = std::sqrt(squaredLength(a) * squaredLength(b));
        largest = std::max(largest, lengths > 0.0 ? dot(a, b) / lengths : 1.0);
    }
    return largest;
}

/// Of a chord whose ends have these unit normals or tangents, as if the curvature were the same all along.
double sagOf(const Vec3& chord, const Vec3& first, const Vec3& last)
{
    return 0.125 * length(chord) * length(last - first);
}

}  // namespace

BoundaryGeometry::BoundaryGeometry(const BrepModel& model, const TetComplex& complex,
                                   const IdVector<NodeId, MeshNode>& first, double maxSag)
    : model_(model),
      complex_(complex),
      first_(first),
      maxSag_(maxSag),
      surfaces_(model.faces.size()),
      curves_(model.edges.size()),
      corners_(complex.facetLimit()),
      atFirst_(complex.facetLimit())
{
}

const Surface& BoundaryGeometry::surface(std::uint32_t face) const
{
    auto& own = surfaces_[face];
    if (!own) own = model_.faces[BrepFaceId(face)].surface->clone();
    return *own;
}

const Curve& BoundaryGeometry::curve(std::uint32_t edge) const
{
    auto& own = curves_[edge];
    if (!own) own = model_.edges[BrepEdgeId(edge)].curve->clone();
    return *own;
}

bool BoundaryGeometry::isPlane(std::uint32_t face) const
{
    return model_.faces[BrepFaceId(face)].surface->kind() == SurfaceKind::Plane;
}

SurfaceCorner BoundaryGeometry::cornerAt(std::uint32_t face, Vec2 uv) const
{
    constexpr double kSingular = 1e-9;
    const SurfacePoint point = surface(face).evaluate(uv);
    const Vec3 normal = point.normal();
    const double size = length(normal);
    if (!(size > kSingular * length(point.du) * length(point.dv))) return {uv, {}};
    return {uv, (1.0 / size) * normal};
}

/// What another facet of the face knows at the node; else, at an edge or vertex, what is found from another corner.
SurfaceCorner BoundaryGeometry::find(FacetId f, std::size_t k, const Corners& known) const
{
    constexpr double kFar = 1e-3;  // of the facet's side, from where the seed led
    const std::uint32_t face = complex_.face(f);
    const NodeId n = complex_.nodes(f)[k];
    const MeshNode& node = complex_.node(n);
    if (node.entity == EntityRef{2, face}) return cornerAt(face, node.parameters);
    if (isPlane(face)) return cornerAt(face, {});
    for (const FacetId g : complex_.facets(n)) {
        if (complex_.face(g) != face || corners_[g].side == 0.0) continue;
        const FacetNodes& v = complex_.nodes(g);
        return corners_[g].corner[static_cast<std::size_t>(std::find(v.begin(), v.end(), n) - v.begin())];
    }
    for (std::size_t i = 1; i < 3; ++i) {
        const MeshNode& other = complex_.node(complex_.nodes(f)[(k + i) % 3]);
        const bool isInFace = other.entity == EntityRef{2, face};
        if (!isInFace && (k + i) % 3 > k) continue;  // it is not known yet
        const Vec2 seed = isInFace ? other.parameters : known.corner[(k + i) % 3].parameters;
        const SurfaceProjection found = surface(face).project(node.position, seed);
        if (found.distance > kFar * length(other.position - node.position)) continue;
        return cornerAt(face, found.parameters);
    }
    return cornerAt(face, surface(face).project(node.position).parameters);
}

/// All changes of a facet ask for its corners before, so what is found at first is what it was at first.
const BoundaryGeometry::Corners& BoundaryGeometry::cornersOf(FacetId f)
{
    Corners& known = corners_[f];
    if (known.side != 0.0) return known;
    const FacetNodes& v = complex_.nodes(f);
    const Vec3 own = cross(complex_.position(v[1]) - complex_.position(v[0]),
                           complex_.position(v[2]) - complex_.position(v[0]));
    double sum = 0.0;
    for (std::size_t k = 0; k < 3; ++k) {
        known.corner[k] = find(f, k, known);
        sum += dot(own, known.corner[k].normal);
    }
    known.side = sum < 0.0 ? -1.0 : 1.0;
    judge(pointsOf(v), known, atFirst_[f]);
    return known;
}

// ---- places on the exact geometry ------------------------------------------------------------------------------------

std::optional<Vec3> BoundaryGeometry::tangentAt(std::uint32_t edge, double t) const
{
    const Vec3 d1 = curve(edge).evaluate(t).d1;
    const double speed = length(d1);
    if (!(speed > 0.0)) return {};
    return (1.0 / speed) * d1;
}

std::optional<Vec3> BoundaryGeometry::tangent(NodeId n) const
{
    const MeshNode& node = complex_.node(n);
    if (model_.edges[BrepEdgeId(node.entity.index)].isDegenerate) return {};
    return tangentAt(node.entity.index, node.parameters.x);
}

std::optional<Vec3> BoundaryGeometry::normal(NodeId n) const
{
    const MeshNode& node = complex_.node(n);
    const Vec3 normal = cornerAt(node.entity.index, node.parameters).normal;
    if (squaredLength(normal) == 0.0) return {};
    return normal;
}

bool BoundaryGeometry::moveOnFace(const MeshNode& node, const Vec3& target, BoundaryMove& move) const
{
    const BrepFace& face = model_.faces[BrepFaceId(node.entity.index)];
    const Surface& own = surface(node.entity.index);
    const Vec2 uv = own.project(target, node.parameters).parameters;
    move.parameters = {intoPeriod(uv.x, face.boundsU.first, own.periodU()),
                       intoPeriod(uv.y, face.boundsV.first, own.periodV())};
    move.position = own.position(move.parameters);
    return isFinite(move.position);
}

bool BoundaryGeometry::moveOnCurve(const MeshNode& node, const Vec3& target, BoundaryMove& move) const
{
    const BrepEdge& edge = model_.edges[BrepEdgeId(node.entity.index)];
    const Vec3 d1 = curve(node.entity.index).evaluate(node.parameters.x).d1;
    const double t = node.parameters.x + dot(target - node.position, d1) / squaredLength(d1);
    if (!(edge.part.first < t && t < edge.part.last)) return false;
    move.parameters = {t, 0.0};
    move.position = curve(node.entity.index).position(t);
    return isFinite(move.position);
}

/// The corners of the facets at a node that has moved; false if it is off one of their faces.
bool BoundaryGeometry::findCorners(BoundaryMove& move)
{
    const MeshNode& node = complex_.node(move.node);
    const bool isOnEdge = node.entity.dimension == 1;
    const double allowed =
        isOnEdge ? std::max(kNodeDistance, model_.edges[BrepEdgeId(node.entity.index)].tolerance) : 0.0;
    move.corners.clear();
    const auto facets = complex_.facets(move.node);
    for (std::size_t i = 0; i < facets.size(); ++i) {
        const std::uint32_t face = complex_.face(facets[i]);
        const auto same = std::find_if(facets.begin(), facets.begin() + static_cast<std::ptrdiff_t>(i),
                                       [&](FacetId f) { return complex_.face(f) == face; });
        if (same != facets.begin() + static_cast<std::ptrdiff_t>(i)) {
            move.corners.push_back(move.corners[static_cast<std::size_t>(same - facets.begin())]);
        } else if (!isOnEdge) {
            move.corners.push_back(cornerAt(face, move.parameters));
        } else {
            const FacetNodes& v = complex_.nodes(facets[i]);
            const auto k = static_cast<std::size_t>(std::find(v.begin(), v.end(), move.node) - v.begin());
            const SurfaceProjection found =
                surface(face).project(move.position, cornersOf(facets[i]).corner[k].parameters);
            if (!(found.distance <= allowed)) return false;
            move.corners.push_back(cornerAt(face, found.parameters));
        }
    }
    return true;
}

bool BoundaryGeometry::evaluateMove(NodeId n, const Vec3& target, BoundaryMove& move)
{
    const MeshNode& node = complex_.node(n);
    move.node = n;
    return node.entity.dimension == 2 ? moveOnFace(node, target, move) : moveOnCurve(node, target, move);
}

// ---- how well triangles follow ---------------------------------------------------------------------------------------

void BoundaryGeometry::judge(const std::array<Vec3, 3>& p, const Corners& corners, Fidelity& fidelity) const
{
    const Vec3 doubleArea = cross(p[1] - p[0], p[2] - p[0]);
    const double size = length(doubleArea);
    fidelity.cosineOfLeast = std::max(fidelity.cosineOfLeast, largestCosineOf(p));
    for (std::size_t k = 0; k < 3; ++k) {
        const Vec3& normal = corners.corner[k].normal;
        const Vec3& next = corners.corner[(k + 1) % 3].normal;
        if (squaredLength(normal) == 0.0) continue;
        const double cosine = size > 0.0 ? corners.side * dot(doubleArea, normal) / size : -1.0;
        fidelity.agreement = std::min(fidelity.agreement, cosine);
        if (squaredLength(next) == 0.0) continue;
        fidelity.sag = std::max(fidelity.sag, sagOf(p[(k + 1) % 3] - p[k], normal, next));
    }
}

std::array<Vec3, 3> BoundaryGeometry::pointsOf(const FacetNodes& v) const
{
    return {complex_.position(v[0]), complex_.position(v[1]), complex_.position(v[2])};
}

double BoundaryGeometry::largestSag(double first) const
{
    const double grown = kGrowth * first;
    return maxSag_ > 0.0 ? std::max(first, std::min(grown, maxSag_)) : grown;
}

void BoundaryGeometry::includeLimits(FacetId f, Fidelity& limits)
{
    // 1 - cos grows with the square of the angle.
    const Corners& corners = cornersOf(f);
    const Fidelity& first = atFirst_[f];
    limits.agreement = std::min(limits.agreement, 1.0 - kGrowth * kGrowth * (1.0 - first.agreement));
    limits.sag = std::max(limits.sag, largestSag(first.sag));
    Fidelity now;
    judge(pointsOf(complex_.nodes(f)), corners, now);
    limits.cosineOfLeast = std::max(limits.cosineOfLeast, now.cosineOfLeast);
}

bool BoundaryGeometry::isWithin(const Fidelity& after, const Fidelity& limits) const
{
    constexpr double kLeastAgreement = 0.3;
    return after.agreement >= std::max(limits.agreement - kSlack, kLeastAgreement) &&
           after.sag <= limits.sag + kSlack * kNodeDistance &&
           after.cosineOfLeast <= std::max(limits.cosineOfLeast, kCosineOfLeastFacetAngle);
}

/// Of a node on the edge's lines; its end of the edge if the node is a vertex of the model.
std::optional<double> BoundaryGeometry::parameterOn(std::uint32_t edge, const MeshNode& node,
                                                    double near) const
{
    if (node.entity == EntityRef{1, edge}) return node.parameters.x;
    if (node.entity.dimension != 0) return {};
    const BrepEdge& own = model_.edges[BrepEdgeId(edge)];
    if (own.isClosed()) return near - own.part.first < own.part.last - near ? own.part.first : own.part.last;
    return own.first == BrepVertexId(node.entity.index) ? own.part.first : own.part.last;
}

/// The larger one of the chords beside a node of an edge, with the node there and its neighbours as they are or were at first.
std::optional<double> BoundaryGeometry::sagBeside(std::uint32_t edge, NodeId n, const MeshNode& place,
                                                  bool isAtFirst) const
{
    const std::optional<Vec3> own = tangentAt(edge, place.parameters.x);
    double largest = 0.0;
    for (const NodeId neighbour : complex_.lines(n)) {
        const MeshNode& other = isAtFirst ? first_[neighbour] : complex_.node(neighbour);
        const std::optional<double> t = parameterOn(edge, other, place.parameters.x);
        if (!own || !t) return {};
        const std::optional<Vec3> there = tangentAt(edge, *t);
        if (!there) return {};
        largest = std::max(largest, sagOf(other.position - place.position, *own, *there));
    }
    return largest;
}

/// Whether the chords at a node of an edge stay near to their curve.
bool BoundaryGeometry::keepsChords(const BoundaryMove& move) const
{
    const MeshNode& node = complex_.node(move.node);
    const std::uint32_t edge = node.entity.index;
    if (curve(edge).kind() == CurveKind::Line) return true;
    const std::optional<double> first = sagBeside(edge, move.node, first_[move.node], true);
    const std::optional<double> after =
        sagBeside(edge, move.node, {move.position, node.entity, move.parameters}, false);
    return first && after && *after <= largestSag(*first) + kSlack * kNodeDistance;
}

bool BoundaryGeometry::allows(BoundaryMove& move)
{
    if (complex_.node(move.node).entity.dimension == 1 && !keepsChords(move)) return false;
    if (!findCorners(move)) return false;
    Fidelity limits;
    Fidelity after;
    const auto facets = complex_.facets(move.node);
    for (std::size_t i = 0; i < facets.size(); ++i) {
        includeLimits(facets[i], limits);
        Corners corners = cornersOf(facets[i]);
        const FacetNodes& v = complex_.nodes(facets[i]);
        std::array<Vec3, 3> points = pointsOf(v);
        const auto k = static_cast<std::size_t>(std::find(v.begin(), v.end(), move.node) - v.begin());
        points[k] = move.position;
        corners.corner[k] = move.corners[i];
        judge(points, corners, after);
    }
    return isWithin(after, limits);
}

void BoundaryGeometry::commit(const BoundaryMove& move)
{
    const auto facets = complex_.facets(move.node);
    for (std::size_t i = 0; i < facets.size(); ++i) {
        const FacetNodes& v = complex_.nodes(facets[i]);
        const auto k = static_cast<std::size_t>(std::find(v.begin(), v.end(), move.node) - v.begin());
        corners_[facets[i]].corner[k] = move.corners[i];
    }
}

// ---- swaps -----------------------------------------------------------------------------------------------------------

bool BoundaryGeometry::arrange(const std::array<FacetId, 2>& facets, const FacetNodes& after,
                               Corners& corners)
{
    corners.side = cornersOf(facets[0]).side;
    if (cornersOf(facets[1]).side != corners.side) return false;
    for (std::size_t k = 0; k < 3; ++k) {
        for (const FacetId f : facets) {
            const FacetNodes& v = complex_.nodes(f);
            const auto at = std::find(v.begin(), v.end(), after[k]);
            if (at != v.end())
                corners.corner[k] = cornersOf(f).corner[static_cast<std::size_t>(at - v.begin())];
        }
    }
    return true;
}

bool BoundaryGeometry::allowsSwap(const std::array<FacetId, 2>& facets,
                                  const std::array<FacetNodes, 2>& after)
{
    Fidelity limits;
    Fidelity made;
    for (std::size_t i = 0; i < 2; ++i) {
        Corners corners;
        if (!arrange(facets, after[i], corners)) return false;
        judge(pointsOf(after[i]), corners, made);
        includeLimits(facets[i], limits);
    }
    return isWithin(made, limits);
}

void BoundaryGeometry::commitSwap(const std::array<FacetId, 2>& facets,
                                  const std::array<FacetNodes, 2>& after)
{
    std::array<Corners, 2> made;
    for (std::size_t i = 0; i < 2; ++i) {
        const bool isArranged = arrange(facets, after[i], made[i]);
        MESHER_INVARIANT(isArranged);
        static_cast<void>(isArranged);
    }
    for (std::size_t i = 0; i < 2; ++i) corners_[facets[i]] = made[i];
}

}  // namespace mesher
