#include "delaunay/flips3d.h"

#include "predicates/orient3d.h"

#include <algorithm>
#include <limits>

namespace mesher {

namespace {

bool isPositive(const Triangulation3d& mesh, const TetCorners& v)
{
    return orient3d(mesh.position(v[0]), mesh.position(v[1]), mesh.position(v[2]), mesh.position(v[3])) ==
           Sign::Positive;
}

bool hasGhost(const TetCorners& corners) { return std::any_of(corners.begin(), corners.end(), isGhost); }

/// An edge and what is around it: tets[i] has the vertices from, to, link[i] and link[i + 1], positively oriented in that
/// order.
struct EdgeStar
{
    VertexId from;
    VertexId to;
    std::vector<TetId> tets;
    std::vector<VertexId> link;

    EdgeStar(const Triangulation3d& mesh, TetId tet, int edge)
        : from(mesh.vertex(tet, kEdgeSlots[edge][1])), to(mesh.vertex(tet, kEdgeSlots[edge][0]))
    {
        // The ring about (a, b) turns in negative sense, so it is positive about (b, a).
        mesh.collectEdgeRing(tet, to, from, tets);
        for (std::size_t i = 0; i < tets.size(); ++i) link.push_back(sharedWith(mesh, i));
    }

    [[nodiscard]] std::size_t size() const { return tets.size(); }

private:
    [[nodiscard]] VertexId sharedWith(const Triangulation3d& mesh, std::size_t i) const
    {
        const TetId previous = tets[(i + tets.size() - 1) % tets.size()];
        for (const VertexId v : mesh.tet(tets[i]).vertex) {
            if (v == from || v == to || mesh.slotOf(previous, v) < 0) continue;
            return v;
        }
        MESHER_INVARIANT(false);
        return {};
    }
};

int constrainedFacesAround(const Triangulation3d& mesh, const EdgeStar& star,
                           std::vector<bool>& isConstrained)
{
    isConstrained.assign(star.size(), false);
    for (std::size_t i = 0; i < star.size(); ++i) {
        // The face (from, to, link[i]) of tets[i] is opposite link[i + 1].
        const int opposite = mesh.slotOf(star.tets[i], star.link[(i + 1) % star.size()]);
        isConstrained[i] = mesh.isFaceConstrained({star.tets[i], opposite});
    }
    return static_cast<int>(std::count(isConstrained.begin(), isConstrained.end(), true));
}

/// The two tetrahedra on a triangle of the ring, counted in the sense of the ring.
std::array<TetCorners, 2> tetsOnTriangle(const EdgeStar& star, std::size_t i, std::size_t j, std::size_t k)
{
    return {TetCorners{star.link[i], star.link[j], star.link[k], star.to},
            TetCorners{star.link[j], star.link[i], star.link[k], star.from}};
}

bool isFinite(const Triangulation3d& mesh, const EdgeStar& star)
{
    return std::none_of(star.tets.begin(), star.tets.end(), [&](TetId t) { return mesh.isGhostTet(t); });
}

/// Klincsek's programme over the polygon of the ring: best[i][j] is the best worst value of a triangulation of the
/// vertices i to j, apex[i][j] the vertex on edge (i, j) that gives it.
class RingTriangulation
{
public:
    RingTriangulation(const Triangulation3d& mesh, const EdgeStar& star, const TetMeasure& measure)
        : mesh_(mesh), star_(star), measure_(measure)
    {
        const std::size_t n = star.size();
        for (std::size_t length = 2; length < n; ++length) {
            for (std::size_t i = 0; i + length < n; ++i) solve(i, i + length);
        }
    }

    [[nodiscard]] double quality() const { return best_[0][star_.size() - 1]; }

    void appendTets(std::vector<TetCorners>& tets) const { append(0, star_.size() - 1, tets); }

private:
    static constexpr double kImpossible = -std::numeric_limits<double>::infinity();

    void solve(std::size_t i, std::size_t j)
    {
        best_[i][j] = kImpossible;
        for (std::size_t k = i + 1; k < j; ++k) {
            double value = std::min(sideValue(i, k), sideValue(k, j));
            if (value <= best_[i][j]) continue;
            value = std::min(value, triangleValue(i, k, j));
            if (value <= best_[i][j]) continue;
            best_[i][j] = value;
            apex_[i][j] = k;
        }
    }
    [[nodiscard]] double sideValue(std::size_t i, std::size_t j) const
    {
        return j == i + 1 ? std::numeric_limits<double>::infinity() : best_[i][j];
    }
    [[nodiscard]] double triangleValue(std::size_t i, std::size_t j, std::size_t k) const
    {
        double value = std::numeric_limits<double>::infinity();
        for (const TetCorners& v : tetsOnTriangle(star_, i, j, k)) {
            if (!isPositive(mesh_, v)) return kImpossible;
            value = std::min(value, measure_(mesh_.position(v[0]), mesh_.position(v[1]), mesh_.position(v[2]),
                                             mesh_.position(v[3])));
        }
        return value;
    }
    void append(std::size_t i, std::size_t j, std::vector<TetCorners>& tets) const
    {
        if (j == i + 1) return;
        const std::size_t k = apex_[i][j];
        for (const TetCorners& v : tetsOnTriangle(star_, i, k, j)) tets.push_back(v);
        append(i, k, tets);
        append(k, j, tets);
    }

    const Triangulation3d& mesh_;
    const EdgeStar& star_;
    const TetMeasure& measure_;
    double best_[kMaxEdgeRing][kMaxEdgeRing] = {};
    std::size_t apex_[kMaxEdgeRing][kMaxEdgeRing] = {};
};

}  // namespace

std::optional<Flip3d> evaluateFlip23(const Triangulation3d& mesh, TetFace face)
{
    const TetFace other = mesh.neighbour(face);
    if (mesh.isGhostTet(face.tet()) || mesh.isGhostTet(other.tet()) || mesh.isFaceConstrained(face))
        return {};
    const VertexId above = mesh.vertex(face.tet(), face.face());
    const VertexId below = mesh.vertex(other.tet(), other.face());
    const auto corner = mesh.faceVertices(face);
    Flip3d flip;
    flip.before = {face.tet(), other.tet()};
    for (unsigned k = 0; k < 3; ++k) {
        const TetCorners tet{corner[k], corner[(k + 1) % 3], below, above};
        if (!isPositive(mesh, tet)) return {};
        flip.after.push_back(tet);
    }
    return flip;
}

std::optional<Flip3d> evaluateFlip32(const Triangulation3d& mesh, TetId tet, int edge)
{
    const EdgeStar star(mesh, tet, edge);
    std::vector<bool> isConstrained;
    if (star.size() != 3 || !isFinite(mesh, star) || mesh.isEdgeConstrained(tet, edge) ||
        constrainedFacesAround(mesh, star, isConstrained) > 0) {
        return {};
    }
    Flip3d flip;
    flip.before = star.tets;
    for (const TetCorners& corners : tetsOnTriangle(star, 0, 1, 2)) {
        if (!isPositive(mesh, corners)) return {};
        flip.after.push_back(corners);
    }
    return flip;
}

std::optional<Flip3d> evaluateFlip44(const Triangulation3d& mesh, TetId tet, int edge, int diagonal)
{
    const EdgeStar star(mesh, tet, edge);
    if (star.size() != 4 || mesh.isEdgeConstrained(tet, edge)) return {};
    const std::size_t i = diagonal == 0 ? 0 : 1;
    const std::size_t j = i + 2;
    const VertexId endI = star.link[i];
    const VertexId endJ = star.link[j];
    if (isGhost(endI) || isGhost(endJ) || isGhost(star.from) || isGhost(star.to)) return {};
    std::vector<bool> isConstrained;
    const int constrained = constrainedFacesAround(mesh, star, isConstrained);
    const bool movesConstraints = constrained == 2 && isConstrained[i] && isConstrained[j];
    if (constrained > 0 && !movesConstraints) return {};
    // Constrained faces and hull faces keep their place, so they can only be flipped within one plane.
    const bool isCoplanarNeeded = movesConstraints || !isFinite(mesh, star);
    if (isCoplanarNeeded && orient3d(mesh.position(star.from), mesh.position(star.to), mesh.position(endI),
                                     mesh.position(endJ)) != Sign::Zero) {
        return {};
    }
    Flip3d flip;
    flip.before = star.tets;
    for (const auto& pair : {tetsOnTriangle(star, i, i + 1, j), tetsOnTriangle(star, j, (j + 1) % 4, i)}) {
        for (const TetCorners& corners : pair) {
            if (!hasGhost(corners) && !isPositive(mesh, corners)) return {};
            flip.after.push_back(withGhostLast(corners));
        }
    }
    if (movesConstraints) flip.constrainedFaces = {{endI, endJ, star.from}, {endI, endJ, star.to}};
    return flip;
}

std::optional<Flip3d> evaluateFlip22(const Triangulation3d& mesh, TetId tet, int edge)
{
    const EdgeStar star(mesh, tet, edge);
    if (star.size() != 4 || isFinite(mesh, star)) return {};
    const auto ghost = std::find(star.link.begin(), star.link.end(), kGhostVertex);
    if (ghost == star.link.end()) return {};
    return evaluateFlip44(mesh, tet, edge, (ghost - star.link.begin()) % 2 == 0 ? 1 : 0);
}

std::optional<Flip3d> evaluateEdgeRemoval(const Triangulation3d& mesh, TetId tet, int edge,
                                          const TetMeasure& measure)
{
    const EdgeStar star(mesh, tet, edge);
    std::vector<bool> isConstrained;
    if (star.size() > kMaxEdgeRing || !isFinite(mesh, star) || mesh.isEdgeConstrained(tet, edge) ||
        constrainedFacesAround(mesh, star, isConstrained) > 0) {
        return {};
    }
    const RingTriangulation triangulation(mesh, star, measure);
    if (!std::isfinite(triangulation.quality())) return {};
    Flip3d flip;
    flip.before = star.tets;
    triangulation.appendTets(flip.after);
    flip.quality = triangulation.quality();
    return flip;
}

TetId applyFlip(TetReplacement3d& replacement, const Flip3d& flip)
{
    return replacement.replace(flip.before, flip.after, flip.constrainedFaces);
}

}  // namespace mesher
