// Meshes random solids, each in a process of its own under limits on time and memory, and judges each by the library's
// checks and the kernel's measures. Options: see kUsage. Solid I of seed S depends on nothing else. A solid ends as
//   valid     a mesh without fault
//   refused   no mesh, and an error that names entity, reason and remedy
//   skipped   the kernel could not make it, or says itself that it is not valid
//   failed    anything else: a wrong mesh, a crash, a limit, an error without a name
// A failed one is tried again without each of its steps, and what is left is kept as a file: `--from I --solids 1 --steps MASK`
// repeats it. Ends with 1 if one failed.

#include "random_solids.h"

#include "base/random.h"
#include "base/run_context.h"
#include "brep/occt/read_model.h"
#include "limited_process.h"
#include "pipeline/mesh_model.h"
#include "solid_verdict.h"
#include "support/test_effort.h"

#include <BRepCheck_Analyzer.hxx>
#include <BRepTools.hxx>

#include <array>
#include <chrono>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <map>
#include <optional>
#include <set>
#include <sstream>
#include <string>
#include <string_view>
#include <unistd.h>

namespace mesher::test {
namespace {

constexpr std::uint64_t kKernelSeconds = 10;

constexpr const char* kUsage =
    "solid_fuzz [--solids N (50 x MESHER_TEST_EFFORT)] [--seed S] [--from I] [--steps MASK] [--cpu SECONDS] "
    "[--memory MEGABYTES]\n"
    "           [--finest N]     sizes are drawn from a 6th to an Nth of the diagonal. DEFAULT: 15\n"
    "           [--wide 0|1]     also uneven fillets and chamfers, solids side by side, places far away. "
    "DEFAULT: 0\n"
    "           [--resume FILE]  lines of solids that are done: those are not meshed again\n"
    "           [--keep FOLDER]  where models that fail are kept\n"
    "           [--refused 0|1]  whether refusals count as failures. DEFAULT: 0\n"
    "           [--verbose 0|1]  a line for every solid\n";

struct Options
{
    std::uint64_t solids = static_cast<std::uint64_t>(repetitions(50));
    std::uint64_t seed = 1;
    std::uint64_t from = 0;
    std::uint32_t steps = ~0u;
    std::uint64_t cpuSeconds = 60;  ///< of meshing, and of judging
    std::uint64_t memoryMegabytes = 4096;
    std::uint64_t finest = 15;
    std::filesystem::path resume;
    std::filesystem::path keep;
    bool isWide = false;
    bool isRefusalFailure = false;
    bool isVerbose = false;
};

std::optional<Options> parseOptions(int count, char** words)
{
    Options options;
    if (count % 2 == 0) return std::nullopt;
    for (int i = 1; i + 1 < count; i += 2) {
        const std::string_view name = words[i];
        const std::uint64_t value = std::strtoull(words[i + 1], nullptr, 0);
        if (name == "--solids")
            options.solids = value;
        else if (name == "--seed")
            options.seed = value;
        else if (name == "--from")
            options.from = value;
        else if (name == "--steps")
            options.steps = static_cast<std::uint32_t>(value);
        else if (name == "--cpu")
            options.cpuSeconds = value;
        else if (name == "--memory")
            options.memoryMegabytes = value;
        else if (name == "--finest")
            options.finest = value;
        else if (name == "--resume")
            options.resume = words[i + 1];
        else if (name == "--keep")
            options.keep = words[i + 1];
        else if (name == "--wide")
            options.isWide = value != 0;
        else if (name == "--refused")
            options.isRefusalFailure = value != 0;
        else if (name == "--verbose")
            options.isVerbose = value != 0;
        else
            return std::nullopt;
    }
    return options;
}

/// What became of a solid.
struct Outcome
{
    std::string verdict;
    std::string recipe;
    std::string text;
    std::uint32_t steps = 0;
    double seconds = 0.0;
};

MeshOptions drawMeshOptions(std::uint64_t seed, const Box3& box, double finest)
{
    Random random(seed ^ 0x5DEECE66Du);
    MeshOptions options;
    options.size = length(box.extent()) / random.between(6.0, finest);
    options.curvature = std::array{0.0, 12.0, 12.0, 20.0}[random.below(4)];
    if (random.below(6) == 0) options.localSizes.push_back({"Face1", 0.3 * *options.size});
    options.maxElements = 2'000'000;
    return options;
}

/// A second run on two threads gives the same mesh, or what is wrong.
std::optional<std::string> changeByThreads(const BrepModel& model, MeshOptions options, std::uint64_t hash)
{
    options.threads = 2;
    RunSettings settings;
    settings.threads = 2;
    RunContext context(settings);
    const MeshOutcome again = meshModel(model, options, nullptr, 2, context);
    if (again.report.meshHash == hash) return std::nullopt;
    return "two threads give another mesh";
}

/// One solid, in its process.
class Trial
{
public:
    Trial(std::uint64_t seed, const Options& options, const EnterPhase& enter)
        : seed_(seed), options_(options), enter_(enter)
    {
    }

    std::string run(std::uint32_t mask, const std::filesystem::path& file)
    {
        enter_("kernel", kKernelSeconds);
        solid_ = randomSolid(seed_, mask, options_.isWide);
        if (solid_.shape.IsNull() || !BRepCheck_Analyzer(solid_.shape).IsValid())
            return answer("skipped", "the kernel says that it is not valid");
        if (!BRepTools::Write(solid_.shape, file.c_str())) return answer("failed", "no place for the model");
        enter("reading ");
        // Of the file, so that the file alone repeats the run: its text has fewer digits than the shape in memory.
        const Result<ReadModel> read = readModel(file);
        if (!read) return answer(judgeError(read.error()));
        return answer(meshAndJudge(read.value().model, *read.value().shape));
    }

private:
    void enter(const std::string& phase) const { enter_(phase + solid_.recipe, options_.cpuSeconds); }

    SolidVerdict meshAndJudge(const BrepModel& model, const TopoDS_Shape& shape) const
    {
        const MeshOptions options = drawMeshOptions(seed_, model.box, static_cast<double>(options_.finest));
        enter("meshing ");
        RunContext context;
        const MeshOutcome outcome = meshModel(model, options, nullptr, 2, context);
        enter("judging ");
        SolidVerdict verdict = judge(model, shape, outcome);
        if (verdict.kind == SolidVerdict::Kind::Valid && seed_ % 8 == 0) {
            enter("two threads ");
            if (const auto change = changeByThreads(model, options, outcome.report.meshHash))
                verdict = {SolidVerdict::Kind::Failed, *change};
        }
        std::ostringstream text;
        text << verdict.text << ", size " << *options.size << " curvature " << options.curvature;
        if (!options.localSizes.empty()) text << " Face1=" << options.localSizes.front().size;
        verdict.text = text.str();
        return verdict;
    }

    /// Verdict, number of steps, recipe and text in lines.
    [[nodiscard]] std::string answer(const std::string& verdict, const std::string& text) const
    {
        return verdict + '\n' + std::to_string(solid_.steps) + '\n' + solid_.recipe + '\n' + text;
    }
    [[nodiscard]] std::string answer(const SolidVerdict& verdict) const
    {
        constexpr std::array kNames = {"valid", "refused", "failed"};
        return answer(kNames[static_cast<std::size_t>(verdict.kind)], verdict.text);
    }

    std::uint64_t seed_;
    const Options& options_;
    const EnterPhase& enter_;
    RandomSolid solid_;
};

Outcome outcomeOf(const ProcessEnd& end)
{
    Outcome outcome;
    if (end.kind == ProcessEnd::Kind::Answered) {
        std::istringstream lines(end.text);
        std::string steps;
        std::getline(lines, outcome.verdict);
        std::getline(lines, steps);
        std::getline(lines, outcome.recipe);
        std::getline(lines, outcome.text);
        outcome.steps = static_cast<std::uint32_t>(std::strtoul(steps.c_str(), nullptr, 10));
        return outcome;
    }
    // The kernel's own crashes and hangs on the way to a solid are not the mesher's.
    outcome.verdict = end.phase == "kernel" ? "skipped" : "failed";
    outcome.recipe = end.phase;
    outcome.steps = 32;
    outcome.text = end.kind == ProcessEnd::Kind::RanOutOfTime     ? "time limit of the process"
                   : end.kind == ProcessEnd::Kind::RanOutOfMemory ? "memory limit of the process"
                                                                  : "crash: " + end.text;
    return outcome;
}

/// Solids of one seed, one after the other.
class FuzzRun
{
public:
    explicit FuzzRun(const Options& options) : options_(options)
    {
        readDone();
        const std::filesystem::path folder =
            options.keep.empty() ? std::filesystem::temp_directory_path() : options.keep;
        std::filesystem::create_directories(folder);
        file_ = folder / ("solid_fuzz_" + std::to_string(getpid()) + ".brep");
    }
    ~FuzzRun() { std::filesystem::remove(file_); }
    FuzzRun(const FuzzRun&) = delete;
    FuzzRun& operator=(const FuzzRun&) = delete;

    int run()
    {
        for (std::uint64_t i = options_.from; i < options_.from + options_.solids; ++i) {
            const auto known = done_.find({options_.seed, i});
            if (known != done_.end()) {
                ++tally_[known->second];
                continue;
            }
            const auto start = std::chrono::steady_clock::now();
            Outcome outcome = tryOnce(i, options_.steps);
            outcome.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
            if (outcome.verdict == "refused" && options_.isRefusalFailure) outcome.verdict = "failed";
            ++tally_[outcome.verdict];
            tell(i, outcome);
            if (outcome.verdict == "failed") keep(i, outcome);
        }
        for (const auto& [verdict, count] : tally_) std::cout << count << ' ' << verdict << ", ";
        std::cout << "seed " << options_.seed << ", solids " << options_.from << " to "
                  << options_.from + options_.solids - 1 << std::endl;
        return tally_["failed"] == 0 ? 0 : 1;
    }

private:
    [[nodiscard]] Outcome tryOnce(std::uint64_t index, std::uint32_t mask) const
    {
        const std::uint64_t seed = options_.seed * 0x9E3779B97F4A7C15u + index;
        const auto work = [&](const EnterPhase& enter) {
            return Trial(seed, options_, enter).run(mask, file_);
        };
        return outcomeOf(runLimited(work, options_.memoryMegabytes));
    }

    void readDone()
    {
        std::ifstream file(options_.resume);
        std::uint64_t seed = 0, index = 0;
        std::string verdict, rest;
        while (file >> seed >> index >> verdict && std::getline(file, rest)) done_[{seed, index}] = verdict;
    }

    void tell(std::uint64_t index, const Outcome& outcome)
    {
        std::ostringstream line;
        line << options_.seed << ' ' << index << ' ' << outcome.verdict << " [" << outcome.recipe << "] "
             << outcome.text << " (" << outcome.seconds << " s)";
        if (options_.isVerbose || outcome.verdict == "failed") std::cout << line.str() << std::endl;
        if (!options_.resume.empty())
            std::ofstream(options_.resume, std::ios::app) << line.str() << std::endl;
    }

    /// Leaves out every step that the failure does not need, and keeps the model that is left.
    void keep(std::uint64_t index, const Outcome& first)
    {
        if (options_.keep.empty()) return;
        std::uint32_t mask = options_.steps & ((first.steps >= 32 ? 0u : 1u << first.steps) - 1u);
        for (std::uint32_t i = 0; i < 5; ++i) {
            const std::uint32_t less = mask & ~(1u << i);
            if (less != mask && tryOnce(index, less).verdict == "failed") mask = less;
        }
        const Outcome last = tryOnce(index, mask);
        const std::string name = "seed" + std::to_string(options_.seed) + "_solid" + std::to_string(index);
        std::error_code problem;
        std::filesystem::rename(file_, options_.keep / (name + ".brep"), problem);
        std::cout << "    --seed " << options_.seed << " --from " << index << " --solids 1 --steps " << mask
                  << ": [" << last.recipe << "] " << last.text << std::endl;
    }

    const Options& options_;
    std::filesystem::path file_;
    std::map<std::pair<std::uint64_t, std::uint64_t>, std::string> done_;
    std::map<std::string, std::uint64_t> tally_;
};

}  // namespace
}  // namespace mesher::test

int main(int count, char** words)
{
    const auto options = mesher::test::parseOptions(count, words);
    if (!options) {
        std::cerr << mesher::test::kUsage;
        return 2;
    }
    return mesher::test::FuzzRun(*options).run();
}
