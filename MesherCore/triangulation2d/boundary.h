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
    /// Valid for vertices on a shell around the apex of a small angle, of radius 2^shellExponent.
    SmallAngleId shell;
    int shellExponent = 0;
};

struct Subcurve
{
    PccCurveId curve;
    Interval part;
    BoundaryVertexId first;
    BoundaryVertexId last;
    /// Valid where that end is the apex of a small angle the subcurve takes part in.
    SmallAngleId firstApex;
    SmallAngleId lastApex;
    bool isAlive = true;
    bool isQueued = false;   ///< for a split
    bool isRefused = false;  ///< it cannot be split any further

    [[nodiscard]] bool isAtApex() const { return firstApex.isValid() || lastApex.isValid(); }
};

/// Where a subcurve will be split.
struct SplitPlace
{
    double parameter = 0.0;
    PlanarPlace place;
    SmallAngleId shell;
    int shellExponent = 0;
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

private:
    std::size_t aliveCount_ = 0;
};

/// The ordinary place: both halves have the same total variation of the tangent (equal length where all is straight).
/// Nothing if the subcurve is too short to be split.
[[nodiscard]] std::optional<SplitPlace> equalVariationPlace(const PlanarDomain& domain, const Boundary& boundary,
                                                            SubcurveId s);
/// Where the subcurve leaves the ball of radius 2^exponent around its end, the apex of a small angle.
[[nodiscard]] std::optional<SplitPlace> shellPlace(const PlanarDomain& domain, const Boundary& boundary, SubcurveId s,
                                                   CurveEnd apexEnd, int exponent);
/// The place at which the subcurve is to be split: on the next smaller shell at the apex of a small angle, else the
/// ordinary one. Nothing if it is too short.
/// Reference    thesis sections 2.4.2 and 2.5
[[nodiscard]] std::optional<SplitPlace> splitPlace(const PlanarDomain& domain, const Boundary& boundary, SubcurveId s);

/// Largest power of two not above two thirds of a length: the first shell.
[[nodiscard]] int firstShellExponent(double shortestEdge);

}  // namespace mesher
