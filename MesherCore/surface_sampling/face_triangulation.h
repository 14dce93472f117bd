#pragma once

#include "base/indexed_map.h"
#include "base/result.h"
#include "brep/brep_model.h"
#include "delaunay/delaunay2d.h"
#include "surface_sampling/curve_chains.h"
#include "surface_sampling/face_outline.h"

#include <cstdint>
#include <utility>
#include <vector>

namespace mesher {

/// A vertex of a face's triangulation in the plane.
struct FacePoint
{
    Vec2 uv;
    Vec3 position;
    Vec3 normal;  ///< of the surface, of length 1; zero where the parametrisation is singular
    NodeId node;  ///< invalid for points inside of the face
    bool isPole = false;
    bool isPoleAlongU = false;
    bool isOnRing = false;  ///< around the tip of the face, see apex_rings.h
};

/// The constrained Delaunay triangulation of a face's outline in the plane. Region 1 is the face.
struct FaceTriangulation
{
    static constexpr RegionId kInside{1};

    Delaunay2d delaunay;
    FaceScaling scaling;
    double size = 0.0;
    IdVector<VertexId, FacePoint> points;
    /// The piece of the outline on each constrained edge, one of them if there are two.
    IndexedMap<std::pair<VertexId, VertexId>, std::uint32_t> pieceOf;
    /// Segments whose chords cross or hide what they must not: nothing else holds of the triangulation then.
    std::vector<SegmentId> tooCoarse;

    [[nodiscard]] const Triangulation2d& mesh() const { return delaunay.mesh(); }
    [[nodiscard]] bool isInside(TriangleId t) const
    {
        return !mesh().triangle(t).isGhost() && mesh().triangle(t).region == kInside;
    }
    /// Does the surface beside the piece, from a to b, up to a corner p have less width than the piece has sag, about? Facets
    /// there would lie off the surface by as much as they are wide.
    [[nodiscard]] static bool isNarrowBeside(const OutlinePiece& piece, const Vec3& a, const Vec3& b,
                                             const Vec3& p);
    /// Zero where the parametrisation is singular.
    [[nodiscard]] static Vec3 unitNormal(const SurfacePoint& point);
};

/// Triangulates an outline; exact predicates decide what lies inside.
/// Guarantees   every piece is an edge; regions are those the loops wind around once
/// Refuses      pieces that cross although their parameter curves are straight, loops that wind around nothing or around
///              something twice
/// Cost         O(n log n), quadratic in the number of crossings
[[nodiscard]] Result<FaceTriangulation> triangulateOutline(const BrepModel& model, BrepFaceId face,
                                                           const CurveChains& chains,
                                                           const IdVector<NodeId, MeshNode>& nodes,
                                                           const FaceOutline& outline);

}  // namespace mesher
