#include "surface_sampling/sample_surface.h"

#include "brep/analytic/solids.h"
#include "quality/triangle_measures.h"
#include "sizing/size_bounds.h"
#include "support/model_union.h"
#include "surface_sampling/face_mesh_check.h"
#include "surface_sampling/facet_intersections.h"
#include "surface_sampling/surface_check.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numbers>
#include <string>
#include <string_view>
#include <utility>

namespace mesher::test {
namespace {

constexpr double kPi = std::numbers::pi;

struct NamedModel
{
    std::string name;
    BrepModel model;
    double size = 0.1;
    double volume = 0.0;
};

const Axes kTilted{{1.0, 2.0, 3.0}, {0.6, 0.8, 0.0}, {-0.48, 0.36, 0.8}, {0.64, -0.48, 0.6}};

/// Without small angles between edges or at an apex.
std::vector<NamedModel> ordinarySolids()
{
    std::vector<NamedModel> models;
    const auto add = [&](const char* name, Result<BrepModel> model, double size, double volume) {
        models.push_back({name, std::move(*model), size, volume});
    };
    add("box", makeBox({-1.0, 0.0, 0.5}, {0.0, 2.0, 1.0}), 0.15, 1.0);
    add("cylinder", makeCylinder(kTilted, 1.0, 3.0), 0.2, 3.0 * kPi);
    add("frustum", makeCone(kTilted, 2.0, 1.0, 2.0), 0.25, 2.0 * kPi * 7.0 / 3.0);
    add("cone", makeCone(kTilted, 2.0, 0.0, 2.0), 0.24, 8.0 * kPi / 3.0);
    add("sphere", makeSphere(kTilted, 1.0), 0.12, 4.0 * kPi / 3.0);
    add("torus", makeTorus(kTilted, 2.0, 0.5), 0.15, kPi * kPi);
    return models;
}

Result<SurfaceSample> sample(const BrepModel& model, double size, unsigned threads = 1)
{
    SurfaceSamplingOptions options;
    options.facets.maxSize = size;
    RunSettings settings;
    settings.threads = threads;
    RunContext context(settings);
    return sampleSurface(model, options, context);
}

TriangleShape shapeOf(const SurfaceMesh& mesh, const SurfaceFacet& facet)
{
    return mesher::shapeOf({mesh.nodes[facet.node[0]].position, mesh.nodes[facet.node[1]].position,
                            mesh.nodes[facet.node[2]].position});
}

void expectSound(const BrepModel& model, SampledSurface& surface)
{
    const SurfaceCheck check = checkSurfaceMesh(model, surface.mesh());
    EXPECT_EQ(check.problem(), "");
    for (std::uint32_t f = 0; f < model.faces.size(); ++f) {
        SampledFace* face = surface.faces().face(BrepFaceId(f));
        ASSERT_NE(face, nullptr);
        EXPECT_EQ(checkFaceMesh(face->mesh, face->geometry).report.problem, "");
    }
}

TEST(SampleSurface, MeetsSizeAndAngleOnWholeSolids)
{
    for (const NamedModel& named : ordinarySolids()) {
        SCOPED_TRACE(named.name);
        const Result<SurfaceSample> result = sample(named.model, named.size);
        ASSERT_TRUE(result.hasValue());
        EXPECT_EQ(result->stopReason, StopReason::Done);
        EXPECT_TRUE(result->failures.empty());
        EXPECT_TRUE(result->counts.certificate.errors.empty());
        expectSound(named.model, *result->surface);
        const SurfaceMesh& mesh = result->surface->mesh();
        double least = 180.0, longest = 0.0;
        for (const SurfaceFacet& facet : mesh.facets) {
            const TriangleShape shape = shapeOf(mesh, facet);
            least = std::min(least, shape.minAngle);
            longest = std::max(longest, shape.longestEdge);
        }
        EXPECT_GE(least, 30.0 - 1e-6);
        EXPECT_LE(longest, 2.0 * kEdgeSizeBounds.facet * named.size * (1.0 + 1e-9));
        EXPECT_GT(longest, 0.9 * named.size);
        const SurfaceCheck check = checkSurfaceMesh(named.model, mesh);
        EXPECT_NEAR(check.volumes[BrepSolidId(0)], named.volume, 0.02 * named.volume);
        EXPECT_EQ(result->counts.refinement.leftForResolution, 0u);
    }
}

TEST(SampleSurface, IsTheSameForAnyNumberOfThreads)
{
    for (const NamedModel& named : ordinarySolids()) {
        SCOPED_TRACE(named.name);
        const Result<SurfaceSample> alone = sample(named.model, 0.5 * named.size, 1);
        const Result<SurfaceSample> shared = sample(named.model, 0.5 * named.size, 3);
        ASSERT_TRUE(alone.hasValue() && shared.hasValue());
        const SurfaceMesh &a = alone->surface->mesh(), &b = shared->surface->mesh();
        ASSERT_EQ(a.nodes.size(), b.nodes.size());
        ASSERT_EQ(a.facets.size(), b.facets.size());
        ASSERT_EQ(a.segments.size(), b.segments.size());
        for (std::uint32_t i = 0; i < a.nodes.size(); ++i) {
            ASSERT_EQ(a.nodes[NodeId(i)].position, b.nodes[NodeId(i)].position);
            ASSERT_EQ(a.nodes[NodeId(i)].entity, b.nodes[NodeId(i)].entity);
        }
        for (std::uint32_t i = 0; i < a.facets.size(); ++i) {
            ASSERT_EQ(a.facets[FacetId(i)].node, b.facets[FacetId(i)].node);
            ASSERT_EQ(a.facets[FacetId(i)].parameters, b.facets[FacetId(i)].parameters);
        }
    }
}

TEST(SampleSurface, EndsAtTheLimitOfVerticesWithASoundMesh)
{
    const Result<BrepModel> model = makeCylinder(Axes{}, 1.0, 3.0);
    ASSERT_TRUE(model.hasValue());
    SurfaceSamplingOptions options;
    options.facets.maxSize = 0.01;
    options.limits.maxVertices = 3000;
    RunContext context;
    const Result<SurfaceSample> result = sampleSurface(*model, options, context);
    ASSERT_TRUE(result.hasValue());
    EXPECT_EQ(result->stopReason, StopReason::VertexLimit);
    EXPECT_LT(result->counts.vertices, 3u * 3000u);
    expectSound(*model, *result->surface);
}

/// A run whose progress hook ends it when a stage is told the second time.
StopReason stopReasonWhenCancelledIn(const BrepModel& model, std::string_view stage, int& callsAfter)
{
    SurfaceSamplingOptions options;
    options.facets.maxSize = 0.05;
    int calls = 0;
    callsAfter = 0;
    RunSettings settings;
    settings.progress = [&](std::string_view told, double fraction) {
        EXPECT_TRUE(0.0 <= fraction && fraction <= 1.0);
        if (calls >= 2) ++callsAfter;
        calls += told == stage ? 1 : 0;
        return calls < 2;
    };
    RunContext context(settings);
    const Result<SurfaceSample> result = sampleSurface(model, options, context);
    EXPECT_TRUE(result.hasValue());
    if (result && stage != "first facets") expectSound(model, *result->surface);
    return result ? result->stopReason : StopReason::Done;
}

TEST(SampleSurface, EndsInEachStageWhenItIsCancelled)
{
    BrepModel model = *makeCylinder(Axes{}, 1.0, 3.0);
    for (int i = 1; i < 8; ++i) {
        model = together(std::move(model), *makeCylinder({{3.0 * i, 0.0, 0.0}}, 1.0, 3.0));
    }
    for (const std::string_view stage : {"first facets", "surfaces", "intersections"}) {
        int callsAfter = 0;
        EXPECT_EQ(stopReasonWhenCancelledIn(model, stage, callsAfter), StopReason::Cancelled) << stage;
        EXPECT_EQ(callsAfter, 0) << stage;
    }
}

TEST(SampleSurface, SharesOneTimeLimitAmongItsStages)
{
    const Result<BrepModel> model = makeCylinder(Axes{}, 1.0, 3.0);
    SurfaceSamplingOptions options;
    RunContext context;
    context.limitTime(0.0);
    const Result<SurfaceSample> result = sampleSurface(*model, options, context);
    ASSERT_TRUE(result.hasValue());
    EXPECT_EQ(result->stopReason, StopReason::TimeLimit);
    EXPECT_TRUE(result->failures.empty()) << "no face is at fault";
}

TEST(SampleSurface, RefusesOptionsOutOfRange)
{
    const Result<BrepModel> model = makeBox({}, {1.0, 1.0, 1.0});
    RunContext context;
    SurfaceSamplingOptions options;
    options.facets.minAngle = 45.0;
    EXPECT_FALSE(sampleSurface(*model, options, context).hasValue());
    options = {};
    options.facets.maxSize = -1.0;
    EXPECT_FALSE(sampleSurface(*model, options, context).hasValue());
    options = {};
    options.encroachmentAngle = 60.0;
    EXPECT_FALSE(sampleSurface(*model, options, context).hasValue());
}

TEST(SurfaceCertificate, RefinesAThinShellUntilItsWallsDoNotCross)
{
    const BrepModel model =
        together(std::move(*makeSphere(kTilted, 1.0)), *makeSphere(Axes{kTilted.origin}, 0.985));
    SurfaceSamplingOptions options;
    options.facets.maxSize = 0.5;
    options.maxCertificateRounds = -1;
    RunContext context;
    const Result<SurfaceSample> coarse = sampleSurface(model, options, context);
    ASSERT_TRUE(coarse.hasValue());
    EXPECT_FALSE(findFacetIntersections(model, coarse->surface->mesh(), context).empty()) << "nothing to do";
    options.maxCertificateRounds = 20;
    const Result<SurfaceSample> result = sampleSurface(model, options, context);
    ASSERT_TRUE(result.hasValue());
    EXPECT_GT(result->counts.certificate.found, 0u);
    EXPECT_EQ(result->counts.certificate.left, 0u);
    EXPECT_TRUE(findFacetIntersections(model, result->surface->mesh(), context).empty());
    EXPECT_GT(result->counts.vertices, coarse->counts.vertices);
    expectSound(model, *result->surface);
}

TEST(SurfaceCertificate, FindsTheIntersectionsOfTheFacetsAskedFor)
{
    const BrepModel model =
        together(std::move(*makeSphere(kTilted, 1.0)), *makeSphere(Axes{kTilted.origin}, 0.985));
    SurfaceSamplingOptions options;
    options.facets.maxSize = 0.5;
    options.maxCertificateRounds = -1;
    RunContext context;
    const Result<SurfaceSample> sample = sampleSurface(model, options, context);
    ASSERT_TRUE(sample.hasValue());
    const SurfaceMesh& mesh = sample->surface->mesh();
    const auto pairsOf = [](const std::vector<FacetIntersection>& found) {
        std::vector<std::pair<FacetId, FacetId>> pairs;
        for (const FacetIntersection& each : found) pairs.emplace_back(each.first, each.second);
        return pairs;
    };
    const auto all = pairsOf(findFacetIntersections(model, mesh, context));
    FacetMarks asked(mesh.facets.size(), 0);
    EXPECT_TRUE(findFacetIntersections(model, mesh, asked, context).empty());
    // None, a few far from one another, and many, of those that do meet others.
    for (const std::size_t step : {50, 3}) {
        for (std::size_t i = 0; i < all.size(); i += step) asked[all[i].first] = 1;
        auto expected = all;
        std::erase_if(expected, [&](const auto& p) { return asked[p.first] == 0 && asked[p.second] == 0; });
        EXPECT_FALSE(expected.empty());
        EXPECT_LT(expected.size(), all.size());
        EXPECT_EQ(pairsOf(findFacetIntersections(model, mesh, asked, context)), expected);
    }
}

TEST(SurfaceCertificate, NamesTheFacesThatCross)
{
    const BrepModel model =
        together(std::move(*makeSphere(Axes{}, 1.0)), *makeSphere(Axes{{0.5, 0.0, 0.0}}, 1.0));
    SurfaceSamplingOptions options;
    options.facets.maxSize = 0.4;
    options.maxCertificateRounds = 2;
    RunContext context;
    const Result<SurfaceSample> result = sampleSurface(model, options, context);
    ASSERT_TRUE(result.hasValue());
    ASSERT_EQ(result->counts.certificate.errors.size(), 1u);
    const Error& error = result->counts.certificate.errors.front();
    EXPECT_EQ(error.entity, "Face1 and Face2");
    ASSERT_TRUE(error.point.has_value());
    EXPECT_NEAR(error.point->x, 0.25, 0.3) << "the spheres cross in the plane x = 0.25";
}

void splitManyTimes(const BrepModel& model, SampledSurface& surface, SurfaceSplitExtent extent)
{
    SurfaceSplit split;
    std::size_t facetSplits = 0, segmentSplits = 0, notFound = 0;
    for (std::uint32_t i = 0; i < 800; ++i) {
        const SurfaceMesh& mesh = surface.mesh();
        if (i % 4 == 0) {
            SegmentId segment((i * 7) % static_cast<std::uint32_t>(mesh.segments.size()));
            while (!mesh.segments[segment].isAlive()) {
                segment.value = (segment.value + 1) % static_cast<std::uint32_t>(mesh.segments.size());
            }
            surface.evaluateSegment(segment, extent, split);
        } else {
            const FacetId facet((i * 31) % static_cast<std::uint32_t>(mesh.facets.size()));
            if (!mesh.facets[facet].isAlive()) continue;
            surface.evaluateFacet(facet, extent, split);
        }
        if (split.status != SurfaceSplitStatus::Ready) {
            notFound += split.status == SurfaceSplitStatus::NotFound ? 1 : 0;
            continue;
        }
        ++(split.segment.isValid() ? segmentSplits : facetSplits);
        const std::size_t nodes = mesh.nodes.size();
        for (const FacetId removed : split.removed) EXPECT_TRUE(mesh.facets[removed].isAlive());
        const SurfaceSplitResult made = surface.commit(split);
        EXPECT_EQ(mesh.nodes.size(), nodes + 1);
        EXPECT_EQ(made.added.size(), split.added.size());
        for (const FacetId removed : split.removed) EXPECT_FALSE(mesh.facets[removed].isAlive());
        for (std::size_t k = 0; k < made.added.size(); ++k) {
            EXPECT_EQ(mesh.facets[made.added[k]].node[0], made.node);
            EXPECT_EQ(mesh.facets[made.added[k]].node[1], split.added[k].node[1]);
        }
        const std::size_t most = extent == SurfaceSplitExtent::Least ? 6 : mesh.facets.size();
        EXPECT_LE(split.removed.size(), most);
    }
    EXPECT_GT(facetSplits, 60u);
    EXPECT_GE(segmentSplits, 4u);
    // Without flips facets become flat, and folds can be the only way to split them.
    EXPECT_LE(notFound, extent == SurfaceSplitExtent::Least ? facetSplits / 10 : 0);
    expectSound(model, surface);
}

TEST(SampledSurface, StaysSoundThroughSplitsOfFacetsAndSegments)
{
    for (const NamedModel& named : ordinarySolids()) {
        SCOPED_TRACE(named.name);
        for (const SurfaceSplitExtent extent : {SurfaceSplitExtent::Delaunay, SurfaceSplitExtent::Least}) {
            Result<SurfaceSample> result = sample(named.model, 1.4 * named.size);
            ASSERT_TRUE(result.hasValue());
            splitManyTimes(named.model, *result->surface, extent);
        }
    }
}

/// Swaps diagonals all over the surface and back, so that it ends as good as it was.
std::size_t swapManyTimes(SampledSurface& surface)
{
    const SurfaceMesh& mesh = surface.mesh();
    std::size_t swaps = 0;
    const auto facets = static_cast<std::uint32_t>(mesh.facets.size());
    for (std::uint32_t i = 0; i < facets; ++i) {
        for (std::uint32_t k = i + 1; k < facets && mesh.facets[FacetId(i)].isAlive(); ++k) {
            if (!mesh.facets[FacetId(k)].isAlive() || !surface.maySwap(FacetId(i), FacetId(k))) continue;
            const BrepFaceId face = mesh.facets[FacetId(i)].face;
            const auto made = surface.swap(FacetId(i), FacetId(k));
            EXPECT_FALSE(mesh.facets[FacetId(i)].isAlive() || mesh.facets[FacetId(k)].isAlive());
            EXPECT_EQ(mesh.facets[made[0]].face, face);
            EXPECT_EQ(mesh.facets[made[1]].face, face);
            EXPECT_TRUE(surface.maySwap(made[0], made[1]));
            surface.swap(made[0], made[1]);
            ++swaps;
        }
    }
    return swaps;
}

TEST(SampledSurface, StaysSoundThroughSwapsOfDiagonals)
{
    for (const NamedModel& named : ordinarySolids()) {
        SCOPED_TRACE(named.name);
        Result<SurfaceSample> result = sample(named.model, 1.4 * named.size);
        ASSERT_TRUE(result.hasValue());
        EXPECT_GT(swapManyTimes(*result->surface), 20u);
        expectSound(named.model, *result->surface);
        // Splits find the facets that swaps have made.
        splitManyTimes(named.model, *result->surface, SurfaceSplitExtent::Delaunay);
    }
}

TEST(SampledSurface, SwapsNoDiagonalAcrossAnEdgeOfTheModel)
{
    const BrepModel model = *makeBox({-1.0, 0.0, 0.5}, {0.0, 2.0, 1.0});
    Result<SurfaceSample> result = sample(model, 0.5);
    ASSERT_TRUE(result.hasValue());
    const SurfaceMesh& mesh = result->surface->mesh();
    for (std::uint32_t i = 0; i < mesh.facets.size(); ++i) {
        for (std::uint32_t k = 0; k < mesh.facets.size(); ++k) {
            if (mesh.facets[FacetId(i)].face == mesh.facets[FacetId(k)].face) continue;
            EXPECT_FALSE(result->surface->maySwap(FacetId(i), FacetId(k)));
        }
    }
}

}  // namespace
}  // namespace mesher::test
