#include "tetrahedralization/coplanar_swap.h"

#include "predicates/orient3d.h"

#include <algorithm>
#include <cmath>

namespace mesher {

namespace {

/// The slope against the plane up to which a face counts as lying in it.
constexpr double kNearlyPlane = 1e-7;
/// How near to the plane an added vertex may come, as a share of what is above.
constexpr double kLeastStarShare = 1e-6;

}  // namespace

bool CoplanarSwap::isPositive(const TetCorners& tet) const
{
    return orient3d(mesh_.position(tet[0]), mesh_.position(tet[1]), mesh_.position(tet[2]),
                    mesh_.position(tet[3])) == Sign::Positive;
}

/// The tetrahedra on a triangle of the link, counted in the sense of the ring.
std::array<TetCorners, 2> CoplanarSwap::tetsOn(VertexId p, VertexId q, VertexId r) const
{
    return {TetCorners{p, q, r, edge_[0]}, TetCorners{q, p, r, edge_[1]}};
}

/// Of the link of the edge, the vertices near the plane of edge and line, by side. Where coordinates are rounded what was
/// plane is only nearly so: whether a swap is possible is then decided when the sides are filled.
bool CoplanarSwap::findPlane(VertexId a, VertexId b)
{
    const Vec3 c = mesh_.position(edge_[0]);
    along_ = mesh_.position(edge_[1]) - c;
    normal_ = cross(along_, mesh_.position(b) - mesh_.position(a));
    if (normal_ == Vec3{}) return false;
    const Vec3 across = cross(normal_, along_);
    for (auto& side : nearPlane_) side.clear();
    for (std::size_t i = 0; i < link_.size(); ++i) {
        const Vec3 arm = mesh_.position(link_[i]) - c;
        const double reach = dot(across, arm) / length(across);
        if (std::abs(dot(normal_, arm)) <= kNearlyPlane * length(normal_) * std::abs(reach))
            nearPlane_[reach < 0.0 ? 0 : 1].push_back(i);
    }
    return !nearPlane_[0].empty() && !nearPlane_[1].empty();
}

/// Whether the diagonal between two vertices of the link passes through the inside of the edge.
bool CoplanarSwap::isDiagonal(std::size_t from, std::size_t to)
{
    const std::size_t n = link_.size();
    if ((from + 1) % n == to || (to + 1) % n == from) return false;
    const Vec3 c = mesh_.position(edge_[0]);
    const Vec3 u = mesh_.position(link_[from]);
    const Vec3 diagonal = mesh_.position(link_[to]) - u;
    const double t = dot(cross(u - c, diagonal), normal_) / dot(cross(along_, diagonal), normal_);
    crossing_ = c + t * along_;
    return t > kNearlyPlane && t < 1.0 - kNearlyPlane;
}

bool CoplanarSwap::fill(std::size_t from, std::size_t to)
{
    after_.clear();
    added_.clear();
    if (isDiagonal(from, to) && fillSide(from, to) && fillSide(to, from)) return true;
    for (const VertexId vertex : added_) mesh_.removeVertex(vertex);
    return false;
}

bool CoplanarSwap::swap(const std::array<VertexId, 2>& edge, VertexId a, VertexId b)
{
    edge_ = edge;
    const TetId start = mesh_.findEdge(edge[0], edge[1]);
    if (!start.isValid()) return false;
    mesh_.collectEdgeRing(start, edge[0], edge[1], ring_);
    if (mesh_.isEdgeConstrained(start,
                                kEdgeOfSlots[mesh_.slotOf(start, edge[0])][mesh_.slotOf(start, edge[1])]))
        return false;
    link_.clear();
    for (std::size_t i = 0; i < ring_.size(); ++i) {
        if (mesh_.isGhostTet(ring_[i])) return false;
        const TetId previous = ring_[(i + ring_.size() - 1) % ring_.size()];
        for (int slot = 0; slot < 4; ++slot) {
            const VertexId v = mesh_.vertex(ring_[i], slot);
            if (v == edge[0] || v == edge[1]) continue;
            if (mesh_.isFaceConstrained({ring_[i], slot})) return false;
            if (mesh_.slotOf(previous, v) >= 0) link_.push_back(v);
        }
    }
    if (link_.size() != ring_.size() || !findPlane(a, b)) return false;
    // The ring may turn in either sense about the edge; of the ends the first is to be in front of it.
    if (isPositive({link_[0], link_[1], edge_[0], edge_[1]})) std::swap(edge_[0], edge_[1]);
    for (const std::size_t from : nearPlane_[0]) {
        for (const std::size_t to : nearPlane_[1]) {
            if (!fill(from, to)) continue;
            flips_.replace(ring_, after_, added_);
            return true;
        }
    }
    return false;
}

bool CoplanarSwap::fillSide(std::size_t from, std::size_t to)
{
    std::vector<VertexId> chain;
    for (std::size_t i = from; i != to; i = (i + 1) % link_.size()) chain.push_back(link_[i]);
    chain.push_back(link_[to]);
    return fillByRing(chain) || fillByStar(chain, from, to);
}

/// Tetrahedra on triangles of the polygon that the chain and the new diagonal make, if there are such.
bool CoplanarSwap::fillByRing(const std::vector<VertexId>& chain)
{
    const std::size_t n = chain.size();
    constexpr std::size_t kNone = ~std::size_t{0};
    std::vector<std::size_t> apex(n * n, kNone);
    const auto isSolved = [&](std::size_t i, std::size_t j) {
        return j == i + 1 || apex[i * n + j] != kNone;
    };
    for (std::size_t length = 2; length < n; ++length) {
        for (std::size_t i = 0; i + length < n; ++i) {
            const std::size_t j = i + length;
            for (std::size_t k = i + 1; k < j; ++k) {
                if (!isSolved(i, k) || !isSolved(k, j)) continue;
                const auto tets = tetsOn(chain[i], chain[k], chain[j]);
                if (!isPositive(tets[0]) || !isPositive(tets[1])) continue;
                apex[i * n + j] = k;
                break;
            }
        }
    }
    if (!isSolved(0, n - 1)) return false;
    std::vector<std::pair<std::size_t, std::size_t>> open{{0, n - 1}};
    while (!open.empty()) {
        const auto [i, j] = open.back();
        open.pop_back();
        if (j == i + 1) continue;
        const std::size_t k = apex[i * n + j];
        for (const TetCorners& tet : tetsOn(chain[i], chain[k], chain[j])) after_.push_back(tet);
        open.emplace_back(i, k);
        open.emplace_back(k, j);
    }
    return true;
}

/// From the crossing of the diagonals all outer faces of the side are seen; a little off the plane the inner two are as well.
bool CoplanarSwap::findStarPoint(const std::vector<VertexId>& chain, const CavityShell& shell,
                                 Vec3& point) const
{
    Vec3 middle;
    for (std::size_t i = 1; i + 1 < chain.size(); ++i) middle = middle + mesh_.position(chain[i]);
    middle = (1.0 / static_cast<double>(chain.size() - 2)) * middle;
    for (double share = 0.25; share > kLeastStarShare; share *= 0.25) {
        point = crossing_ + share * (middle - crossing_);
        const bool seesAll = std::all_of(shell.faces().begin(), shell.faces().end(), [&](const auto& face) {
            const auto& v = face.second.corner;
            return orient3d(mesh_.position(v[0]), mesh_.position(v[1]), mesh_.position(v[2]), point) ==
                   Sign::Positive;
        });
        if (seesAll) return true;
    }
    return false;
}

bool CoplanarSwap::fillByStar(const std::vector<VertexId>& chain, std::size_t from, std::size_t to)
{
    CavityShell shell;
    for (std::size_t i = from; i != to; i = (i + 1) % link_.size()) {
        for (const VertexId end : edge_) {
            const TetFace face(ring_[i], mesh_.slotOf(ring_[i], end));
            shell.add({mesh_.faceVertices(face), mesh_.neighbour(face)});
        }
    }
    // As the tetrahedra of tetsOn have them, whatever side of a nearly plane base a vertex of the chain is on.
    shell.add({{chain.front(), chain.back(), edge_[0]}, TetFace()});
    shell.add({{chain.back(), chain.front(), edge_[1]}, TetFace()});
    Vec3 point;
    if (!findStarPoint(chain, shell, point)) return false;
    const VertexId centre = mesh_.addVertex(point);
    added_.push_back(centre);
    for (const auto& [key, face] : shell.faces()) {
        after_.push_back({face.corner[0], face.corner[1], face.corner[2], centre});
    }
    return true;
}

}  // namespace mesher
