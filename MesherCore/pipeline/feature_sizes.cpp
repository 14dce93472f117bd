#include "pipeline/feature_sizes.h"

#include "pipeline/coarse_faces.h"
#include "pipeline/facet_departures.h"
#include "refinement/local_feature_size.h"
#include "sizing/distances.h"
#include "sizing/gradation.h"
#include "sizing/size_bounds.h"
#include "sizing/surface_size.h"
#include "surface_sampling/wall_survey.h"
#include "tetrahedralization/tetrahedralize.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace mesher {

namespace {

/// Of nodes, by their numbers; what the facets alone tell.
std::vector<double> featuresOnFaces(const SampledSurface& surface)
{
    const SurfaceMesh& mesh = surface.mesh();
    std::vector<double> features(mesh.nodes.size(), kNoSize);
    for (std::uint32_t f = 0; f < mesh.facets.size(); ++f) {
        const SurfaceFacet& facet = mesh.facets[FacetId(f)];
        if (!facet.isAlive() || surface.isOnFlatRim(FacetId(f))) continue;
        for (std::size_t i = 0; i < 3; ++i) {
            const Vec3& p = mesh.nodes[facet.node[i]].position;
            const Vec3& a = mesh.nodes[facet.node[(i + 1) % 3]].position;
            const Vec3& b = mesh.nodes[facet.node[(i + 2) % 3]].position;
            const Vec3 foot = a + closestShare(p, a, b) * (b - a);
            double& feature = features[facet.node[i].value];
            feature = std::min({feature, length(p - foot), length(p - a), length(p - b)});
        }
    }
    return features;
}

void lowerToSolids(const ConstrainedTetrahedralization& tets, const ThinWalls& walls,
                   std::vector<double>& features)
{
    const std::vector<double> inside = localFeatureSizes(tets.mesh(), &walls);
    for (std::uint32_t v = 0; v < inside.size() && v < tets.nodeOf.size(); ++v) {
        const NodeId node = tets.nodeOf[VertexId(v)];
        if (!node.isValid() || node.value >= features.size()) continue;
        features[node.value] = std::min(features[node.value], inside[v] / tets.scale);
    }
}

void gradeOnFaces(const SurfaceMesh& mesh, double grading, std::vector<double>& sizes)
{
    std::vector<GradationGraph::Edge> edges;
    for (const SurfaceFacet& facet : mesh.facets) {
        if (!facet.isAlive()) continue;
        for (std::size_t i = 0; i < 3; ++i) {
            const NodeId a = facet.node[i], b = facet.node[(i + 1) % 3];
            edges.push_back({a.value, b.value, length(mesh.nodes[b].position - mesh.nodes[a].position)});
        }
    }
    gradeSizes(GradationGraph::of(sizes.size(), edges), grading, sizes);
}

std::vector<SizedTriangle> sizedTriangles(const BrepModel& model, const SurfaceMesh& mesh,
                                          const std::vector<double>& sizes)
{
    const IdVector<FacetId, FacetDeparture> departures = facetDepartures(model, mesh);
    std::vector<SizedTriangle> triangles;
    for (std::uint32_t f = 0; f < mesh.facets.size(); ++f) {
        const SurfaceFacet& facet = mesh.facets[FacetId(f)];
        if (!facet.isAlive()) continue;
        SizedTriangle& triangle = triangles.emplace_back();
        for (std::size_t i = 0; i < 3; ++i) {
            triangle.corner[i] = mesh.nodes[facet.node[i]].position;
            triangle.size[i] = sizes[facet.node[i].value];
        }
        triangle.plateau = departures[FacetId(f)].distance;
    }
    return triangles;
}

bool isOver(StopReason reason) { return reason != StopReason::Done && reason != StopReason::CannotImprove; }

}  // namespace

FeatureSizes featureSizes(const BrepModel& model, const RegionSides& sides,
                          const SurfaceSamplingOptions& shape, double refinement, double grading,
                          RunContext& context)
{
    FeatureSizes result;
    const auto failed = [&](const Error& error) {
        result.failure = error;
        return result;
    };
    RunContext own(sizesSettings(context));
    own.limitTimeAs(context);
    const Result<SurfaceSample> sample = sampleSurface(model, shape, own);
    if (!sample) return failed(sample.error());
    if (!sample->failures.empty()) return failed(sample->failures.front().second);
    if (!sample->counts.certificate.errors.empty()) return failed(sample->counts.certificate.errors.front());
    result.stopReason = sample->stopReason;
    if (isOver(result.stopReason)) return result;
    std::vector<double> sizes;
    if (model.solids.empty()) {
        sizes = featuresOnFaces(*sample->surface);
    } else {
        const Result<Tetrahedralization> made =
            tetrahedralize(*sample->surface, sides, TetrahedralizationOptions{}, own);
        if (!made) return failed(made.error());
        result.stopReason = made->stopReason;
        if (isOver(result.stopReason)) return result;
        if (!made->failures.empty()) return failed(made->failures.front());
        sizes = featuresOnFaces(*sample->surface);
        ThinWalls walls(made->tets);
        walls.find(sample->surface->mesh(), shape.walls.maxTets,
                   facetsOnWalls(*sample->surface, sides, keptOf(sample->counts.surveyedWalls), own));
        lowerToSolids(made->tets, walls, sizes);
    }
    const SurfaceMesh& mesh = sample->surface->mesh();
    for (double& size : sizes) size *= kEdgeOfFeatureScale / refinement;
    gradeOnFaces(mesh, grading, sizes);
    result.field = std::make_shared<SurfaceSize>(sizedTriangles(model, mesh, sizes), 1.0 / grading);
    return result;
}

}  // namespace mesher
