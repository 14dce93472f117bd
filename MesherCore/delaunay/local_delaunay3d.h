#pragma once

#include "delaunay/tet_replacement3d.h"
#include "delaunay/triangulation3d.h"

#include <memory>
#include <span>
#include <vector>

namespace mesher {

class Delaunay3d;

/// The Delaunay tetrahedralization of a few vertices of a mesh, and of it the part that faces enclose: what a hole or a
/// polyhedron is filled with. Memory is used again from one to the next.
/// Cost         that of inserting the vertices
class LocalDelaunay3d
{
public:
    LocalDelaunay3d();
    ~LocalDelaunay3d();

    /// `corners`: ascending, each once. Forgets what was enclosed.
    void triangulate(const Triangulation3d& mesh, std::span<const VertexId> corners);
    [[nodiscard]] bool isInSpace() const;
    /// Its vertices count from 0 in the order of the corners.
    [[nodiscard]] const Triangulation3d& tets() const;
    /// The corner that a vertex of it stands for; the ghost stands for itself.
    [[nodiscard]] VertexId original(VertexId vertex) const
    {
        return isGhost(vertex) ? vertex : corners_[vertex.value];
    }

    /// The flood does not leave through this face; it begins at its tetrahedron if that is inside.
    void bound(TetFace face, bool isInside);
    /// Appends the tetrahedra that are reached, by the vertices of the mesh, ghosts included; false, with some of them, if
    /// there is a ghost among them and none is allowed.
    bool flood(bool areGhostsAllowed, std::vector<TetCorners>& filling);

private:
    std::unique_ptr<Delaunay3d> delaunay_;  ///< made on first use: it owns those that own this
    std::vector<VertexId> corners_;
    std::vector<TetId> queue_;
    std::vector<char> isInside_;   ///< by tetrahedron
    std::vector<char> isBounded_;  ///< by face
};

}  // namespace mesher
