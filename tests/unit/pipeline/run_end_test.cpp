#include "brep/analytic/axes.h"
#include "brep/analytic/solids.h"
#include "pipeline/mesh_model.h"
#include "support/model_union.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <string_view>

namespace mesher::test {
namespace {

/// Two solids that touch, so that each stage has something to do.
BrepModel postOnABlock()
{
    Axes above;
    above.origin = {0.0, 0.0, 1.0};
    return together(*makeBox({-2.0, -2.0, 0.0}, {2.0, 2.0, 1.0}), *makeCylinder(above, 1.0, 1.0));
}

/// Small, and with a part of each stage.
MeshOptions allStages()
{
    MeshOptions options;
    options.size = 0.8;
    options.curvature = 10.0;
    options.refinement = 1.0;
    options.distanceSizes = {{"Face6", 0.5, 1.0, 0.0}};
    options.isChecked = true;
    return options;
}

/// A run that is cancelled when it has asked so often.
struct CountedRun
{
    std::size_t asked = 0;
    std::size_t askedAfterwards = 0;
    MeshOutcome outcome;

    CountedRun(const BrepModel& model, const MeshOptions& options, std::size_t end)
    {
        RunSettings settings;
        settings.poll = [this, end] {
            ++asked;
            return asked < end;
        };
        settings.progress = [this, end](std::string_view, double) {
            askedAfterwards += asked >= end ? 1 : 0;
            return true;
        };
        RunContext context(settings);
        outcome = meshModel(model, options, nullptr, 2, context);
    }
};

constexpr std::size_t kNever = std::size_t{1} << 40;

constexpr std::array kStages = {"estimate",       "features",           "surfaces",
                                "contacts",       "tetrahedralization", "refinement",
                                "classification", "improvement",        "measures"};

/// The stage in which a run ends that is cancelled at that question.
std::size_t stageOfEnd(const BrepModel& model, const MeshOptions& options, std::size_t end)
{
    const CountedRun run(model, options, end);
    const MeshReport& report = run.outcome.report;
    EXPECT_EQ(report.status, MeshReport::Status::Cancelled) << end;
    EXPECT_EQ(report.stopReason, StopReason::Cancelled) << end;
    EXPECT_FALSE(run.outcome.mesh) << end;
    EXPECT_EQ(run.asked, end) << "the hook is not asked again";
    EXPECT_EQ(run.askedAfterwards, 0u) << end;
    std::size_t last = 0;
    for (const auto& [name, seconds] : report.seconds) {
        for (std::size_t i = 0; i < kStages.size(); ++i) last = name == kStages[i] ? std::max(last, i) : last;
    }
    return last;
}

TEST(RunEnd, IsHeardInEachStage)
{
    const BrepModel model = postOnABlock();
    const MeshOptions options = allStages();
    const CountedRun whole(model, options, kNever);
    ASSERT_TRUE(whole.outcome.mesh) << describe(whole.outcome.report.failures.front());
    // The later it is cancelled the later the stage in which it ends, so that the first question of a stage is found by halving.
    for (std::size_t stage = 0; stage < kStages.size(); ++stage) {
        std::size_t before = 0, first = whole.asked;
        while (before + 1 < first) {
            const std::size_t middle = (before + first) / 2;
            (stageOfEnd(model, options, middle) < stage ? before : first) = middle;
        }
        EXPECT_EQ(stageOfEnd(model, options, first), stage) << kStages[stage] << " does not ask";
    }
}

TEST(RunEnd, ByTimeKeepsWhatThereIsForThoseWhoWantItOnly)
{
    for (const bool isWanted : {true, false}) {
        RunSettings settings;
        settings.keepsPartial = isWanted;
        RunContext* running = nullptr;
        settings.progress = [&](std::string_view stage, double) {
            if (stage == "refinement") running->limitTime(0.0);
            return true;
        };
        RunContext context(settings);
        running = &context;
        const MeshOutcome outcome = meshModel(postOnABlock(), allStages(), nullptr, 2, context);
        EXPECT_EQ(outcome.report.status, MeshReport::Status::Failed);
        EXPECT_EQ(outcome.report.stopReason, StopReason::TimeLimit);
        EXPECT_EQ(outcome.mesh.has_value(), isWanted);
    }
}

}  // namespace
}  // namespace mesher::test
