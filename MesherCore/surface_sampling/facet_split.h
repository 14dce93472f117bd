#pragma once

#include "surface_sampling/face_mesh.h"
#include "surface_sampling/face_star.h"
#include "surface_sampling/facet_criteria.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace mesher {

enum class FacetSplitStatus : std::uint8_t
{
    Ready,
    Encroaches,  ///< on the segments that are named, which are to be split first
    TooSmall,    ///< the new vertex would be nearer to others than the floor
    NotFound     ///< no point of the surface was found for the facet
};

struct FacetSplitOptions
{
    /// The least distance of a new vertex from others, model units.
    double floor = 0.0;
    /// A vertex that sees a segment under a larger angle encroaches on it, degrees: 90 is the diametral ball, 120 the lens of
    /// [shewchuk2002].
    double encroachmentAngle = 90.0;
};

struct FacetSplitCounts
{
    std::size_t projectedCentres = 0;  ///< no surface ball was found: the circumcentre was projected
    std::size_t splitEdges = 0;        ///< nor was that of use: the longest edge was split
    std::size_t lostWalks = 0;
    std::size_t foldedStars = 0;  ///< new vertices that were not inserted for that reason
    std::size_t steepStars = 0;   ///< new vertices beside steep facets, for want of others
};

/// Finds the vertex that removes a facet: at the centre of its surface ball, else at the projection of its circumcentre, else
/// in the middle of its longest edge, which comes first where the facet is larger than the surface's radius of curvature, so
/// that balls say nothing; and the star that the vertex will have. Nothing is changed.
/// Guarantees   the vertex is an exact point of the surface that a walk over the facets has found to be in the face
/// Reference    [chew1993]; thesis §3.3.2.3
class FacetSplitter
{
public:
    FacetSplitter(FaceMesh& mesh, const FaceGeometry& geometry, const FacetCriteria& criteria,
                  const FacetSplitOptions& options);

    /// For the sake of quality edges are halved only where facets are coarse for the surface's curvature: elsewhere that would
    /// make them small, not good.
    [[nodiscard]] FacetSplitStatus evaluate(TriangleId t, StarExtent extent, FacetNeed need);
    /// The vertex in the middle of a side instead, though it may encroach on segments, unless the side is one itself.
    [[nodiscard]] FacetSplitStatus evaluateSide(EdgeLink side, StarExtent extent);
    /// The vertex in the middle of the longest side, though facets beside it be steep: a facet that bridges a fold of the surface
    /// is split in no other way, since where the fold is all but upright so are the first facets that follow it. They hide the
    /// surface still, so they are split further.
    [[nodiscard]] FacetSplitStatus evaluateSteep(TriangleId t, StarExtent extent);
    /// What a split that is Ready will do.
    [[nodiscard]] FaceStar& star() { return star_; }
    /// Segments between the facet and its new vertex, or in whose balls that would lie.
    [[nodiscard]] const std::vector<SegmentId>& encroached() const { return encroached_; }
    [[nodiscard]] const FacetSplitCounts& counts() const { return counts_; }

    /// The vertex for a point of the surface, free, with the size wanted there.
    [[nodiscard]] FaceVertex vertexAt(const SurfaceFacts& facts) const;
    [[nodiscard]] bool encroaches(const Vec3& point, const Vec3& a, const Vec3& b) const;

private:
    [[nodiscard]] Vec2 nearImage(TriangleId t, Vec2 uv) const;
    [[nodiscard]] EdgeLink sideToHalve(TriangleId t) const;
    [[nodiscard]] EdgeLink nearestSide(TriangleId t, const Vec3& point) const;
    [[nodiscard]] double squaredCurvatureRadius(TriangleId t) const;
    [[nodiscard]] std::optional<SurfaceFacts> findCentre(TriangleId t);
    [[nodiscard]] SurfaceFacts middleOnSurface(const FaceTriangle& record, unsigned i, unsigned k) const;
    [[nodiscard]] FacetSplitStatus evaluateMiddleOf(EdgeLink side, StarExtent extent);
    [[nodiscard]] FacetSplitStatus judgeStar();
    [[nodiscard]] FacetSplitStatus judgeFacetsOfStar();

    FaceMesh& mesh_;
    const FaceGeometry& geometry_;
    const FacetCriteria& criteria_;
    FacetSplitOptions options_;
    double encroachmentCosine_;
    double leastAgreement_ = kUprightAgreement;  ///< of new facets with the surface
    FaceStar star_;
    std::vector<SegmentId> encroached_;
    FacetSplitCounts counts_;
};

}  // namespace mesher
