#include "delaunay/tet_replacement3d.h"

#include <algorithm>
#include <tuple>
#include <utility>

namespace mesher {

namespace {

std::array<VertexId, 3> sortedCorners(std::array<VertexId, 3> face)
{
    std::sort(face.begin(), face.end());
    return face;
}

std::array<VertexId, 2> sortedEdge(VertexId a, VertexId b) { return {std::min(a, b), std::max(a, b)}; }

}  // namespace

TetCorners withGhostLast(TetCorners corners)
{
    for (unsigned slot = 0; slot < 3; ++slot) {
        if (!isGhost(corners[slot])) continue;
        std::swap(corners[slot], corners[3]);
        std::swap(corners[(slot + 1) % 3], corners[(slot + 2) % 3]);
        break;
    }
    return corners;
}

TetId TetReplacement3d::replace(std::span<const TetId> before, std::span<const TetCorners> after,
                                std::span<const std::array<VertexId, 3>> constrainedFaces)
{
    collectSurface(before);
    create(before, after);
    linkFaces();
    spreadRegions();
    carryEdgeConstraints();
    for (const auto& corners : constrainedFaces) {
        const auto wanted = sortedCorners(corners);
        for (const OpenFace& open : faces_) {
            if (!open.isOuter && open.corner == wanted) mesh_.setFaceConstrained(open.face, true);
        }
    }
    return created_.front();
}

void TetReplacement3d::collectSurface(std::span<const TetId> before)
{
    faces_.clear();
    constrainedEdges_.clear();
    for (const TetId tet : before) mesh_.state(tet).flags |= tet_flag::kInCavity;
    for (const TetId tet : before) {
        for (int i = 0; i < 4; ++i) {
            const TetFace outer = mesh_.neighbour(tet, i);
            if ((mesh_.flags(outer.tet()) & tet_flag::kInCavity) != 0) continue;
            faces_.push_back({sortedCorners(mesh_.faceVertices(outer)), outer, mesh_.region(tet), true});
        }
        for (int edge = 0; edge < 6; ++edge) {
            if (!mesh_.isEdgeConstrained(tet, edge)) continue;
            constrainedEdges_.push_back(
                sortedEdge(mesh_.vertex(tet, kEdgeSlots[edge][0]), mesh_.vertex(tet, kEdgeSlots[edge][1])));
        }
    }
    std::sort(constrainedEdges_.begin(), constrainedEdges_.end());
    constrainedEdges_.erase(std::unique(constrainedEdges_.begin(), constrainedEdges_.end()),
                            constrainedEdges_.end());
}

void TetReplacement3d::create(std::span<const TetId> before, std::span<const TetCorners> after)
{
    created_.clear();
    const std::size_t reused = std::min(before.size(), after.size());
    for (std::size_t i = 0; i < after.size(); ++i) {
        const TetId tet = i < reused ? before[i] : mesh_.allocateTet();
        if (i < reused) mesh_.renewTet(tet);
        created_.push_back(tet);
        mesh_.tet(tet).vertex = after[i];
        mesh_.setRegion(tet, kExteriorRegion);
        // The mark stands for: has no region yet.
        if (!isGhost(after[i][3])) mesh_.state(tet).flags |= tet_flag::kAllowed;
        for (const VertexId v : after[i]) {
            if (!isGhost(v)) mesh_.setIncidentTet(v, tet);
        }
    }
    // The last one first, so that a replacement taken back gets the slots it had, in their order.
    for (std::size_t i = before.size(); i > reused; --i) mesh_.freeTet(before[i - 1]);
    for (const TetId tet : created_) {
        for (int i = 0; i < 4; ++i) {
            const TetFace face(tet, i);
            faces_.push_back({sortedCorners(mesh_.faceVertices(face)), face, kExteriorRegion, false});
        }
    }
}

void TetReplacement3d::linkFaces()
{
    std::sort(faces_.begin(), faces_.end(), [](const OpenFace& a, const OpenFace& b) {
        return std::tie(a.corner, b.isOuter, a.face) < std::tie(b.corner, a.isOuter, b.face);
    });
    regionFront_.clear();
    MESHER_INVARIANT(faces_.size() % 2 == 0);
    for (std::size_t i = 0; i + 1 < faces_.size(); i += 2) {
        const OpenFace& first = faces_[i];  // an outer face stands before the new one it is linked to
        const OpenFace& second = faces_[i + 1];
        MESHER_INVARIANT(first.corner == second.corner && !second.isOuter);
        mesh_.link(first.face, second.face);
        if (!first.isOuter) continue;
        if (mesh_.isFaceConstrained(first.face)) {
            mesh_.state(second.face.tet()).flags |= tet_flag::face(second.face.face());
        }
        if (!mesh_.isGhostTet(second.face.tet())) giveRegion(second.face.tet(), first.region);
    }
}

void TetReplacement3d::giveRegion(TetId tet, RegionId region)
{
    std::uint16_t& flags = mesh_.state(tet).flags;
    if ((flags & tet_flag::kAllowed) == 0) return;
    flags = static_cast<std::uint16_t>(flags & ~tet_flag::kAllowed);
    mesh_.setRegion(tet, region);
    regionFront_.push_back(tet);
}

/// A new tetrahedron without a face on the surface lies in the region of those around it. Ghosts are exterior.
void TetReplacement3d::spreadRegions()
{
    for (std::size_t next = 0; next < regionFront_.size(); ++next) {
        const TetId tet = regionFront_[next];
        for (int i = 0; i < 4; ++i) giveRegion(mesh_.neighbour(tet, i).tet(), mesh_.region(tet));
    }
    MESHER_INVARIANT(std::none_of(created_.begin(), created_.end(),
                                  [&](TetId tet) { return (mesh_.flags(tet) & tet_flag::kAllowed) != 0; }));
}

void TetReplacement3d::carryEdgeConstraints()
{
    if (constrainedEdges_.empty()) return;
    for (const TetId tet : created_) {
        for (int edge = 0; edge < 6; ++edge) {
            const auto ends =
                sortedEdge(mesh_.vertex(tet, kEdgeSlots[edge][0]), mesh_.vertex(tet, kEdgeSlots[edge][1]));
            if (!std::binary_search(constrainedEdges_.begin(), constrainedEdges_.end(), ends)) continue;
            mesh_.state(tet).flags |= tet_flag::edge(edge);
        }
    }
}

}  // namespace mesher
