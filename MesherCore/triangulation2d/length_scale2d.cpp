#include "triangulation2d/length_scale2d.h"

#include "sizing/gradation.h"

#include <algorithm>
#include <limits>
#include <vector>

namespace mesher {
namespace {

/// Distance from a vertex to the subcurve of the edge opposite of it.
double distanceToSubcurve(const PlanarDomain& domain, const PlanarTriangulation& triangulation, SubcurveId s,
                          VertexId v)
{
    const Subcurve& subcurve = triangulation.boundary.subcurves[s];
    const Vec2 p = triangulation.mesh().position(v);
    const Vec2 a = triangulation.boundary.from(s);
    const Vec2 edge = triangulation.boundary.to(s) - a;
    const double along = std::clamp(dot(p - a, edge) / squaredLength(edge), 0.0, 1.0);
    const double toEdge = length(p - (a + along * edge));
    if (domain.curve(subcurve.curve).curve->kind() == CurveKind::Line) return toEdge;
    const CurveProjection foot =
        domain.curve(subcurve.curve)
            .curve->project(domain.toSpace(p), subcurve.part, subcurve.part.at(along));
    // The projection is a local minimum: with a bad seed the edge tells more.
    return std::min(foot.distance * domain.scale(), toEdge);
}

}  // namespace

double localFeatureSize(const PlanarDomain& domain, const PlanarTriangulation& triangulation, VertexId v)
{
    const Triangulation2d& mesh = triangulation.mesh();
    double size = std::numeric_limits<double>::infinity();
    mesh.forEachTriangleAround(v, [&](EdgeLink opposite) {
        if (!triangulation.isMeshed(opposite.triangle())) return true;
        for (const VertexId w : {mesh.edgeFrom(opposite), mesh.edgeTo(opposite)}) {
            size = std::min(size, length(mesh.position(w) - mesh.position(v)));
        }
        if (mesh.isConstrained(opposite)) {
            const SubcurveId s = triangulation.subcurveOf(opposite);
            size = std::min(size, distanceToSubcurve(domain, triangulation, s, v));
        }
        return true;
    });
    return size;
}

double wantedSize(const PlanarDomain& domain, const PlanarSizing& sizing, Vec2 position)
{
    if (sizing.field == nullptr) return std::numeric_limits<double>::infinity();
    return domain.scale() * sizing.field->sizeAt(domain.toSpace(position));
}

void setLengthScales(const PlanarDomain& domain, const PlanarSizing& sizing,
                     PlanarTriangulation& triangulation)
{
    const Triangulation2d& mesh = triangulation.mesh();
    std::vector<double> sizes(mesh.vertexSlots(), std::numeric_limits<double>::infinity());
    for (std::uint32_t i = 0; i < mesh.vertexSlots(); ++i) {
        const VertexId v(i);
        if (!mesh.isAlive(v)) continue;
        if (sizing.usesLocalFeatureSize)
            sizes[i] = localFeatureSize(domain, triangulation, v) / sizing.refinement;
        sizes[i] = std::min(sizes[i], wantedSize(domain, sizing, mesh.position(v)));
    }
    std::vector<GradationGraph::Edge> edges;
    for (std::uint32_t i = 0; i < mesh.triangleSlots(); ++i) {
        const TriangleId t(i);
        if (!mesh.isAlive(t) || !triangulation.isMeshed(t)) continue;
        const Triangle2d& record = mesh.triangle(t);
        for (unsigned edge = 0; edge < 3; ++edge) {
            const bool isOther = triangulation.isMeshed(record.n[edge].triangle());
            if (isOther && record.n[edge].triangle() < t) continue;
            const VertexId a = record.v[nextCorner(edge)];
            const VertexId b = record.v[previousCorner(edge)];
            edges.push_back({a.value, b.value, length(mesh.position(b) - mesh.position(a))});
        }
    }
    gradeSizes(GradationGraph::of(sizes.size(), edges), sizing.grading, sizes);
    for (std::uint32_t i = 0; i < sizes.size(); ++i) {
        if (mesh.isAlive(VertexId(i))) triangulation.delaunay.setLengthScale(VertexId(i), sizes[i]);
    }
}

double lengthScaleOfCavity(const PlanarDomain& domain, const PlanarSizing& sizing,
                           const Triangulation2d& mesh, const Cavity2d& cavity)
{
    const double perDistance = 1.0 / sizing.grading;
    double scale = std::numeric_limits<double>::infinity();
    for (const Cavity2d::BoundaryEdge& edge : cavity.boundary) {
        const VertexId w = mesh.edgeFrom(edge.outer);
        scale = std::min(scale, mesh.lengthScale(w) + length(cavity.point - mesh.position(w)) * perDistance);
    }
    return std::min(scale, wantedSize(domain, sizing, cavity.point));
}

double gradedLengthScale(const PlanarTriangulation& triangulation, const PlanarSizing& sizing, VertexId v)
{
    const Triangulation2d& mesh = triangulation.mesh();
    double scale = std::numeric_limits<double>::infinity();
    mesh.forEachTriangleAround(v, [&](EdgeLink opposite) {
        if (!triangulation.isMeshed(opposite.triangle())) return true;
        for (const VertexId w : {mesh.edgeFrom(opposite), mesh.edgeTo(opposite)}) {
            const double distance = length(mesh.position(w) - mesh.position(v));
            scale = std::min(scale, mesh.lengthScale(w) + distance / sizing.grading);
        }
        return true;
    });
    return scale;
}

double interpolatedLengthScale(const PlanarDomain& domain, const Subcurve& whole, double t, double firstScale,
                               double lastScale)
{
    const TangentVariation& table = domain.variation(whole.curve);
    const double before = table.arcLength(whole.part.first, t);
    const double after = table.arcLength(t, whole.part.last);
    return before + after > 0.0 ? (firstScale * after + lastScale * before) / (before + after) : firstScale;
}

void gradeAgainFrom(VertexId v, const PlanarSizing& sizing, PlanarTriangulation& triangulation,
                    std::vector<VertexId>& lowered)
{
    // Differences of rounding size are not worth a wave through the mesh.
    constexpr double kSlack = 1.0 + 1e-9;
    const Triangulation2d& mesh = triangulation.mesh();
    lowered.clear();
    const auto relaxAround = [&](VertexId w) {
        mesh.forEachTriangleAround(w, [&](EdgeLink opposite) {
            if (!triangulation.isMeshed(opposite.triangle())) return true;
            for (const VertexId neighbour : {mesh.edgeFrom(opposite), mesh.edgeTo(opposite)}) {
                const double distance = length(mesh.position(neighbour) - mesh.position(w));
                const double allowed = mesh.lengthScale(w) + distance / sizing.grading;
                if (mesh.lengthScale(neighbour) <= allowed * kSlack) continue;
                triangulation.delaunay.setLengthScale(neighbour, allowed);
                lowered.push_back(neighbour);
            }
            return true;
        });
    };
    relaxAround(v);
    for (std::size_t i = 0; i < lowered.size(); ++i) relaxAround(lowered[i]);
}

}  // namespace mesher
