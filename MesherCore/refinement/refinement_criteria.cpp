#include "refinement/refinement_criteria.h"

#include "predicates/circumcenter.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace mesher {

namespace {

/// The least squared score that is told apart from that of a flat tetrahedron.
constexpr double kFlat = 1e-16;

/// Too large by a factor of 1 to 2, 2 to 4, and so on: tetrahedra of one class are refined in the order in which they
/// came, which stays near the same place of memory.
double sizeClass(double squaredFactor) { return std::ldexp(1.0, 2 * (std::ilogb(squaredFactor) / 2)); }

/// How far from the middle of an entity as large as it may be a small place of the field is looked for, in sizes. Farther out a
/// size that grows with the distance is low enough to ask for half as many elements again.
constexpr double kReach = 0.43;
constexpr double kReachOfFacet = 0.35;

double squaredCosine(double degrees)
{
    const double cosine = std::cos(degrees * std::numbers::pi / 180.0);
    return cosine * cosine;
}

}  // namespace

/// A tetrahedron from its first corner, with the three face normals that the questions share.
struct RefinementCriteria3d::Shape
{
    TetId tet;
    std::array<VertexId, 4> vertex;
    std::array<Vec3, 4> corner;
    std::array<Vec3, 4> normal;  ///< inward, twice the area, of the face opposite each corner
    double determinant = 0.0;    ///< six volumes
    Vec3 centreNumerator;        ///< of the circumcentre from corner 0: over 2 determinant
    double meanScale = 0.0;

    /// Of the circumradius, times (2 determinant)^2.
    [[nodiscard]] double squaredRadiusNumerator() const { return squaredLength(centreNumerator); }
};

RefinementCriteria3d::RefinementCriteria3d(const Triangulation3d& mesh, const LengthScale3d& scale,
                                           const TetQualityLimits& limits, double leastGap)
    : mesh_(mesh),
      scale_(scale),
      wanted_(limits),
      bounds_(scale.bounds()),
      lambda_(limits.lambda.value_or(infoOf(limits.measure).lambda)),
      squaredVolumeLength_(infoOf(limits.measure).leastVolumeLength *
                           infoOf(limits.measure).leastVolumeLength),
      squaredLeastGap_(leastGap * leastGap)
{
    applyLimits(wanted_);
}

void RefinementCriteria3d::applyLimits(const TetQualityLimits& limits)
{
    limits_ = limits;
    const TetMeasureInfo& usual = infoOf(limits_.measure);
    threshold_ = limits_.threshold.value_or(usual.threshold);
    squaredCosineOfSmall_ = 1.0 - threshold_ * threshold_;
    squaredCosineOfLarge_ = squaredCosine(limits_.largestDihedral.value_or(usual.largestDihedral));
    // A sine tells small and large angles alike.
    if (limits_.measure == TetMeasure::MinimumDihedralSine)
        squaredCosineOfLarge_ = std::min(squaredCosineOfLarge_, squaredCosineOfSmall_);
}

bool RefinementCriteria3d::asksForMoreThanUsual() const
{
    const TetMeasureInfo& usual = infoOf(limits_.measure);
    return limits_.isActive &&
           (threshold_ > usual.threshold || limits_.largestDihedral.value_or(180.0) < usual.largestDihedral);
}

void RefinementCriteria3d::settleForUsual()
{
    TetQualityLimits usual = wanted_;
    usual.threshold.reset();
    usual.largestDihedral.reset();
    applyLimits(usual);
}

inline RefinementCriteria3d::Shape RefinementCriteria3d::shapeOf(TetId tet) const
{
    Shape s;
    s.tet = tet;
    s.vertex = mesh_.tetData()[tet.value].vertex;
    const VertexRecord* const records = mesh_.vertexData();
    double sum = 0.0;
    for (unsigned i = 0; i < 4; ++i) {
        const VertexRecord& record = records[s.vertex[i].value];
        s.corner[i] = record.position;
        sum += record.lengthScale;
    }
    s.meanScale = 0.25 * sum;
    const Vec3 a = s.corner[1] - s.corner[0];
    const Vec3 b = s.corner[2] - s.corner[0];
    const Vec3 c = s.corner[3] - s.corner[0];
    s.normal[1] = cross(b, c);
    s.normal[2] = cross(c, a);
    s.normal[3] = cross(a, b);
    s.normal[0] = -1.0 * (s.normal[1] + s.normal[2] + s.normal[3]);
    s.determinant = dot(a, s.normal[1]);
    s.centreNumerator =
        squaredLength(a) * s.normal[1] + squaredLength(b) * s.normal[2] + squaredLength(c) * s.normal[3];
    return s;
}

/// Squared ratio of the circumradius and the largest that the length scale allows; above 1 it is too large.
double RefinementCriteria3d::sizeExcess(const Shape& s) const
{
    const double squaredBound = bounds_.tet * bounds_.tet;
    const double denominator = 4.0 * s.determinant * s.determinant;
    double excess = s.squaredRadiusNumerator() / (squaredBound * s.meanScale * s.meanScale * denominator);
    if (excess > 1.0 || !scale_.hasField()) return excess;
    // It may hide a small place of the field between its vertices.
    const Vec3 centroid = 0.25 * ((s.corner[0] + s.corner[1]) + (s.corner[2] + s.corner[3]));
    const double squaredRadius = s.squaredRadiusNumerator() / denominator;
    const double near = scale_.wantedNear(centroid, kReach / bounds_.tet * std::sqrt(squaredRadius));
    if (near < s.meanScale) excess = squaredRadius / (squaredBound * near * near);
    return excess;
}

/// 1 over the square of the score where the tetrahedron is bad, else 0.
double RefinementCriteria3d::badness(const Shape& s) const
{
    double worst = std::max(dihedralBadness(s), squaredVolumeLength_ > 0.0 ? spireBadness(s) : 0.0);
    if (limits_.measure == TetMeasure::MinimumDihedralSine) return worst;
    const double value = score(limits_.measure, {s.corner[0], s.corner[1], s.corner[2], s.corner[3]});
    if (value < threshold_) worst = std::max(worst, 1.0 / std::max(value * value, kFlat));
    return worst;
}

/// The same for the largest angle, and for the smallest if that is the measure.
double RefinementCriteria3d::dihedralBadness(const Shape& s) const
{
    std::array<double, 4> squaredArea{};
    for (unsigned i = 0; i < 4; ++i) squaredArea[i] = squaredLength(s.normal[i]);
    double smallest = 0.0;  // squared cosine of the smallest acute angle
    double largest = 0.0;   // of the largest obtuse one
    for (unsigned i = 0; i < 3; ++i) {
        for (unsigned j = i + 1; j < 4; ++j) {
            const double product = dot(s.normal[i], s.normal[j]);
            const double squaredCosine = product * product / (squaredArea[i] * squaredArea[j]);
            double& extreme = product < 0.0 ? smallest : largest;
            extreme = std::max(extreme, squaredCosine);
        }
    }
    double worst = largest > squaredCosineOfLarge_ ? 1.0 / std::max(1.0 - largest, kFlat) : 0.0;
    const bool isMeasure = limits_.measure == TetMeasure::MinimumDihedralSine;
    if (isMeasure && smallest > squaredCosineOfSmall_)
        worst = std::max(worst, 1.0 / std::max(1.0 - smallest, kFlat));
    return worst;
}

/// The same for q3 where spires are bad.
double RefinementCriteria3d::spireBadness(const Shape& s) const
{
    double sum = 0.0;
    double shortest = kNoSize;
    for (const auto& [a, b] : kTetEdgeCorners) {
        const double squaredEdge = squaredLength(s.corner[b] - s.corner[a]);
        sum += squaredEdge;
        shortest = std::min(shortest, squaredEdge);
    }
    const double meanSquare = sum / 6.0;
    const double squaredScore = 2.0 * s.determinant * s.determinant / (meanSquare * meanSquare * meanSquare);
    const bool isBad = squaredScore < squaredVolumeLength_ && shortest > squaredLeastGap_;
    return isBad ? 1.0 / std::max(squaredScore, kFlat) : 0.0;
}

/// Equation 4.1: mean LS < 2 lambda r / sqrt(3).
bool RefinementCriteria3d::mayRefine(const Shape& s) const
{
    double mean = 0.0;
    for (const VertexId v : s.vertex) mean += 0.25 * scale_.guard(v);
    const double factor = 4.0 / 3.0 * lambda_ * lambda_;
    return mean * mean * 4.0 * s.determinant * s.determinant < factor * s.squaredRadiusNumerator();
}

TetVerdict RefinementCriteria3d::judge(TetId tet) const
{
    const Shape shape = shapeOf(tet);
    if (scale_.isActive()) {
        const double excess = sizeExcess(shape);
        if (excess > 1.0) return {TetNeed::Size, sizeClass(excess)};
    }
    if (!limits_.isActive) return {};
    const double key = badness(shape);
    if (!(key > 0.0)) return {};
    return {mayRefine(shape) ? TetNeed::Quality : TetNeed::HeldBack, key};
}

bool RefinementCriteria3d::isBad(TetId tet) const { return limits_.isActive && badness(shapeOf(tet)) > 0.0; }

std::optional<Vec3> RefinementCriteria3d::circumcentre(TetId tet) const
{
    const Shape s = shapeOf(tet);
    if (!(s.determinant > 0.0)) return std::nullopt;
    const Vec3 centre = s.corner[0] + (0.5 / s.determinant) * s.centreNumerator;
    if (!isFinite(centre)) return std::nullopt;
    return centre;
}

bool RefinementCriteria3d::isSink(TetId tet) const
{
    const Shape s = shapeOf(tet);
    for (unsigned i = 0; i < 4; ++i) {
        const Vec3 fromCorner =
            s.centreNumerator - 2.0 * s.determinant * (s.corner[(i + 1) % 4] - s.corner[0]);
        if (!(dot(s.normal[i], fromCorner) > 0.0)) return false;
    }
    return s.determinant > 0.0;
}

bool RefinementCriteria3d::isNearlyFlat(TetId tet) const
{
    const Shape s = shapeOf(tet);
    double largest = 0.0;
    for (unsigned i = 1; i < 4; ++i) largest = std::max(largest, squaredLength(s.corner[i] - s.corner[0]));
    return s.determinant < 1e-8 * largest * std::sqrt(largest);
}

std::optional<Vec3> RefinementCriteria3d::centreOfLargestFace(TetId tet) const
{
    const Shape s = shapeOf(tet);
    unsigned largest = 0;
    for (unsigned i = 1; i < 4; ++i) {
        if (squaredLength(s.normal[i]) > squaredLength(s.normal[largest])) largest = i;
    }
    return approximateCircumcenter(s.corner[(largest + 1) % 4], s.corner[(largest + 2) % 4],
                                   s.corner[(largest + 3) % 4]);
}

bool RefinementCriteria3d::isTooLong(VertexId a, VertexId b) const
{
    if (!scale_.isActive()) return false;
    const double edge = length(mesh_.position(b) - mesh_.position(a));
    if (edge > scale_.size(a) + scale_.size(b)) return true;
    if (!scale_.hasField()) return false;
    const Vec3 middle = 0.5 * (mesh_.position(a) + mesh_.position(b));
    return edge > 2.0 * scale_.wantedNear(middle, 0.25 * edge);
}

bool RefinementCriteria3d::isTooLarge(const std::array<VertexId, 3>& facet) const
{
    if (!scale_.isActive()) return false;
    const Vec3& a = mesh_.position(facet[0]);
    const std::optional<Vec3> centre =
        approximateCircumcenter(a, mesh_.position(facet[1]), mesh_.position(facet[2]));
    if (!centre) return false;
    const double squaredRadius = squaredLength(a - *centre);
    double wanted = (scale_.size(facet[0]) + scale_.size(facet[1]) + scale_.size(facet[2])) / 3.0;
    if (scale_.hasField()) {
        wanted = std::min(
            wanted, scale_.wantedNear(*centre, kReachOfFacet / bounds_.facet * std::sqrt(squaredRadius)));
    }
    wanted *= bounds_.facet;
    return squaredRadius > wanted * wanted;
}

bool RefinementCriteria3d::maySplit(VertexId a, VertexId b) const
{
    const double mean = 0.5 * (scale_.guard(a) + scale_.guard(b));
    return mean < 2.0 * lambda_ * length(mesh_.position(b) - mesh_.position(a));
}

bool RefinementCriteria3d::maySplit(const std::array<VertexId, 3>& facet) const
{
    const Vec3& a = mesh_.position(facet[0]);
    const std::optional<Vec3> centre =
        approximateCircumcenter(a, mesh_.position(facet[1]), mesh_.position(facet[2]));
    if (!centre) return false;
    const double mean = (scale_.guard(facet[0]) + scale_.guard(facet[1]) + scale_.guard(facet[2])) / 3.0;
    return mean < std::numbers::sqrt2 * lambda_ * length(a - *centre);
}

}  // namespace mesher
