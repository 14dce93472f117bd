#pragma once

#include "brep/brep_model.h"
#include "surface_sampling/curve_chains.h"
#include "surface_sampling/face_outline.h"
#include "surface_sampling/face_triangulation.h"

#include <cstddef>
#include <vector>

namespace mesher {

/// A pole of a face beside which the surface has all kinds of normals, as at the tip of a cone.
struct FaceApex
{
    BrepVertexId vertex;
    std::array<Vec2, 2> line;  ///< of the pole in the parameters, in the direction of the loop
    bool isAlongU = false;     ///< the line is one of equal v
    /// Where a ring around the apex has its points, as shares of the line: the facets between them and the apex have an angle of
    /// 50 degrees at the most there, and the surface's normal turns by 60 degrees at the most along their sides.
    std::vector<double> shares;
    double facetAngle = 0.0;  ///< at the apex, of the narrowest of these facets, degrees
};

/// Those of a face, by its degenerate edges.
[[nodiscard]] std::vector<FaceApex> apexesOf(const BrepModel& model, BrepFaceId face);

/// The edges of the face that end in one of its vertices and are no poles, ascending.
[[nodiscard]] std::vector<BrepEdgeId> edgesAt(const BrepModel& model, BrepFaceId face, BrepVertexId vertex);

/// Puts a ring of points around each apex of a face, as far from it as the shell that cuts the curves there, and holds the sides
/// of the ring. What lies between the ring and the apex is one fan of facets then. Refinement never gets the better of a tip:
/// in its own size it looks the same from near.
/// Returns the tips that have no ring, for want of room or of points on the curves at that distance.
/// Guarantees   FacePoint::isOnRing of the points on rings that are complete
/// Reference    [gosselin] §3.3.2.4 names the tip as a failure, §2.5 has the shells
std::size_t insertApexRings(const BrepModel& model, BrepFaceId face, const CurveChains& chains,
                            FaceTriangulation& t);

/// Does the point lie beside the fan of an apex, or in it, where points would crowd it?
[[nodiscard]] bool isAtFan(const BrepModel& model, BrepFaceId face, const CurveChains& chains,
                           const Vec3& point);

}  // namespace mesher
