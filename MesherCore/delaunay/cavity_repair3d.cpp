#include "delaunay/cavity3d.h"

#include "predicates/orient3d.h"

#include <algorithm>

// Thesis §4.7.2: tetrahedra are taken out of a cavity until its point sees all of its surface.

namespace mesher {

void CavityOperator3d::refloodFromSeeds(std::span<const TetId> seeds)
{
    for (const TetId tet : cavity_.tets) {
        if (isMarked(tet)) mesh_.state(tet).flags |= tet_flag::kAllowed;
        unmark(tet);
    }
    previous_.swap(cavity_.tets);
    cavity_.tets.assign(seeds.begin(), seeds.end());
    cavity_.faces.clear();
    for (const TetId seed : seeds) mark(seed);
    for (std::size_t next = 0; next < cavity_.tets.size(); ++next) {
        const TetId inner = cavity_.tets[next];
        for (int face = 0; face < 4; ++face) {
            const TetFace outer = mesh_.neighbour(inner, face);
            const bool isForbidden = isCrossingForbidden({inner, face});
            if (!isForbidden && isMarked(outer.tet())) continue;
            if (!isForbidden && (mesh_.flags(outer.tet()) & tet_flag::kAllowed) != 0) {
                mark(outer.tet());
                cavity_.tets.push_back(outer.tet());
            } else {
                addFace(mesh_.tet(inner), static_cast<unsigned>(face), outer);
            }
        }
    }
    work_ += cavity_.tets.size();
    for (const TetId tet : previous_) {
        std::uint16_t& flags = mesh_.state(tet).flags;
        flags = static_cast<std::uint16_t>(flags & ~tet_flag::kAllowed);
    }
}

bool CavityOperator3d::repairOnce(std::span<const TetId> seeds, const StaticFilter3d& filter)
{
    if (repairEnclosedFaces(seeds, filter)) return true;
    if (cavity_.status == CavityStatus::Ready && repairEnclosedEdges(seeds, filter)) return true;
    return cavity_.status == CavityStatus::Ready && repairVisibility(seeds, filter);
}

bool CavityOperator3d::takeOut(TetId tet, std::span<const TetId> seeds, CavityStatus reason)
{
    if (!isMarked(tet)) return false;
    if (std::find(seeds.begin(), seeds.end(), tet) != seeds.end()) {
        cavity_.status = reason;
        return false;
    }
    unmark(tet);
    ++cavity_.repairs;
    return true;
}

bool CavityOperator3d::repairEnclosedFaces(std::span<const TetId> seeds, const StaticFilter3d& filter)
{
    bool isChanged = false;
    for (const CavityFace3d& face : cavity_.faces) {
        if (!isMarked(face.outer.tet())) continue;
        const TetFace inner = mesh_.neighbour(face.outer);
        if (!isMarked(inner.tet())) continue;
        // A face with the ghost has no plane; the side that is not a seed goes.
        const auto& v = face.vertex;
        const bool isBehind =
            isGhost(v[2]) || orient3d(filter, cavity_.point, mesh_.position(v[0]), mesh_.position(v[1]),
                                      mesh_.position(v[2])) != Sign::Positive;
        if (!isBehind) continue;  // the same face seen from the other side is in the list too
        if (takeOut(inner.tet(), seeds, CavityStatus::BlockedByConstraint)) isChanged = true;
        if (cavity_.status != CavityStatus::Ready) {
            cavity_.blocker = {v[0], v[1], v[2]};
            return false;
        }
    }
    return isChanged;
}

bool CavityOperator3d::isEdgeEnclosed(TetId tet, int edge) const
{
    const int* slots = kEdgeSlots[edge];
    const VertexId a = mesh_.vertex(tet, slots[0]);
    const VertexId b = mesh_.vertex(tet, slots[1]);
    int exit = 0;
    while (exit == slots[0] || exit == slots[1]) ++exit;
    for (TetId current = tet;;) {
        const TetFace entry = mesh_.neighbour(current, exit);
        current = entry.tet();
        if (current == tet) return true;
        if (!isMarked(current)) return false;
        exit = 6 - mesh_.slotOf(current, a) - mesh_.slotOf(current, b) - entry.face();
    }
}

TetId CavityOperator3d::tetBehindEdge(TetId tet, int edge, const StaticFilter3d& filter) const
{
    const VertexId a = mesh_.vertex(tet, kEdgeSlots[edge][0]);
    const VertexId b = mesh_.vertex(tet, kEdgeSlots[edge][1]);
    std::vector<TetId> ring;
    mesh_.collectEdgeRing(tet, a, b, ring);
    for (const TetId candidate : ring) {
        if (mesh_.isGhostTet(candidate)) continue;
        int behind = 0;
        int seen = 0;
        for (int face = 0; face < 4; ++face) {
            const VertexId opposite = mesh_.vertex(candidate, face);
            if (opposite == a || opposite == b) continue;
            const auto [f0, f1, f2] = mesh_.faceVertices({candidate, face});
            const Sign side =
                orient3d(filter, mesh_.position(f0), mesh_.position(f1), mesh_.position(f2), cavity_.point);
            behind += side == Sign::Negative ? 1 : 0;
            seen += side == Sign::Positive ? 1 : 0;
        }
        if (behind > 0 && seen == 0) return candidate;
    }
    return {};
}

bool CavityOperator3d::repairEnclosedEdges(std::span<const TetId> seeds, const StaticFilter3d& filter)
{
    for (const TetId tet : cavity_.tets) {
        if ((mesh_.flags(tet) & tet_flag::kEdges) == 0 && splitPerimeter_.empty()) continue;
        for (int edge = 0; edge < 6; ++edge) {
            const VertexId a = mesh_.vertex(tet, kEdgeSlots[edge][0]);
            const VertexId b = mesh_.vertex(tet, kEdgeSlots[edge][1]);
            // The parts of a split face stand on its perimeter, constrained edges or not.
            const bool isNeeded = mesh_.isEdgeConstrained(tet, edge) || isSplitPerimeter(a, b);
            if (isSplitEdge(a, b) || !isNeeded || !isEdgeEnclosed(tet, edge)) continue;
            const TetId behind = tetBehindEdge(tet, edge, filter);
            if (behind.isValid() && takeOut(behind, seeds, CavityStatus::BlockedByConstraint)) return true;
            cavity_.status = CavityStatus::BlockedByConstraint;
            cavity_.blocker = {a, b, VertexId()};
            return false;
        }
    }
    return false;
}

bool CavityOperator3d::repairVisibility(std::span<const TetId> seeds, const StaticFilter3d& filter)
{
    bool isChanged = false;
    for (const CavityFace3d& face : cavity_.faces) {
        const auto& v = face.vertex;
        if (isGhost(v[2])) continue;
        if (orient3d(filter, cavity_.point, mesh_.position(v[0]), mesh_.position(v[1]),
                     mesh_.position(v[2])) == Sign::Positive) {
            continue;
        }
        const TetId inner = mesh_.neighbour(face.outer).tet();
        if (takeOut(inner, seeds, CavityStatus::NotStarShaped)) isChanged = true;
        if (cavity_.status != CavityStatus::Ready) {
            if (mesh_.isFaceConstrained(face.outer)) cavity_.status = CavityStatus::BlockedByConstraint;
            cavity_.blocker = {v[0], v[1], v[2]};
            blockingFace_ = face.outer;
            return false;
        }
    }
    return isChanged;
}

}  // namespace mesher
