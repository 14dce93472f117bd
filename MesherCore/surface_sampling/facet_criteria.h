#pragma once

#include "sizing/sizing_field.h"
#include "surface_sampling/face_mesh.h"
#include "surface_sampling/facet_measures.h"

#include <limits>
#include <vector>

namespace mesher {

/// Around the tip of a face curvature asks for nothing finer than the ring there.
struct TipResolution
{
    Vec3 tip;
    double reach = 0.0;  ///< of the size, from the tip
    double leastSize = 0.0;
    double clearance = 0.0;  ///< distance from the tip that vertices outside of the ring keep
};

/// What facets are asked to be.
struct FacetCriteriaOptions
{
    /// Smallest angle wanted, degrees; 0 asks for none. Refinement is proven to end up to 20.7 [thesis §3.3.2.3], in practice
    /// it ends up to 30; in [0, 34]. What is beyond the reach of a face is given up for the default there.
    double minAngle = 30.0;
    /// Length of edges on average, model units; see size_bounds.h for what is split.
    double maxSize = std::numeric_limits<double>::infinity();
    /// Edges on a full turn at the surface's least radius of curvature; 0 for no wish.
    double elementsPerTurn = 0.0;
    /// Facets whose circumradius exceeds the least radius of curvature over 2 rho are split; 0 for no wish.
    double rho = 0.0;
    /// Largest distance between an edge and the surface, model units; 0 for no wish.
    double maxSag = 0.0;
    /// Largest angle between a facet's normal and the surface's at its corners, degrees; in (0, 90].
    double maxNormalDeviation = 35.0;
    /// Wanted edge lengths; null for no wish.
    const SizingField* sizes = nullptr;
    /// Curvature and normals ask for no edges shorter than this, model units: it keeps the apex of a cone, and a crease, from
    /// being refined without end.
    double leastCurvatureSize = 0.0;
    std::vector<TipResolution> tips;
};

enum class FacetNeed
{
    Nothing,
    Size,    ///< too long, too large for the curvature, or off the surface's normals
    Quality  ///< too small an angle
};

struct FacetVerdict
{
    FacetNeed need = FacetNeed::Nothing;
    double key = 0.0;  ///< the larger the worse
};

/// Judges the facets of a face by what is known at their corners.
/// Reference   thesis §3.3.2.3, whose rho works the other way round: larger is finer
class FacetCriteria
{
public:
    explicit FacetCriteria(const FacetCriteriaOptions& options);

    /// Smallest angle wanted from now on, degrees.
    void setMinAngle(double minAngle);
    [[nodiscard]] double minAngle() const { return options_.minAngle; }

    [[nodiscard]] FacetVerdict judge(const FaceMesh& mesh, TriangleId t) const;
    /// Is it off the surface's normals by more than may be, and long enough to matter?
    [[nodiscard]] bool hidesSurface(const FaceMesh& mesh, TriangleId t) const;
    /// The edge length wanted at a point of the surface, from its position and radius of curvature.
    [[nodiscard]] double sizeAt(const Vec3& point, double curvatureRadius) const;
    /// Is the point so near to the fan around a tip that facets between them could not be good?
    [[nodiscard]] bool crowdsTip(const Vec3& point) const;
    [[nodiscard]] bool isTooLong(const FaceMesh& mesh, EdgeLink side) const;
    /// The same for the sizes that are asked for, however the surface bends.
    [[nodiscard]] bool isTooLongForSizes(const FaceMesh& mesh, EdgeLink side) const;

private:
    /// The size below which curvature asks for nothing.
    [[nodiscard]] double leastAt(const Vec3& point) const;
    [[nodiscard]] bool isHiding(const FaceVertex& a, const FaceVertex& b, const FaceVertex& c,
                                const FacetShape& shape) const;

    FacetCriteriaOptions options_;
    double squaredRatioLimit_;
    double leastAgreement_;
};

}  // namespace mesher
