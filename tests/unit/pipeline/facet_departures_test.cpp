#include "pipeline/facet_departures.h"

#include "brep/analytic/round_surfaces.h"
#include "support/face_examples.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numbers>

namespace mesher::test {
namespace {

/// The largest distance from the face of points all over the facet.
double largestDistance(const FaceExample& example, const SurfaceFacet& facet)
{
    constexpr int kSteps = 24;
    double largest = 0.0;
    for (int i = 0; i <= kSteps; ++i) {
        for (int j = 0; i + j <= kSteps; ++j) {
            const std::array<double, 3> w{static_cast<double>(i) / kSteps, static_cast<double>(j) / kSteps,
                                          static_cast<double>(kSteps - i - j) / kSteps};
            Vec3 place;
            Vec2 uv;
            for (std::size_t k = 0; k < 3; ++k) {
                place = place + w[k] * example.nodes[facet.node[k]].position;
                uv = uv + w[k] * facet.parameters[k];
            }
            largest = std::max(largest, example.face.surface->project(place, uv).distance);
        }
    }
    return largest;
}

void expectBounds(const FaceExample& example, double most)
{
    BrepModel model;
    model.faces.push_back(example.face);
    SurfaceMesh mesh;
    mesh.nodes = example.nodes;
    for (const SurfaceFacet& facet : example.facets) mesh.facets.push_back(facet);
    const auto departures = facetDepartures(model, mesh);
    double total = 0.0, bound = 0.0;
    for (std::uint32_t f = 0; f < mesh.facets.size(); ++f) {
        const double distance = largestDistance(example, mesh.facets[FacetId(f)]);
        EXPECT_LE(distance, departures[FacetId(f)].distance + 1e-12) << "facet " << f;
        total += distance;
        bound += departures[FacetId(f)].distance;
    }
    EXPECT_LE(bound, most * total) << "a bound this loose has everything near projected";
}

TEST(FacetDepartures, BoundWhatFacetsOfASaddleDepart)
{
    // Along its inner equator a torus bends as much one way as the other: its facets have their centres on it.
    constexpr double kPi = std::numbers::pi;
    const auto torus = std::make_shared<TorusSurface>(Axes{}, 2.0, 1.0);
    for (const std::size_t cells : {2u, 4u, 7u})
        expectBounds(gridFace(torus, {0.0, 0.5 * kPi}, {0.7 * kPi, 1.3 * kPi}, cells, cells), 2.5);
}

TEST(FacetDepartures, BoundWhatFacetsOfAWavyFaceDepart)
{
    for (const std::size_t cells : {4u, 5u, 8u, 13u})
        expectBounds(gridFace(wavySpline(), {0.0, 4.0}, {0.0, 4.0}, cells, cells), 3.0);
}

TEST(FacetDepartures, BoundWhatCoarseFacetsOfASphereDepart) { expectBounds(octahedronOnSphere(3.0), 2.5); }

}  // namespace
}  // namespace mesher::test
