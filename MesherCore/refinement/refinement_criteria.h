#pragma once

#include "delaunay/triangulation3d.h"
#include "mesh/surface_mesh.h"
#include "quality/tet_measures.h"
#include "refinement/length_scale3d.h"

#include <optional>

namespace mesher {

/// Which tetrahedra are bad.
struct TetQualityLimits
{
    bool isActive = true;
    TetMeasure measure = TetMeasure::MinimumDihedralSine;
    std::optional<double>
        threshold;  ///< score below which a tetrahedron is bad. DEFAULT: that of the measure
    /// Degrees, beyond which it is bad whatever it scores; 180 is off. DEFAULT: that of the measure
    std::optional<double> largestDihedral;
    /// How far below the length scale quality may refine, see RefinementCriteria3d; at least 1. DEFAULT: that of the measure
    std::optional<double> lambda;
};

enum class TetNeed : std::uint8_t
{
    Nothing,
    Size,
    Quality,
    HeldBack  ///< quality, but it is as small as lambda allows
};

/// What a tetrahedron needs, and how urgently: the larger the key, the worse.
struct TetVerdict
{
    TetNeed need = TetNeed::Nothing;
    double key = 0.0;
};

/// Decides what is to be refined, and what must not be refined any more.
/// Reference    [gosselin] sections 4.3 to 4.5. Equation 4.1 is used with the sign of its inequality and the number of its
///              terms corrected: an entity of n vertices is split only if their mean LS < 2 lambda r / sqrt(n - 1); lambda
///              is 1 for size, and an option for quality
class RefinementCriteria3d
{
public:
    /// Spires with an edge below the least gap, in units of the mesh, are let be: they stand between entities that all but meet.
    RefinementCriteria3d(const Triangulation3d& mesh, const LengthScale3d& scale,
                         const TetQualityLimits& limits, double leastGap = 0.0);

    /// Whether more is asked for than the measure's own limits, which were reached on all shapes without small angles.
    [[nodiscard]] bool asksForMoreThanUsual() const;
    /// From now on the measure's own limits hold, or those asked for again.
    void settleForUsual();
    void returnToWanted() { applyLimits(wanted_); }

    /// Of a live tetrahedron in a region.
    [[nodiscard]] TetVerdict judge(TetId tet) const;
    /// Bad by the limits, whatever the length scale says.
    [[nodiscard]] bool isBad(TetId tet) const;
    [[nodiscard]] bool isSink(TetId tet) const;
    [[nodiscard]] std::optional<Vec3> circumcentre(TetId tet) const;
    /// So flat that rounding decides where its circumcentre comes out.
    [[nodiscard]] bool isNearlyFlat(TetId tet) const;
    [[nodiscard]] std::optional<Vec3> centreOfLargestFace(TetId tet) const;

    [[nodiscard]] bool isTooLong(VertexId a, VertexId b) const;
    [[nodiscard]] bool isTooLarge(const std::array<VertexId, 3>& facet) const;
    /// Equation 4.1 for quality: false where a further split would go too far below the length scale.
    [[nodiscard]] bool maySplit(VertexId a, VertexId b) const;
    [[nodiscard]] bool maySplit(const std::array<VertexId, 3>& facet) const;

private:
    struct Shape;

    void applyLimits(const TetQualityLimits& limits);
    [[nodiscard]] Shape shapeOf(TetId tet) const;
    [[nodiscard]] double sizeExcess(const Shape& shape) const;
    [[nodiscard]] double badness(const Shape& shape) const;
    [[nodiscard]] double spireBadness(const Shape& shape) const;
    [[nodiscard]] double dihedralBadness(const Shape& shape) const;
    [[nodiscard]] bool mayRefine(const Shape& shape) const;

    const Triangulation3d& mesh_;
    const LengthScale3d& scale_;
    TetQualityLimits wanted_;
    TetQualityLimits limits_;  ///< that hold
    SizeBounds bounds_;
    double threshold_ = 0.0;
    double squaredCosineOfSmall_ = 0.0;  ///< of dihedral angles below which q2 calls a tetrahedron bad
    double squaredCosineOfLarge_ = 0.0;
    double lambda_;               ///< for quality
    double squaredVolumeLength_;  ///< q3 below which it is bad whatever it scores
    double squaredLeastGap_;
};

}  // namespace mesher
