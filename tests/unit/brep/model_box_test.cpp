#include "brep/model_box.h"

#include "brep/analytic/axes.h"
#include "brep/analytic/solids.h"

#include <gtest/gtest.h>

#include <cmath>
#include <memory>

namespace mesher {
namespace {

/// A frame along no axis.
Axes tilted()
{
    const Vec3 x = (1.0 / std::sqrt(14.0)) * Vec3{1.0, 2.0, 3.0};
    const Vec3 y = (1.0 / std::sqrt(5.0)) * Vec3{-2.0, 1.0, 0.0};
    return {{5.0, -7.0, 11.0}, x, y, cross(x, y)};
}

void expectSame(const Box3& found, const Box3& exact)
{
    constexpr double kRounding = 1e-13;
    EXPECT_LT(length(found.low - exact.low), kRounding);
    EXPECT_LT(length(found.high - exact.high), kRounding);
}

TEST(ModelBox, IsThatOfSolidsWhoseBoxIsKnownInClosedForm)
{
    for (const Axes& axes : {tilted(), Axes{{}, {0.0, 1.0, 0.0}, {0.0, 0.0, 1.0}, {1.0, 0.0, 0.0}}}) {
        for (const Result<BrepModel>& model : {makeCylinder(axes, 2.0, 5.0), makeCone(axes, 2.0, 0.5, 3.0),
                                               makeSphere(axes, 1.5), makeTorus(axes, 4.0, 1.0)}) {
            ASSERT_TRUE(model);
            expectSame(boxOf(model.value()), model->box);
        }
    }
    expectSame(boxOf(makeBox({1.0, 2.0, 3.0}, {4.0, 6.0, 8.0}).value()), {{1.0, 2.0, 3.0}, {4.0, 6.0, 8.0}});
}

/// Takes nothing but one half of a sphere's parameters.
class Half final : public TrimClassifier
{
public:
    [[nodiscard]] TrimSide classify(Vec2 uv) const override
    {
        return uv.y > 0.0 ? TrimSide::Inside : TrimSide::Outside;
    }
    [[nodiscard]] std::unique_ptr<TrimClassifier> clone() const override { return std::make_unique<Half>(); }
};

TEST(ModelBox, LeavesOutWhatIsTrimmedOff)
{
    BrepModel model = makeSphere(tilted(), 1.5).value();
    const Vec3 lowest = model.box.low;
    model.edges = {};
    model.vertices = {};
    model.vertices.push_back({tilted().origin, 0.0});
    model.faces[BrepFaceId(0)].trim = std::make_shared<Half>();
    const Box3 box = boxOf(model);
    // The half is that towards the frame's z, which points to smaller x and y and to greater z.
    EXPECT_NEAR(box.low.x, lowest.x, 1e-13);
    EXPECT_NEAR(box.low.y, lowest.y, 1e-13);
    EXPECT_GT(box.low.z, lowest.z + 0.5);
    EXPECT_NEAR(box.high.z, tilted().origin.z + 1.5, 1e-13);
}

}  // namespace
}  // namespace mesher
