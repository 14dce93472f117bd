#include "refinement/facet_swap3d.h"

#include "unit/refinement/refinement_fixture.h"

#include <gtest/gtest.h>

#include <vector>

namespace mesher::test {
namespace {

/// A box with vertices outside above its top, so that the diagonals of the squares there have many tetrahedra outside.
class FacetSwap : public testing::Test
{
protected:
    void SetUp() override
    {
        // Beside the diagonals, whichever the squares of the top have.
        for (const Vec3& p :
             {Vec3{0.7, 0.4, 1.3}, Vec3{0.4, 0.7, 1.3}, Vec3{0.3, 0.3, 1.3}, Vec3{0.8, 0.8, 1.3}})
            ASSERT_TRUE(solid_.tetrahedralization.delaunay->insert(p).hasValue());
        solid_.tetrahedralization.nodeOf.resize(mesh_.vertexLimit());
        state_.scale.setInitial();
    }
    [[nodiscard]] std::size_t countAt(VertexId a, VertexId b, RegionId region) const
    {
        std::vector<TetId> ring;
        mesh_.collectEdgeRing(mesh_.findEdge(a, b), a, b, ring);
        return static_cast<std::size_t>(std::count_if(ring.begin(), ring.end(), [&](TetId t) {
            return !mesh_.isGhostTet(t) && mesh_.region(t) == region;
        }));
    }
    /// A face between the only two tetrahedra of the solid at a diagonal with more than two outside; invalid without one.
    [[nodiscard]] TetFace faceAtCrowdedDiagonal() const
    {
        for (const TetId tet : meshedTets(solid_)) {
            for (int f = 0; f < 4; ++f) {
                if (mesh_.isFaceConstrained({tet, f})) continue;
                const auto corner = mesh_.faceVertices({tet, f});
                for (unsigned k = 0; k < 3; ++k) {
                    const VertexId a = corner[k];
                    const VertexId b = corner[(k + 1) % 3];
                    const bool isOnTop = mesh_.position(a).z == 1.0 && mesh_.position(b).z == 1.0;
                    if (isOnTop && state_.segmentAt(a, b) == nullptr &&
                        countAt(a, b, mesh_.region(tet)) == 2 && countAt(a, b, kExteriorRegion) > 2)
                        return {tet, f};
                }
            }
        }
        return {};
    }

    SampledSolid solid_ = sampledBox({1, 1, 1}, 2);
    DelaunayRefinementOptions3d options_;
    RunContext context_;
    RefinementState3d state_{solid_.tetrahedralization, *solid_.splitter, options_, context_};
    Triangulation3d& mesh_ = solid_.tetrahedralization.mesh();
};

TEST_F(FacetSwap, PutsAVertexOutsideWhereTetrahedraThereAreInTheWay)
{
    const TetFace face = faceAtCrowdedDiagonal();
    ASSERT_TRUE(face.isValid());
    const std::uint32_t vertices = mesh_.vertexCount();
    FacetSwap3d swap(state_);
    EXPECT_TRUE(swap.swapAt(face, FacetSwap3d::kNearlyPlane));
    EXPECT_TRUE(isSound(solid_));
    EXPECT_EQ(mesh_.vertexCount(), vertices + 1);
    EXPECT_EQ(state_.counts.outsideVertices, 1u);
    EXPECT_EQ(state_.counts.facetSwaps, 1u);
    EXPECT_EQ(state_.counts.bentSwaps, 0u);
}

TEST_F(FacetSwap, MayMoveAFrozenSurfaceByRoundingOnly)
{
    FacetSwap3d swap(state_);
    EXPECT_EQ(swap.mostHeight(), FacetSwap3d::kThin);
    options_.boundary = BoundaryPolicy::Frozen;
    EXPECT_EQ(swap.mostHeight(), FacetSwap3d::kNearlyPlane);
}

}  // namespace
}  // namespace mesher::test
