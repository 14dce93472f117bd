#pragma once

#include "delaunay/local_delaunay3d.h"
#include "delaunay/tet_replacement3d.h"
#include "delaunay/triangulation3d.h"

#include <array>
#include <vector>

namespace mesher {

enum class VertexHole3d : std::uint8_t
{
    Ready,
    OnConstraint,    ///< a constrained edge or face ends at the vertex
    Untriangulable,  ///< a face of the hole is no face of the Delaunay tetrahedra of its vertices, or there are
                     ///< constraints and without the vertex no tetrahedra to hold them
    WholeSpace       ///< without the vertex the others do not span space
};

/// Removal of a vertex in two phases: `find` evaluates and changes nothing but scratch, `commit` cannot fail. The hole is
/// filled with those Delaunay tetrahedra of its own vertices that lie in it.
///
/// Guarantees   without constraints the result is the Delaunay tetrahedralization of the other vertices; constraints
///              around the hole are kept
/// Cost         that of tetrahedralizing the neighbours of the vertex
/// Reference    [devillers2011b] the hole is filled from the triangulation of the link; the perturbation makes both agree
class VertexRemoval3d
{
public:
    explicit VertexRemoval3d(Triangulation3d& mesh);
    VertexRemoval3d(const VertexRemoval3d&) = delete;
    VertexRemoval3d& operator=(const VertexRemoval3d&) = delete;

    VertexHole3d find(VertexId vertex);
    /// Fills the hole found last, which must be Ready, and removes the vertex. Returns a tetrahedron of the filling.
    TetId commit();
    /// The filling that the last commit made.
    [[nodiscard]] const std::vector<TetId>& created() const { return replacement_.created(); }

private:
    /// A face of the hole: its corners ordered for the inside, the smallest first, and the face seen from outside.
    struct HoleFace
    {
        std::array<VertexId, 3> corner;
        TetFace outer;
    };

    bool isOnConstraint() const;
    bool hasConstraint() const;
    void collectHole();
    void fillFlatHole();
    bool fillFromDelaunay();
    bool isHoleFace(const std::array<VertexId, 3>& corner) const;

    Triangulation3d& mesh_;
    VertexId vertex_;
    std::vector<TetId> star_;
    std::vector<HoleFace> holeFaces_;
    std::vector<VertexId> corners_;  ///< finite vertices of the hole
    std::vector<TetCorners> filling_;
    TetReplacement3d replacement_;
    LocalDelaunay3d local_;
};

}  // namespace mesher
