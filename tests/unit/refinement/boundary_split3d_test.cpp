#include "refinement/boundary_split3d.h"

#include "unit/refinement/refinement_fixture.h"

#include <cmath>

namespace mesher::test {
namespace {

const auto kNothingMayBeEncroached = [](SegmentId) { return false; };

/// Splits `count` live entities, taken at random, and checks after each.
void splitMany(SampledSolid& solid, int count, std::uint64_t seed)
{
    BoundarySplitter3d boundary(solid.tetrahedralization, *solid.splitter);
    Random random(seed);
    int made = 0;
    for (int i = 0; i < count; ++i) {
        const SurfaceMesh& surface = solid.splitter->mesh();
        BoundarySplit3d split;
        const bool isSegment = !surface.segments.empty() && random.below(3) == 0;
        if (isSegment) {
            const SegmentId segment(random.below(static_cast<std::uint32_t>(surface.segments.size())));
            if (!surface.segments[segment].isAlive()) continue;
            split = boundary.splitSegment(segment);
        } else {
            const FacetId facet(random.below(static_cast<std::uint32_t>(surface.facets.size())));
            if (!surface.facets[facet].isAlive()) continue;
            split = boundary.splitFacet(facet, kNothingMayBeEncroached);
            if (split.outcome == SplitOutcome3d::EncroachesSegment) {
                ASSERT_TRUE(split.encroached.isValid());
                split = boundary.splitSegment(split.encroached);
            }
        }
        ASSERT_TRUE(isSound(solid)) << "split " << i;
        if (split.outcome != SplitOutcome3d::Split) continue;
        ++made;
        const NodeId node = solid.tetrahedralization.nodeOf[split.vertex];
        ASSERT_TRUE(node.isValid());
        EXPECT_EQ(solid.tetrahedralization.mesh().classification(split.vertex).dimension,
                  solid.splitter->mesh().nodes[node].entity.dimension);
    }
    EXPECT_GT(made, count / 4);
}

TEST(BoundarySplit3d, KeepsEverythingInAgreementOnEachKindOfSolid)
{
    SampledSolid box = sampledBox({1, 2, 1}, 2);
    splitMany(box, 60, 1);
    EXPECT_NEAR(meshedVolume(box), box.volume, 1e-12);
    SampledSolid sphere = sampledSphere(1.0, 40);
    splitMany(sphere, 100, 2);
    SampledSolid cylinder = sampledCylinder(1.0, 2.0, 12);
    splitMany(cylinder, 100, 3);
    SampledSolid torus = sampledTorus(2.0, 1.0, 20);
    splitMany(torus, 100, 4);
    SampledSolid wedge = sampledWedge(2.0, 1.0, 2.0, 3);
    splitMany(wedge, 60, 5);
}

TEST(BoundarySplit3d, KeepsEverythingInAgreementOnCoarseCurvedSolids)
{
    for (std::uint64_t seed = 1; seed <= 12; ++seed) {
        SCOPED_TRACE(seed);
        SampledSolid sphere = sampledSphere(1.0, 5 + static_cast<std::uint32_t>(seed));
        splitMany(sphere, 30, seed);
        SampledSolid cylinder = sampledCylinder(1.0, 1.0, 5 + static_cast<std::uint32_t>(seed % 3));
        splitMany(cylinder, 30, seed);
    }
}

TEST(BoundarySplit3d, BringsACurvedSurfaceNearerToItsVolume)
{
    SampledSolid sphere = sampledSphere(1.0, 150);
    const double before = meshedVolume(sphere);
    BoundarySplitter3d boundary(sphere.tetrahedralization, *sphere.splitter);
    const std::size_t facets = sphere.splitter->mesh().facets.size();
    for (std::uint32_t i = 0; i < facets; ++i) {
        if (!sphere.splitter->mesh().facets[FacetId(i)].isAlive()) continue;
        EXPECT_EQ(boundary.splitFacet(FacetId(i), kNothingMayBeEncroached).outcome, SplitOutcome3d::Split);
    }
    EXPECT_TRUE(isSound(sphere));
    EXPECT_LT(sphere.volume - meshedVolume(sphere), 0.6 * (sphere.volume - before));
}

TEST(BoundarySplit3d, DeletesInteriorVerticesInTheBallOfTheFacet)
{
    SampledSolid box = sampledBox({1, 1, 1}, 1);
    ConstrainedTetrahedralization& t = box.tetrahedralization;
    const auto inserted = t.delaunay->insert({0.3, 0.55, 0.05});
    ASSERT_TRUE(inserted.hasValue());
    t.nodeOf.resize(t.mesh().vertexLimit());
    ASSERT_TRUE(isSound(box));
    const SurfaceMesh& surface = box.splitter->mesh();
    FacetId bottom;
    for (std::uint32_t i = 0; i < surface.facets.size(); ++i) {
        if (surface.facets[FacetId(i)].face == BrepFaceId(4)) bottom = FacetId(i);
    }
    BoundarySplitter3d boundary(t, *box.splitter);
    EXPECT_EQ(boundary.splitFacet(bottom, [](SegmentId) { return true; }).outcome, SplitOutcome3d::Split);
    EXPECT_EQ(boundary.counts().deletedVertices, 1u);
    EXPECT_FALSE(t.mesh().isVertexAlive(inserted->vertex) && !t.nodeOf[inserted->vertex].isValid());
    EXPECT_TRUE(isSound(box));
}

}  // namespace
}  // namespace mesher::test
