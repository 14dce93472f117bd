#include "refinement/small_angle_guard.h"

#include "unit/refinement/refinement_fixture.h"

#include <cmath>

namespace mesher::test {
namespace {

TEST(SmallAngleGuard, FindsNoneInABox)
{
    const SampledSolid box = sampledBox({1, 1, 1}, 2);
    EXPECT_FALSE(SmallAngleGuard(box.tetrahedralization, box.splitter->mesh()).hasAny());
}

TEST(SmallAngleGuard, MeasuresTheEdgeOfAWedge)
{
    const SampledSolid wedge = sampledWedge(2.0, 1.0, 2.0, 4);
    const SurfaceMesh& surface = wedge.splitter->mesh();
    SmallAngleGuard guard(wedge.tetrahedralization, surface);
    ASSERT_TRUE(guard.hasAny());
    guard.collectPlaces(surface);
    const auto blame = guard.blameFor({0.1, 0.02, 1.1}, 0.5);
    ASSERT_TRUE(blame.has_value());
    EXPECT_EQ(blame->entity.dimension, 1);
    EXPECT_NEAR(blame->degrees, std::atan(0.5) * 180.0 / std::acos(-1.0), 1e-9);
    EXPECT_FALSE(guard.blameFor({1.9, 0.1, 1.1}, 0.5).has_value());
}

}  // namespace
}  // namespace mesher::test
