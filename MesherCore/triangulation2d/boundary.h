#pragma once

#include "base/id_vector.h"
#include "base/ids.h"
#include "base/result.h"
#include "triangulation2d/planar_domain.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace mesher {

/// A vertex of the discretised boundary: a point of the complex or a sample of a curve.
using BoundaryVertexId = Id<struct BoundaryVertexTag>;
/// The part of a curve between two successive vertices; its boundary edge is the straight line between them.
using SubcurveId = Id<struct SubcurveTag>;
/// Curves that form contiguous small angles at an apex (small_angles2d.h).
using SmallAngleId = Id<struct SmallAngleTag>;

struct BoundaryVertex
{
    Vec2 position;     ///< in the triangulation
    Vec3 space;        ///< exact: of the point, or curve at `parameter`
    PccPointId point;  ///< valid for points of the complex
    PccCurveId curve;  ///< valid for samples of a curve
    double parameter = 0.0;
    bool isCorner = false;  ///< points, and corners inside of a curve
    VertexId vertex;        ///< in the triangulation, once there is one
    /// Valid for vertices on a shell, a circle around the apex of a small angle.
    SmallAngleId shell;
    std::uint32_t spoke = 0;  ///< which of the small angle's curves it lies on
    double shellRadius = 0.0;
};

struct Subcurve
{
    PccCurveId curve;
    Interval part;
    BoundaryVertexId first;
    BoundaryVertexId last;
    /// Valid within the first shell around the apex of a small angle: both ends are at known distances from it.
    SmallAngleId wedge;
    std::uint32_t spoke = 0;  ///< its number among the curves of the small angle, counter-clockwise
    CurveEnd nearEnd = CurveEnd::First;
    double nearRadius = 0.0;
    double farRadius = 0.0;
    bool isAlive = true;
    bool isQueued = false;   ///< for a split
    bool isRefused = false;  ///< it cannot be split any further
};

/// Where a subcurve will be split.
struct SplitPlace
{
    double parameter = 0.0;
    PlanarPlace place;
    SmallAngleId wedge;  ///< valid if it is on a shell
    double radius = 0.0;
};

/// The discretised boundary: what the curves of the domain have been cut into so far.
/// Guarantees   the subcurves of a curve follow each other without gaps, their parameters ascend; each vertex is the
///              curve's exact point at its parameter
/// Reference    thesis sections 2.2 and 2.4
class Boundary
{
public:
    IdVector<BoundaryVertexId, BoundaryVertex> vertices;
    IdVector<SubcurveId, Subcurve> subcurves;  ///< with those that were split, which are not alive
    /// No subcurve whose edge is shorter is split: below it rounding moves the points of curves.
    double resolution = 0.0;

    [[nodiscard]] Vec2 position(BoundaryVertexId v) const { return vertices[v].position; }
    [[nodiscard]] Vec2 from(SubcurveId s) const { return vertices[subcurves[s].first].position; }
    [[nodiscard]] Vec2 to(SubcurveId s) const { return vertices[subcurves[s].last].position; }
    [[nodiscard]] double edgeLength(SubcurveId s) const { return length(to(s) - from(s)); }
    [[nodiscard]] std::size_t aliveCount() const { return aliveCount_; }

    BoundaryVertexId addPoint(const PlanarDomain& domain, PccPointId point);
    BoundaryVertexId addSample(const PlanarPlace& place, PccCurveId curve, double parameter, bool isCorner);
    SubcurveId addSubcurve(const Subcurve& subcurve);

    struct Halves
    {
        BoundaryVertexId vertex;
        SubcurveId first;
        SubcurveId last;
    };
    Halves split(SubcurveId s, const SplitPlace& place);
    /// The apex of each small angle, in space.
    std::vector<Vec3> apexes;

private:
    std::size_t aliveCount_ = 0;
};

/// The ordinary place: both halves have the same total variation of the tangent (equal length where all is straight).
/// Nothing if the subcurve is too short to be split.
[[nodiscard]] std::optional<SplitPlace> equalVariationPlace(const PlanarDomain& domain,
                                                            const Boundary& boundary, SubcurveId s);
/// Where the subcurve meets the shell of that radius around the apex of a small angle, one of its ends or beyond it.
[[nodiscard]] std::optional<SplitPlace> shellPlace(const PlanarDomain& domain, const Boundary& boundary,
                                                   SubcurveId s, CurveEnd nearEnd, const Vec3& apex,
                                                   double radius);
/// The place at which the subcurve is to be split: beside a small angle halfway between the shells of its ends, which at the
/// apex is the next smaller power of two; else the ordinary one. Nothing if it is too short.
/// Reference    thesis sections 2.4.2 and 2.5. Splitting between shells by distance from the apex, too, is our addition: the
///              curves of a small angle then have vertices at equal distances, as [miller2003] requires of segments
[[nodiscard]] std::optional<SplitPlace> splitPlace(const PlanarDomain& domain, const Boundary& boundary,
                                                   SubcurveId s);

}  // namespace mesher
