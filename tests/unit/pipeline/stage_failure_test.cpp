#include "pipeline/stage_failure.h"

#include "brep/analytic/solids.h"
#include "brep/geometry_failure.h"
#include "pipeline/estimate_model.h"
#include "pipeline/mesh_model.h"

#include <gtest/gtest.h>

#include <atomic>
#include <memory>
#include <new>
#include <set>
#include <stdexcept>
#include <string>
#include <utility>

namespace mesher::test {
namespace {

/// A surface that answers some questions and fails at all further ones.
class TiringSurface final : public Surface
{
public:
    TiringSurface(std::shared_ptr<const Surface> surface, std::shared_ptr<std::atomic<int>> answersLeft)
        : surface_(std::move(surface)), answersLeft_(std::move(answersLeft))
    {
    }

    SurfaceKind kind() const override { return surface_->kind(); }
    Interval rangeU() const override { return surface_->rangeU(); }
    Interval rangeV() const override { return surface_->rangeV(); }
    double periodU() const override { return surface_->periodU(); }
    double periodV() const override { return surface_->periodV(); }
    Vec3 position(Vec2 uv) const override { return answer(), surface_->position(uv); }
    SurfacePoint evaluate(Vec2 uv) const override { return answer(), surface_->evaluate(uv); }
    SurfaceProjection project(const Vec3& point, std::optional<Vec2> seed) const override
    {
        return answer(), surface_->project(point, seed);
    }
    std::unique_ptr<Surface> clone() const override
    {
        return std::make_unique<TiringSurface>(surface_->clone(), answersLeft_);
    }

private:
    void answer() const
    {
        if (--*answersLeft_ < 0) throw GeometryFailure("Face1", "the kernel gave up");
    }

    std::shared_ptr<const Surface> surface_;
    std::shared_ptr<std::atomic<int>> answersLeft_;
};

struct TiringModel
{
    BrepModel model = *makeCylinder({}, 1.0, 2.0);
    std::shared_ptr<std::atomic<int>> answersLeft;

    explicit TiringModel(int answers) : answersLeft(std::make_shared<std::atomic<int>>(answers))
    {
        BrepFace& wall = model.faces[BrepFaceId(0)];
        wall.surface = std::make_shared<TiringSurface>(wall.surface, answersLeft);
    }
};

template <class Thrown>
Error errorOf(const Thrown& thrown, const std::string& stage)
{
    try {
        throw thrown;
    } catch (...) {
        return errorInFlight(stage);
    }
}

MeshOptions coarse()
{
    MeshOptions options;
    options.size = 0.4;
    return options;
}

TEST(StageFailure, NamesEntityStageAndRemedy)
{
    const Error geometry = errorOf(GeometryFailure("Face7", "the kernel gave up"), "surfaces");
    EXPECT_EQ(geometry.entity, "Face7");
    EXPECT_NE(geometry.message.find("in the stage 'surfaces'"), std::string::npos);
    EXPECT_NE(errorOf(std::bad_alloc(), "refinement").message.find("memory"), std::string::npos);
    EXPECT_NE(errorOf(std::runtime_error("why"), "").message.find("why"), std::string::npos);
    EXPECT_FALSE(errorOf(17, "").remedy.empty());
}

TEST(StageFailure, ASurfaceThatFailsEndsTheRunByNameWheneverItDoes)
{
    constexpr int kMany = 1 << 30;
    const TiringModel tireless(kMany);
    RunContext whole;
    ASSERT_EQ(meshModel(tireless.model, coarse(), nullptr, 2, whole).report.status, MeshReport::Status::Done);
    const int asked = kMany - *tireless.answersLeft;
    std::set<std::string> messages;
    for (int missing = 1; missing < asked; missing *= 2) {
        SCOPED_TRACE(missing);
        RunContext context;
        const MeshOutcome outcome =
            meshModel(TiringModel(asked - missing).model, coarse(), nullptr, 2, context);
        ASSERT_EQ(outcome.report.failures.size(), 1u);
        EXPECT_EQ(outcome.report.failures.front().entity, "Face1");
        messages.insert(outcome.report.failures.front().message);
    }
    EXPECT_GE(messages.size(), 3u);  // each names a stage
}

TEST(StageFailure, ASurfaceThatFailsEndsTheEstimateByName)
{
    RunContext context;
    const Result<MeshEstimate> estimate = estimateModel(TiringModel(3).model, coarse(), nullptr, context);
    ASSERT_FALSE(estimate);
    EXPECT_EQ(estimate.error().entity, "Face1");
}

}  // namespace
}  // namespace mesher::test
