#pragma once

#include "delaunay/tet_replacement3d.h"
#include "delaunay/triangulation3d.h"

#include <array>
#include <functional>
#include <optional>
#include <vector>

namespace mesher {

/// A change of the connectivity that was evaluated and found valid; nothing is changed until it is applied.
struct Flip3d
{
    std::vector<TetId> before;
    std::vector<TetCorners> after;
    /// Constrained faces that a flip of a facet pair puts in the place of the old pair.
    std::vector<std::array<VertexId, 3>> constrainedFaces;
    /// Least value of the measure over `after`; 0 when no measure was given.
    double quality = 0.0;
};

/// Value of a positively oriented tetrahedron, larger is better.
using TetMeasure = std::function<double(const Vec3&, const Vec3&, const Vec3&, const Vec3&)>;

/// The flips of Figure 1.9 of the thesis and general edge removal, each as a question that changes nothing. All answer
/// nothing when the flip would make a tetrahedron that is not positively oriented (exactly), or would lose a constrained
/// face or edge; constraints on the surface of the flipped part are kept.
/// Reference    [lawson1977] [freitag1997] [gosselin] §1.2.5

/// 2-3: the face becomes an edge between the vertices opposite to it. Both tetrahedra must be finite.
std::optional<Flip3d> evaluateFlip23(const Triangulation3d& mesh, TetFace face);

/// 3-2: the edge, which must have three tetrahedra, becomes a face. All must be finite.
std::optional<Flip3d> evaluateFlip32(const Triangulation3d& mesh, TetId tet, int edge);

/// 4-4: the edge, which must have four tetrahedra, is replaced by one between two opposite ones of the four vertices
/// around it: `diagonal` 0 or 1, each with one end in `tet`.
/// A pair of coplanar constrained faces in the plane of the new edge is flipped with it; the edge may be a hull edge between
/// two coplanar hull faces, which makes it the 2-2 flip: then only the diagonal in that plane is possible.
std::optional<Flip3d> evaluateFlip44(const Triangulation3d& mesh, TetId tet, int edge, int diagonal);

/// 2-2: the hull edge between two coplanar hull faces is replaced by the other diagonal of their quadrilateral. The edge
/// must have two finite tetrahedra.
std::optional<Flip3d> evaluateFlip22(const Triangulation3d& mesh, TetId tet, int edge);

/// The number of tetrahedra around an edge beyond which its removal is not tried.
inline constexpr int kMaxEdgeRing = 12;

/// Removes an edge with 3 to kMaxEdgeRing finite tetrahedra, replacing its n tetrahedra by the 2n - 4 whose worst is best,
/// by Klincsek's dynamic programme over the triangulations of the ring. Cost: n³.
/// Reference    [klincsek1980] [freitag1997]
std::optional<Flip3d> evaluateEdgeRemoval(const Triangulation3d& mesh, TetId tet, int edge,
                                          const TetMeasure& measure);

/// Applies a flip that was evaluated on the mesh as it is. Returns one of the new tetrahedra.
TetId applyFlip(TetReplacement3d& replacement, const Flip3d& flip);

}  // namespace mesher
