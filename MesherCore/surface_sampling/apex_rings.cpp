#include "surface_sampling/apex_rings.h"

#include "surface_sampling/face_geometry.h"
#include "surface_sampling/face_points.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>
#include <utility>

namespace mesher {

namespace {

constexpr double kDegreesPerRadian = 180.0 / std::numbers::pi;
// A facet of the fan that is wider would have its longest side on the ring.
constexpr double kWidestFacet = 50.0;
constexpr double kMostTurn = 60.0;

double turnBetween(const Vec3& a, const Vec3& b) { return std::atan2(length(cross(a, b)), dot(a, b)); }

double& across(Vec2& uv, bool isAlongU) { return isAlongU ? uv.y : uv.x; }
double along(Vec2 uv, bool isAlongU) { return isAlongU ? uv.x : uv.y; }

/// Cuts the line of a pole so that no piece turns too much, in the surface or about it.
void placeRing(const BrepFace& face, const Vec3& tip, FaceApex& apex)
{
    constexpr int kSteps = 96;
    constexpr double kBeside = 1e-3;
    std::array<double, kSteps + 1> turned{}, opened{};
    Vec3 lastSpoke, lastNormal;
    for (int i = 0; i <= kSteps; ++i) {
        const double share = static_cast<double>(i) / kSteps;
        Vec2 uv = apex.line[0] + share * (apex.line[1] - apex.line[0]);
        const double middle = (apex.isAlongU ? face.boundsV : face.boundsU).at(0.5);
        double& depth = across(uv, apex.isAlongU);
        depth += kBeside * (middle - depth);
        const SurfacePoint beside = face.surface->evaluate(uv);
        const Vec3 spoke = beside.position - tip, normal = beside.normal();
        const auto k = static_cast<std::size_t>(i);
        if (i > 0) {
            const double opening = turnBetween(lastSpoke, spoke) * kDegreesPerRadian;
            const double turning = turnBetween(lastNormal, normal) * kDegreesPerRadian;
            turned[k] = turned[k - 1] + std::max(opening / kWidestFacet, turning / kMostTurn);
            opened[k] = opened[k - 1] + opening;
        }
        lastSpoke = spoke;
        lastNormal = normal;
    }
    const double total = turned.back();
    const double pieces = std::max(1.0, std::ceil(total - 1e-6));
    apex.shares.clear();
    apex.facetAngle = kWidestFacet;
    double openedBefore = 0.0;
    std::size_t k = 1;
    for (double piece = 1.0; piece <= pieces; ++piece) {
        const double wanted = total * piece / pieces;
        while (k < kSteps && turned[k] < wanted) ++k;
        const double part =
            turned[k] > turned[k - 1] ? (wanted - turned[k - 1]) / (turned[k] - turned[k - 1]) : 1.0;
        const double openedHere = opened[k - 1] + part * (opened[k] - opened[k - 1]);
        apex.facetAngle = std::min(apex.facetAngle, openedHere - openedBefore);
        openedBefore = openedHere;
        if (piece < pieces) apex.shares.push_back((static_cast<double>(k - 1) + part) / kSteps);
    }
}

/// One ring while it is made.
class RingMaker
{
public:
    RingMaker(const BrepFace& face, const FaceApex& apex, const Vec3& tip, double radius,
              FaceTriangulation& t)
        : face_(face), apex_(apex), tip_(tip), radius_(radius), t_(t)
    {
    }

    /// The images of the curves' nodes on the shell that are level with the ends of the pole's line.
    bool findEnds(const CurveChains& chains)
    {
        for (std::size_t end = 0; end < 2; ++end) {
            double least = std::numeric_limits<double>::infinity();
            for (std::uint32_t i = 0; i < t_.points.size(); ++i) {
                const FacePoint& point = t_.points[VertexId(i)];
                if (!point.node.isValid() || !chains.isOnShellAround(apex_.vertex, point.node)) continue;
                const double distance =
                    std::abs(along(point.uv, apex_.isAlongU) - along(apex_.line[end], apex_.isAlongU));
                if (distance < least) {
                    least = distance;
                    ends_[end] = VertexId(i);
                }
            }
        }
        findPoleEnds();
        return ends_[0].isValid() && ends_[1].isValid() && ends_[0] != ends_[1] && poleEnds_[0].isValid();
    }

    bool insertPoints()
    {
        ring_ = {ends_[0]};
        for (const double share : apex_.shares) {
            const std::optional<Vec2> uv = placeAt(share);
            if (!uv) return false;
            const auto vertex = insertFacePoint(face_, *uv, TriangleId(), t_, kClearance);
            if (!vertex) return false;
            ring_.push_back(*vertex);
        }
        ring_.push_back(ends_[1]);
        return true;
    }

    bool holdSides()
    {
        for (std::size_t i = 1; i < ring_.size(); ++i) {
            if (!hold(ring_[i - 1], ring_[i])) return false;
        }
        // The facets at either end have the curve itself as a side, not another image of the pole joined to its node.
        if (!hold(poleEnds_[0], ring_[1]) || !hold(poleEnds_[1], ring_[ring_.size() - 2])) return false;
        for (const VertexId v : ring_) t_.points[v].isOnRing = true;
        return true;
    }

private:
    // What is nearer to a curve than that has no room for a fan.
    static constexpr double kClearance = 1e-3;

    bool hold(VertexId a, VertexId b)
    {
        return t_.delaunay.recoverSegment(a, b).hasValue() && t_.delaunay.lastSegment().size() == 2;
    }

    /// The images of the pole at the ends of its line.
    void findPoleEnds()
    {
        std::array<double, 2> least{std::numeric_limits<double>::infinity(),
                                    std::numeric_limits<double>::infinity()};
        for (std::uint32_t i = 0; i < t_.points.size(); ++i) {
            const FacePoint& point = t_.points[VertexId(i)];
            if (!point.isPole || point.node != NodeId(apex_.vertex.value)) continue;
            for (std::size_t end = 0; end < 2; ++end) {
                const double distance = squaredLength(point.uv - apex_.line[end]);
                if (!(distance < least[end])) continue;
                least[end] = distance;
                poleEnds_[end] = VertexId(i);
            }
        }
    }

    /// Where the line across the pole's line leaves the shell.
    [[nodiscard]] std::optional<Vec2> placeAt(double share) const
    {
        constexpr int kMostSteps = 100;
        const Vec2 first = t_.points[ends_[0]].uv, last = t_.points[ends_[1]].uv;
        Vec2 uv = first + share * (last - first);
        const Interval bounds = apex_.isAlongU ? face_.boundsV : face_.boundsU;
        Vec2 pole = apex_.line[0];
        const double start = across(pole, apex_.isAlongU);
        double& depth = across(uv, apex_.isAlongU);
        const auto excess = [&](double x) {
            depth = x;
            return length(face_.surface->position(uv) - tip_) - radius_;
        };
        const double guess = depth;
        double inside = start, outside = guess;
        for (int step = 0; excess(outside) < 0.0; ++step) {
            if (step == kMostSteps || outside < bounds.first || outside > bounds.last) return std::nullopt;
            inside = outside;
            outside += 0.25 * (guess - start);
        }
        for (int step = 0; step < kMostSteps; ++step) {
            const double middle = 0.5 * (inside + outside);
            if (middle == inside || middle == outside) break;
            (excess(middle) < 0.0 ? inside : outside) = middle;
        }
        depth = outside;
        return uv;
    }

    const BrepFace& face_;
    const FaceApex& apex_;
    Vec3 tip_;
    double radius_;
    FaceTriangulation& t_;
    std::array<VertexId, 2> ends_;
    std::array<VertexId, 2> poleEnds_;
    std::vector<VertexId> ring_;
};

}  // namespace

std::vector<FaceApex> apexesOf(const BrepModel& model, BrepFaceId id)
{
    std::vector<FaceApex> apexes;
    const BrepFace& face = model.faces[id];
    if (face.surface->kind() == SurfaceKind::Plane) return apexes;
    for (const BrepLoop& loop : face.loops) {
        for (const BrepCoedge& coedge : loop.coedges) {
            const BrepEdge& edge = model.edges[coedge.edge];
            if (!edge.isDegenerate || !coedge.parameterCurve) continue;
            FaceApex apex;
            apex.vertex = edge.first;
            const double from = coedge.isReversed ? edge.part.last : edge.part.first;
            const double to = coedge.isReversed ? edge.part.first : edge.part.last;
            apex.line = {coedge.parameterCurve->position(from), coedge.parameterCurve->position(to)};
            const Vec2 direction = apex.line[1] - apex.line[0];
            apex.isAlongU = std::abs(direction.x) * face.boundsV.length() >=
                            std::abs(direction.y) * face.boundsU.length();
            const SurfaceFacts facts = FaceGeometry(face).at(0.5 * (apex.line[0] + apex.line[1]));
            const bool isTip =
                (apex.isAlongU ? facts.isSingularU : facts.isSingularV) && facts.normal == Vec3{};
            if (!isTip) continue;
            placeRing(face, model.vertices[apex.vertex].position, apex);
            if (!apex.shares.empty()) apexes.push_back(std::move(apex));
        }
    }
    return apexes;
}

std::vector<BrepEdgeId> edgesAt(const BrepModel& model, BrepFaceId face, BrepVertexId vertex)
{
    std::vector<BrepEdgeId> edges;
    for (const BrepLoop& loop : model.faces[face].loops) {
        for (const BrepCoedge& coedge : loop.coedges) {
            const BrepEdge& edge = model.edges[coedge.edge];
            if (!edge.isDegenerate && (edge.first == vertex || edge.last == vertex))
                edges.push_back(coedge.edge);
        }
    }
    std::sort(edges.begin(), edges.end());
    edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
    return edges;
}

std::size_t insertApexRings(const BrepModel& model, BrepFaceId id, const CurveChains& chains,
                            FaceTriangulation& t)
{
    std::size_t open = 0;
    for (const FaceApex& apex : apexesOf(model, id)) {
        const double radius = chains.shellAround(apex.vertex);
        RingMaker maker(model.faces[id], apex, model.vertices[apex.vertex].position, radius, t);
        const bool isMade =
            radius > 0.0 && maker.findEnds(chains) && maker.insertPoints() && maker.holdSides();
        open += isMade ? 0 : 1;
    }
    return open;
}

bool isAtFan(const BrepModel& model, BrepFaceId id, const CurveChains& chains, const Vec3& point)
{
    constexpr double kReach = 1.5;
    for (const BrepLoop& loop : model.faces[id].loops) {
        for (const BrepCoedge& coedge : loop.coedges) {
            const BrepEdge& edge = model.edges[coedge.edge];
            if (!edge.isDegenerate) continue;
            const double reach = kReach * chains.shellAround(edge.first);
            if (squaredLength(point - model.vertices[edge.first].position) < reach * reach) return true;
        }
    }
    return false;
}

}  // namespace mesher
