#include "base/run_context.h"

#include <gtest/gtest.h>

#include <string>
#include <utility>
#include <vector>

namespace mesher {
namespace {

TEST(RunContext, DoesNothingByDefault)
{
    RunContext context;
    EXPECT_FALSE(context.isCancelled());
    EXPECT_TRUE(context.reportProgress("stage", 0.5));
    context.log(LogLevel::Warning, "nobody listens");
    EXPECT_EQ(context.checkLevel(), CheckLevel::Off);
    EXPECT_EQ(context.threads(), 1u);
}

TEST(RunContext, HandsOutWhatTheCallerChose)
{
    RunSettings settings;
    settings.seed = 42;
    settings.checkLevel = CheckLevel::Full;
    settings.threads = 3;
    const RunContext context(settings);
    EXPECT_EQ(context.seed(), 42u);
    EXPECT_EQ(context.checkLevel(), CheckLevel::Full);
    EXPECT_EQ(context.threads(), 3u);
}

TEST(RunContext, PassesMessagesToTheLogHook)
{
    std::vector<std::pair<LogLevel, std::string>> messages;
    RunSettings settings;
    settings.log = [&messages](LogLevel level, std::string_view message) {
        messages.emplace_back(level, message);
    };
    const RunContext context(settings);
    context.log(LogLevel::Info, "begun");
    ASSERT_EQ(messages.size(), 1u);
    EXPECT_EQ(messages[0], std::make_pair(LogLevel::Info, std::string("begun")));
}

TEST(RunContext, IsCancelledByTheProgressHook)
{
    int calls = 0;
    RunSettings settings;
    settings.progress = [&calls](std::string_view, double fraction) {
        ++calls;
        return fraction < 0.5;
    };
    RunContext context(settings);
    EXPECT_TRUE(context.reportProgress("stage", 0.25));
    EXPECT_FALSE(context.reportProgress("stage", 0.5));
    EXPECT_TRUE(context.isCancelled());
    EXPECT_FALSE(context.reportProgress("stage", 0.0));
    EXPECT_EQ(calls, 2);
}

struct RecordedProgress
{
    std::vector<double> fractions;
    RunSettings settings;

    RecordedProgress()
    {
        settings.progress = [this](std::string_view stage, double fraction) {
            EXPECT_EQ(stage, "insertion");
            fractions.push_back(fraction);
            return true;
        };
    }
};

TEST(StageProgress, ReportsEachHundredthAndTheEndOnce)
{
    RecordedProgress recorded;
    RunContext context(recorded.settings);
    StageProgress progress(context, "insertion", 100'000);
    for (int i = 0; i < 100'000; ++i) ASSERT_TRUE(progress.advance());
    EXPECT_TRUE(progress.finish());
    EXPECT_TRUE(progress.finish());
    ASSERT_EQ(recorded.fractions.size(), 100u);
    EXPECT_DOUBLE_EQ(recorded.fractions.front(), 0.01);
    EXPECT_DOUBLE_EQ(recorded.fractions.back(), 1.0);
    for (std::size_t i = 1; i < recorded.fractions.size(); ++i) {
        EXPECT_LT(recorded.fractions[i - 1], recorded.fractions[i]);
    }
}

TEST(StageProgress, StaysWithinOneForMoreStepsThanAnnounced)
{
    RecordedProgress recorded;
    RunContext context(recorded.settings);
    StageProgress progress(context, "insertion", 3);
    for (int i = 0; i < 10; ++i) ASSERT_TRUE(progress.advance());
    progress.finish();
    for (const double fraction : recorded.fractions) EXPECT_LE(fraction, 1.0);
    EXPECT_DOUBLE_EQ(recorded.fractions.back(), 1.0);
}

TEST(StageProgress, OfNoStepsIsCompleteAtOnce)
{
    RecordedProgress recorded;
    RunContext context(recorded.settings);
    StageProgress progress(context, "insertion", 0);
    progress.finish();
    EXPECT_EQ(recorded.fractions, std::vector<double>{1.0});
}

TEST(StageProgress, TellsOfCancellationBetweenReports)
{
    RunContext context;
    StageProgress progress(context, "insertion", 1'000'000);
    EXPECT_TRUE(progress.advance());
    context.requestCancel();
    EXPECT_FALSE(progress.advance());
}

}  // namespace
}  // namespace mesher
