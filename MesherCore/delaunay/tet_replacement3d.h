#pragma once

#include "delaunay/triangulation3d.h"

#include <array>
#include <span>
#include <vector>

namespace mesher {

/// Vertices of a tetrahedron to be made, positively oriented, the ghost last.
using TetCorners = std::array<VertexId, 4>;

/// The same orientation with the ghost, if any, in the last slot.
TetCorners withGhostLast(TetCorners corners);

/// Puts other tetrahedra in the place of some: the one step behind every flip, edge removal and vertex removal.
///
/// Guarantees   links, flags, regions and incident tetrahedra are right afterwards, constraints on the surface of the
///              replaced part are kept; slots are reused in order, so the outcome is deterministic, and a
///              replacement that is taken back at once (`created()` by the old corners) restores all ids
/// Requires     `after` fills the same space as `before` and has the same surface (asserted); the constrained faces inside
///              of `before` are those that the caller replaces by `constrainedFaces`; no constrained edge is inside
/// Cost         n log n in the number of faces
class TetReplacement3d
{
public:
    explicit TetReplacement3d(Triangulation3d& mesh) : mesh_(mesh) {}

    /// Returns one of the new tetrahedra. `constrainedFaces`: faces between new tetrahedra that become constrained.
    TetId replace(std::span<const TetId> before, std::span<const TetCorners> after,
                  std::span<const std::array<VertexId, 3>> constrainedFaces = {});

    /// The new tetrahedra of the last replacement, in the order of its `after`.
    [[nodiscard]] const std::vector<TetId>& created() const { return created_; }

private:
    /// A face to be linked, by its sorted corners; each stands twice in the list.
    struct OpenFace
    {
        std::array<VertexId, 3> corner;
        TetFace face;
        RegionId region;  ///< of the replaced tetrahedron behind it; meaningful if isOuter
        bool isOuter = false;
    };

    void collectSurface(std::span<const TetId> before);
    void create(std::span<const TetId> before, std::span<const TetCorners> after);
    void linkFaces();
    void giveRegion(TetId tet, RegionId region);
    void spreadRegions();
    void carryEdgeConstraints();

    Triangulation3d& mesh_;
    std::vector<OpenFace> faces_;
    std::vector<std::array<VertexId, 2>> constrainedEdges_;
    std::vector<TetId> created_;
    std::vector<TetId> regionFront_;  ///< new tetrahedra that have their region
};

}  // namespace mesher
