#include "refinement/refinement_criteria.h"

#include "unit/refinement/refinement_fixture.h"

#include <cmath>

namespace mesher::test {
namespace {

/// One tetrahedron with a length scale at its corners.
struct OneTet
{
    ConstrainedTetrahedralization t;
    TetId tet;

    OneTet(const std::array<Vec3, 4>& corners, double lengthScale)
    {
        t.delaunay = std::make_unique<Delaunay3d>();
        insertEach(*t.delaunay, corners);
        tet = finiteTets(t.mesh()).front();
        t.mesh().setRegion(tet, RegionId(1u));
        for (const VertexId v : liveVertices(t.mesh())) t.mesh().setLengthScale(v, lengthScale);
    }
    [[nodiscard]] TetVerdict judge(const TetQualityLimits& limits = {}, bool usesSize = true)
    {
        VolumeSizing sizing;
        sizing.usesLocalFeatureSize = usesSize;
        LengthScale3d scale(t, sizing);
        const auto wanted = t.mesh().lengthScale(VertexId(0u));
        scale.setInitial();
        for (const VertexId v : liveVertices(t.mesh())) t.mesh().setLengthScale(v, wanted);
        return RefinementCriteria3d(t.mesh(), scale, limits).judge(tet);
    }
};

/// Edges of 2 sqrt(2), circumradius sqrt(3).
const std::array<Vec3, 4> kRegular = {{{1, 1, 1}, {1, -1, -1}, {-1, 1, -1}, {-1, -1, 1}}};

TEST(RefinementCriteria3d, CallsATetrahedronTooLargeAboveHalfRootThreeOfItsLengthScale)
{
    EXPECT_EQ(OneTet(kRegular, 2.001).judge().need, TetNeed::Nothing);
    EXPECT_EQ(OneTet(kRegular, 1.999).judge().need, TetNeed::Size);
    EXPECT_EQ(OneTet(kRegular, 1.999).judge({}, false).need, TetNeed::Nothing);
}

TEST(RefinementCriteria3d, PutsTheLargerOnesFirst)
{
    EXPECT_GT(OneTet(kRegular, 0.1).judge().key, OneTet(kRegular, 0.4).judge().key);
}

TEST(RefinementCriteria3d, CallsSmallAndLargeDihedralAnglesBad)
{
    const auto flattened = [](double height) {
        return std::array<Vec3, 4>{{{1, 0, height}, {-1, 0, height}, {0, 1, -height}, {0, -1, -height}}};
    };
    // The angle at the two long edges is 2 atan(1 / (2 h)): 155 degrees at h = 0.1108.
    const double limit = 0.5 / std::tan(155.0 / 2.0 * std::acos(-1.0) / 180.0);
    OneTet below(flattened(0.99 * limit), 0.01);
    OneTet above(flattened(1.01 * limit), 0.01);
    TetQualityLimits limits;
    limits.measure = TetMeasure::ShortestEdgeToCircumradius;  // does not see slivers
    EXPECT_EQ(below.judge(limits, false).need, TetNeed::Nothing);
    limits.largestDihedral = 155.0;
    EXPECT_EQ(below.judge(limits, false).need, TetNeed::Quality);
    EXPECT_EQ(above.judge(limits, false).need, TetNeed::Nothing);
    limits.largestDihedral = 180.0;
    EXPECT_EQ(below.judge(limits, false).need, TetNeed::Nothing);
    limits.isActive = false;
    limits.measure = TetMeasure::MinimumDihedralSine;
    EXPECT_EQ(below.judge(limits, false).need, TetNeed::Nothing);
}

TEST(RefinementCriteria3d, AgreesWithTheMeasuresOnRandomTetrahedra)
{
    Random random(5);
    for (int i = 0; i < 2000; ++i) {
        std::array<Vec3, 4> corner;
        for (Vec3& p : corner) p = {random.unit(), random.unit(), random.unit()};
        for (const TetMeasureInfo& info : kTetMeasures) {
            TetQualityLimits limits;
            limits.measure = info.measure;
            OneTet one(corner, 1e-3);
            const auto& v = one.t.mesh().tet(one.tet).vertex;
            const TetCorners oriented{one.t.mesh().position(v[0]), one.t.mesh().position(v[1]),
                                      one.t.mesh().position(v[2]), one.t.mesh().position(v[3])};
            LengthScale3d scale(one.t, {});
            scale.setInitial();
            const auto angles = dihedralAngles(oriented);
            const double largest = *std::max_element(angles.begin(), angles.end());
            const bool isBad = score(info.measure, oriented) < info.threshold ||
                               largest > info.largestDihedral ||
                               score(TetMeasure::VolumeLength, oriented) < info.leastVolumeLength;
            ASSERT_EQ(RefinementCriteria3d(one.t.mesh(), scale, limits).isBad(one.tet), isBad) << info.key;
        }
        if (i >= 200) i += 10;
    }
}

TEST(RefinementCriteria3d, TellsSinks)
{
    OneTet regular(kRegular, 1.0);
    LengthScale3d scale(regular.t, {});
    EXPECT_TRUE(RefinementCriteria3d(regular.t.mesh(), scale, {}).isSink(regular.tet));
    OneTet corner({{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}}, 1.0);
    LengthScale3d other(corner.t, {});
    const RefinementCriteria3d criteria(corner.t.mesh(), other, {});
    EXPECT_FALSE(criteria.isSink(corner.tet));
    const auto centre = criteria.circumcentre(corner.tet);
    ASSERT_TRUE(centre.has_value());
    EXPECT_NEAR(length(*centre - Vec3{0.5, 0.5, 0.5}), 0.0, 1e-15);
}

TEST(RefinementCriteria3d, StopsAFifthBelowTheLengthScale)
{
    OneTet one({{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}}, 1.0);
    LengthScale3d scale(one.t, {});
    scale.setInitial();  // as no facet is near, the shortest edge: 1
    const RefinementCriteria3d criteria(one.t.mesh(), scale, {});
    const VertexId a(0u);
    // mean LS < 2 lambda length: 1 < 10, and at a scale of 10.01 no more.
    EXPECT_TRUE(criteria.maySplit(a, VertexId(1u)));
    EXPECT_TRUE(criteria.maySplit({a, VertexId(1u), VertexId(2u)}));
}

}  // namespace
}  // namespace mesher::test
