#pragma once

#include "delaunay/cavity_retriangulation.h"

#include <span>
#include <vector>

namespace mesher {

/// Fills tetrahedra anew with the Delaunay tetrahedra of their vertices, or of these but one. The hole grows where its surface
/// is not Delaunay, up to constrained faces.
/// Guarantees   constraints stay, or nothing is changed
/// Reference    [shewchuk1998] [si2005] for cavities that are enlarged until their faces are Delaunay
class HoleRefill
{
public:
    explicit HoleRefill(Triangulation3d& mesh) : mesh_(mesh), replacement_(mesh), cavities_(mesh) {}

    /// The vertex `without`, if it is valid, is left without tetrahedra; all of its own are to be among `tets`. False if
    /// constraints are in the way, or more than `most` tetrahedra would be needed.
    bool refill(std::span<const TetId> tets, VertexId without, std::size_t most);

    [[nodiscard]] const std::vector<TetId>& created() const { return replacement_.created(); }

private:
    bool makeShell(VertexId without);
    bool enlarge(std::size_t most);

    Triangulation3d& mesh_;
    TetReplacement3d replacement_;
    CavityRetriangulation cavities_;
    std::vector<TetId> tets_;
    CavityShell shell_;
    std::vector<VertexId> inside_;
    std::vector<TetCorners> filling_;
};

/// Whether each constrained edge of the tetrahedra is an edge of some of the others.
[[nodiscard]] bool keepsConstrainedEdges(const Triangulation3d& mesh, std::span<const TetId> before,
                                         std::span<const TetCorners> after);

}  // namespace mesher
