#pragma once

#include "delaunay/local_delaunay3d.h"
#include "delaunay/tet_replacement3d.h"

#include <array>
#include <map>
#include <span>
#include <vector>

namespace mesher {

/// A closed polyhedron whose faces are triangles between vertices of a mesh.
class CavityShell
{
public:
    using Corners = std::array<VertexId, 3>;

    struct Face
    {
        Corners corner;  ///< ordered such that the inside is on their positive side
        TetFace outer;   ///< the face seen from outside; invalid for one that has nothing behind it yet
    };

    void clear() { faces_.clear(); }
    /// False if the same face is there already, in the same sense; one in the opposite sense takes it out again.
    bool add(const Face& face);
    void remove(const Corners& corner);
    /// By sorted corners.
    [[nodiscard]] const std::map<Corners, Face>& faces() const { return faces_; }

private:
    std::map<Corners, Face> faces_;
};

/// Fills polyhedra with Delaunay tetrahedra of their vertices, or with the star of one more point.
/// Reference    [shewchuk1998] [si2005] for cavities that are enlarged until their faces are Delaunay
class CavityRetriangulation
{
public:
    explicit CavityRetriangulation(const Triangulation3d& mesh) : mesh_(mesh) {}

    /// The Delaunay tetrahedra, of the vertices of the shell and those inside of it, that lie in the shell; false if a face
    /// of it is none of theirs, or `insideVertices` are not all used. Faces that are missing are listed.
    bool fillDelaunay(const CavityShell& shell, std::span<const VertexId> insideVertices,
                      std::vector<TetCorners>& filling);
    [[nodiscard]] const std::vector<CavityShell::Corners>& missing() const { return missing_; }

    /// A point that sees all faces of the shell from inside, exactly, as far from them as can be; false if the one that was
    /// found does not.
    bool findKernelPoint(const CavityShell& shell, Vec3& point) const;

private:
    bool flood(const CavityShell& shell, std::vector<TetCorners>& filling);

    const Triangulation3d& mesh_;
    LocalDelaunay3d local_;
    std::vector<VertexId> corners_;
    std::vector<CavityShell::Corners> missing_;
};

}  // namespace mesher
