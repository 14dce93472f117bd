#include "mesh/region_sides.h"

#include <gtest/gtest.h>

namespace mesher {
namespace {

BrepModel modelOf(std::uint32_t faces, const std::vector<BrepSolid>& solids)
{
    BrepModel model;
    model.faces.resize(faces);
    for (const BrepSolid& solid : solids) model.solids.push_back(solid);
    return model;
}

BrepShell shellOf(const std::vector<BrepShellFace>& faces) { return {faces, true}; }

TEST(RegionSides, putsASolidBehindItsOutwardNormals)
{
    const auto sides =
        regionSidesOf(modelOf(3, {{{shellOf({{BrepFaceId(0u), false}, {BrepFaceId(1u), true}})}}}));
    ASSERT_TRUE(sides);
    EXPECT_EQ((*sides)[BrepFaceId(0u)], (std::array{RegionId(0u), RegionId(1u)}));
    EXPECT_EQ((*sides)[BrepFaceId(1u)], (std::array{RegionId(1u), RegionId(0u)}));
    EXPECT_EQ((*sides)[BrepFaceId(2u)], (std::array{RegionId(0u), RegionId(0u)})) << "of no solid";
}

TEST(RegionSides, knowsSharedFacesVoidsAndFacesInside)
{
    const BrepSolid first{{shellOf({{BrepFaceId(0u), false}}), shellOf({{BrepFaceId(1u), true}})}};
    const BrepSolid second{
        {shellOf({{BrepFaceId(0u), true}, {BrepFaceId(2u), false}, {BrepFaceId(2u), true}})}};
    const auto sides = regionSidesOf(modelOf(3, {first, second}));
    ASSERT_TRUE(sides);
    EXPECT_EQ((*sides)[BrepFaceId(0u)], (std::array{RegionId(2u), RegionId(1u)}));
    EXPECT_EQ((*sides)[BrepFaceId(1u)], (std::array{RegionId(1u), RegionId(0u)})) << "a void behind";
    EXPECT_EQ((*sides)[BrepFaceId(2u)], (std::array{RegionId(2u), RegionId(2u)})) << "in the solid";
}

TEST(RegionSides, refusesTwoSolidsOnOneSide)
{
    const BrepSolid solid{{shellOf({{BrepFaceId(1u), false}})}};
    const auto sides = regionSidesOf(modelOf(2, {solid, solid}));
    ASSERT_FALSE(sides);
    EXPECT_EQ(sides.error().code, ErrorCode::InvalidArgument);
    EXPECT_EQ(sides.error().entity, "Face2");
}

}  // namespace
}  // namespace mesher
