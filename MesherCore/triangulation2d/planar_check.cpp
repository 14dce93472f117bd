#include "triangulation2d/planar_check.h"

#include "delaunay/delaunay_check2d.h"
#include "triangulation2d/boundary_intersection.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <set>

namespace mesher {
namespace {

constexpr double kDegreesPerRadian = 180.0 / std::numbers::pi;
constexpr double kAngleSlack = 1e-7;

/// 5-point Gauss-Legendre on [-1, 1].
constexpr std::array<double, 5> kGaussPoints{-0.906179845938664, -0.538469310105683, 0.0, 0.538469310105683,
                                             0.906179845938664};
constexpr std::array<double, 5> kGaussWeights{0.236926885056189, 0.478628670499366, 0.568888888888889,
                                              0.478628670499366, 0.236926885056189};

class Checker
{
public:
    Checker(const PlanarCurveComplex& complex, const PlanarResult& result, const PlanarOptions& options)
        : complex_(complex), result_(result), options_(options), t_(result.triangulation), mesh_(t_.mesh())
    {
    }

    PlanarCheck run()
    {
        const CheckReport delaunay = checkDelaunay2d(mesh_);
        if (!delaunay.isValid()) add("not constrained Delaunay: " + delaunay.problem);
        for (const BoundaryVertex& vertex : t_.boundary.vertices)
            box_.include(complex_.frame.toPlane(vertex.space));
        check_.regions.resize(complex_.regionNames.size());
        checkChains();
        checkEdges();
        measureTriangles();
        checkAngles();
        checkAreas();
        countEuler();
        return std::move(check_);
    }

private:
    void add(std::string violation)
    {
        constexpr std::size_t kMostTold = 20;
        if (check_.violations.size() < kMostTold) check_.violations.push_back(std::move(violation));
    }

    [[nodiscard]] std::vector<std::vector<SubcurveId>> chains() const
    {
        std::vector<std::vector<SubcurveId>> byCurve(complex_.curves.size());
        for (std::uint32_t i = 0; i < t_.boundary.subcurves.size(); ++i) {
            const Subcurve& subcurve = t_.boundary.subcurves[SubcurveId(i)];
            if (subcurve.isAlive) byCurve[subcurve.curve.value].push_back(SubcurveId(i));
        }
        for (auto& chain : byCurve) {
            std::sort(chain.begin(), chain.end(), [&](SubcurveId a, SubcurveId b) {
                return t_.boundary.subcurves[a].part.first < t_.boundary.subcurves[b].part.first;
            });
        }
        return byCurve;
    }

    void checkChains()
    {
        const auto byCurve = chains();
        for (std::uint32_t c = 0; c < byCurve.size(); ++c) {
            const PccCurve& curve = complex_.curves[c];
            const std::string name = "curve " + std::to_string(c);
            double t = curve.part.first;
            BoundaryVertexId previous;
            for (const SubcurveId s : byCurve[c]) {
                const Subcurve& subcurve = t_.boundary.subcurves[s];
                if (subcurve.part.first != t || !(subcurve.part.first < subcurve.part.last)) {
                    add(name + ": its chain has a gap or does not ascend");
                }
                if (previous.isValid() && subcurve.first != previous) add(name + ": its chain is torn");
                t = subcurve.part.last;
                previous = subcurve.last;
                checkVertex(curve, subcurve.last, name);
                integrate(curve, subcurve);
            }
            if (byCurve[c].empty() || t != curve.part.last) {
                add(name + ": its chain is not complete");
                continue;
            }
            if (t_.boundary.vertices[t_.boundary.subcurves[byCurve[c].front()].first].point != curve.first ||
                t_.boundary.vertices[previous].point != curve.last) {
                add(name + ": its chain does not run from its first point to its last");
            }
        }
    }

    void checkVertex(const PccCurve& curve, BoundaryVertexId v, const std::string& name)
    {
        const BoundaryVertex& vertex = t_.boundary.vertices[v];
        if (!mesh_.isAlive(vertex.vertex) || mesh_.position(vertex.vertex) != vertex.position) {
            add(name + ": a vertex of its chain is not in the mesh");
            return;
        }
        if (vertex.point.isValid()) return;
        const CurveProjection foot = curve.curve->project(vertex.space, curve.part, vertex.parameter);
        check_.largestCurveDistance = std::max(check_.largestCurveDistance, foot.distance);
        const double inPlane =
            length((1.0 / t_.scale) * vertex.position - complex_.frame.toPlane(vertex.space));
        if (foot.distance > 1e-12 * size() || inPlane > 1e-14 * (size() + length(box_.low))) {
            add(name + ": a vertex is off the curve");
        }
    }

    [[nodiscard]] double size() const { return length(box_.extent()); }

    /// Half of the integral of x dy - y dx along the curve and along its edge, relative to the edge's start.
    void integrate(const PccCurve& curve, const Subcurve& subcurve)
    {
        const Vec2 start = (1.0 / t_.scale) * t_.boundary.position(subcurve.first);
        const Vec2 end = (1.0 / t_.scale) * t_.boundary.position(subcurve.last);
        // Pieces between knots, each halved until the rule is exact for all practical purposes.
        std::vector<double> stations{subcurve.part.first, subcurve.part.last};
        for (const double knot : curve.curve->knots()) {
            if (subcurve.part.first < knot && knot < subcurve.part.last) stations.push_back(knot);
        }
        std::sort(stations.begin(), stations.end());
        double bulge = 0.0;
        for (std::size_t i = 1; i < stations.size(); ++i) {
            constexpr int kPieces = 8;
            const Interval part{stations[i - 1], stations[i]};
            for (int k = 0; k < kPieces; ++k) {
                bulge +=
                    gauss(curve, {part.at(k / double{kPieces}), part.at((k + 1) / double{kPieces})}, start);
            }
        }
        addArea(curve.left, bulge, start, end, 1.0);
        addArea(curve.right, bulge, start, end, -1.0);
    }

    [[nodiscard]] double gauss(const PccCurve& curve, Interval part, Vec2 origin) const
    {
        double sum = 0.0;
        for (std::size_t i = 0; i < kGaussPoints.size(); ++i) {
            const CurvePoint p = curve.curve->evaluate(part.at(0.5 + 0.5 * kGaussPoints[i]));
            const Vec2 offset = complex_.frame.toPlane(p.position) - origin;
            sum += kGaussWeights[i] * cross(offset, complex_.frame.directionToPlane(p.d1));
        }
        return 0.25 * part.length() * sum;
    }

    void addArea(RegionId region, double bulge, Vec2 start, Vec2 end, double sign)
    {
        if (region.value == 0 || region.value > check_.regions.size()) return;
        const Vec2 origin = box_.low;
        const double polygon = 0.5 * cross(start - origin, end - origin);
        check_.regions[region.value - 1].curveArea += sign * (polygon + bulge);
        check_.regions[region.value - 1].segmentArea += sign * bulge;
    }

    void checkEdges()
    {
        std::size_t found = 0;
        for (std::uint32_t i = 0; i < t_.boundary.subcurves.size(); ++i) {
            const SubcurveId s(i);
            const Subcurve& subcurve = t_.boundary.subcurves[s];
            if (!subcurve.isAlive) continue;
            const EdgeLink edge = mesh_.findEdge(t_.firstVertex(s), t_.lastVertex(s));
            if (!edge.isValid() || !mesh_.isConstrained(edge) || t_.subcurveOf(edge) != s) {
                add("subcurve " + std::to_string(i) + " is no constrained edge");
                continue;
            }
            ++found;
            const PccCurve& curve = complex_.curves[subcurve.curve.value];
            if (mesh_.triangle(edge.triangle()).region != curve.left ||
                mesh_.triangle(mesh_.across(edge).triangle()).region != curve.right) {
                add("subcurve " + std::to_string(i) + " has the wrong regions beside it");
            }
        }
        if (found != countConstrained()) add("there are constrained edges without a subcurve");
        for (std::uint32_t i = 0; i < mesh_.triangleSlots(); ++i) checkRegionOf(TriangleId(i));
    }

    [[nodiscard]] std::size_t countConstrained() const
    {
        std::size_t sides = 0;
        for (std::uint32_t i = 0; i < mesh_.triangleSlots(); ++i) {
            const TriangleId t(i);
            for (unsigned edge = 0; edge < 3 && mesh_.isAlive(t); ++edge) {
                if (mesh_.triangle(t).isConstrained(edge)) ++sides;
            }
        }
        return sides / 2;
    }

    /// A region ends at constrained edges only; what lies outside of the hull is no region.
    void checkRegionOf(TriangleId t)
    {
        if (!mesh_.isAlive(t)) return;
        const Triangle2d& record = mesh_.triangle(t);
        if (record.isGhost() && record.region.value != 0) add("a region reaches out of the hull");
        for (unsigned edge = 0; edge < 3; ++edge) {
            const RegionId beyond = mesh_.triangle(record.n[edge].triangle()).region;
            if (!record.isConstrained(edge) && beyond != record.region) add("a region ends without a curve");
        }
    }

    void measureTriangles()
    {
        for (std::uint32_t i = 0; i < mesh_.triangleSlots(); ++i) {
            const TriangleId t(i);
            if (!mesh_.isAlive(t) || !t_.isMeshed(t)) continue;
            const Triangle2d& record = mesh_.triangle(t);
            if (record.region.value > check_.regions.size()) {
                add("a triangle has a region without a name");
                continue;
            }
            const Vec2 p[3] = {mesh_.position(record.v[0]), mesh_.position(record.v[1]),
                               mesh_.position(record.v[2])};
            RegionStatistics& region = check_.regions[record.region.value - 1];
            ++region.triangles;
            region.area += 0.5 * cross(p[1] - p[0], p[2] - p[0]) / (t_.scale * t_.scale);
            const bool spans = spansSmallAngle(record, p);
            for (unsigned k = 0; k < 3; ++k)
                countAngle(angleAt(p[k], p[nextCorner(k)], p[previousCorner(k)]), spans);
        }
    }

    static double angleAt(Vec2 p, Vec2 next, Vec2 previous)
    {
        return std::atan2(cross(next - p, previous - p), dot(next - p, previous - p)) * kDegreesPerRadian;
    }

    void countAngle(double angle, bool spansSmallAngle)
    {
        AngleStatistics& angles = check_.angles;
        angles.smallest = std::min(angles.smallest, angle);
        angles.largest = std::max(angles.largest, angle);
        const auto bin = static_cast<std::size_t>(angle / AngleStatistics::kBinDegrees);
        ++angles.histogram[std::min<std::size_t>(bin, angles.histogram.size() - 1)];
        if (spansSmallAngle) return;
        angles.smallestElsewhere = std::min(angles.smallestElsewhere, angle);
        angles.largestElsewhere = std::max(angles.largestElsewhere, angle);
    }

    /// By distances from the apex rather than by the shells that the steps noted.
    [[nodiscard]] bool spansSmallAngle(const Triangle2d& record, const Vec2* p) const
    {
        unsigned shortest = 0;
        for (unsigned k = 1; k < 3; ++k) {
            if (edgeSquare(p, k) < edgeSquare(p, shortest)) shortest = k;
        }
        const BoundaryVertexId a = t_.boundaryVertexOf(record.v[nextCorner(shortest)]);
        const BoundaryVertexId b = t_.boundaryVertexOf(record.v[previousCorner(shortest)]);
        if (!a.isValid() || !b.isValid()) return false;
        const BoundaryVertex& first = t_.boundary.vertices[a];
        const BoundaryVertex& last = t_.boundary.vertices[b];
        if (!first.shell.isValid() || first.shell != last.shell) return false;
        const SmallAngleComplex& complex = t_.smallAngles.complexes[first.shell];
        const Vec2 apex = t_.boundary.position(complex.apex);
        const double r1 = length(first.position - apex);
        const double r2 = length(last.position - apex);
        return std::abs(r1 - r2) <= 1e-6 * r1 && complex.smallestAngle() < SmallAngles2d::kLimitDegrees;
    }

    static double edgeSquare(const Vec2* p, unsigned edge)
    {
        return squaredLength(p[nextCorner(edge)] - p[previousCorner(edge)]);
    }

    void checkAngles()
    {
        if (!options_.isRefined || result_.stopReason != StopReason::Done) return;
        const auto& unreachable = result_.refinement.unreachable;
        const double bound = unreachable ? unreachable->kept : options_.refinement.minAngle;
        if (check_.angles.smallestElsewhere < bound - kAngleSlack) {
            add("an angle of " + std::to_string(check_.angles.smallestElsewhere) +
                " degrees spans no small input angle");
        }
        if (bound > 0.0 && check_.angles.largestElsewhere > 180.0 - 2.0 * bound + kAngleSlack) {
            add("an angle of " + std::to_string(check_.angles.largestElsewhere) +
                " degrees spans no small input angle");
        }
        for (const LeftTriangle2d& left : result_.refinement.left) {
            if (left.reason != LeftReason2d::SmallInputAngle)
                add("a triangle was left that spans no small input angle");
        }
    }

    void checkAreas()
    {
        double total = 0.0;
        for (const RegionStatistics& region : check_.regions) total += std::abs(region.curveArea);
        for (std::size_t i = 0; i < check_.regions.size(); ++i) {
            const RegionStatistics& region = check_.regions[i];
            if (std::abs(region.area + region.segmentArea - region.curveArea) >
                1e-9 * total + 1e-13 * size() * size()) {
                add("region " + std::to_string(i + 1) + " has area " +
                    std::to_string(region.area + region.segmentArea) + " instead of " +
                    std::to_string(region.curveArea));
            }
        }
    }

    void countEuler()
    {
        std::vector<std::set<VertexId>> vertices(check_.regions.size());
        std::vector<std::size_t> edges(check_.regions.size(), 0);
        for (std::uint32_t i = 0; i < mesh_.triangleSlots(); ++i) {
            const TriangleId t(i);
            if (!mesh_.isAlive(t) || !t_.isMeshed(t)) continue;
            const Triangle2d& record = mesh_.triangle(t);
            const std::size_t region = record.region.value - 1;
            if (region >= vertices.size()) continue;
            vertices[region].insert(record.v, record.v + 3);
            for (unsigned edge = 0; edge < 3; ++edge) {
                const TriangleId beyond = record.n[edge].triangle();
                if (mesh_.triangle(beyond).region != record.region || t < beyond) ++edges[region];
            }
        }
        for (std::size_t i = 0; i < check_.regions.size(); ++i) {
            check_.regions[i].eulerCharacteristic = static_cast<int>(vertices[i].size()) -
                                                    static_cast<int>(edges[i]) +
                                                    static_cast<int>(check_.regions[i].triangles);
        }
    }

    const PlanarCurveComplex& complex_;
    const PlanarResult& result_;
    const PlanarOptions& options_;
    const PlanarTriangulation& t_;
    const Triangulation2d& mesh_;
    Box2 box_;
    PlanarCheck check_;
};

}  // namespace

PlanarCheck checkPlanar(const PlanarCurveComplex& complex, const PlanarResult& result,
                        const PlanarOptions& options)
{
    return Checker(complex, result, options).run();
}

}  // namespace mesher
