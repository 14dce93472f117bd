#include "base/assert.h"
#include "cli/commands.h"
#include "cli/interrupt.h"
#include "cli/model_file.h"
#include "cli/progress_line.h"
#include "cli/supervisor.h"
#include "cli/wishes.h"
#include "io/mesh_writer.h"
#include "io/read_size_fields.h"
#include "io/write_curved_boundary.h"
#include "io/write_text_file.h"
#include "pipeline/mesh_model.h"
#include "pipeline/report_steps.h"
#include "pipeline/stage_failure.h"
#include "pipeline/stage_watch.h"

#include <algorithm>
#include <iomanip>
#include <optional>

namespace mesher {

namespace {

/// A run of `mesher mesh`: each step returns whether the next one may follow.
class MeshRun
{
public:
    MeshRun(const MeshCommand& command, Console console)
        : command_(command),
          console_(console),
          progress_(console.err, console.hasProgress),
          context_(settings()),
          interrupt_(context_)
    {
        context_.limitTime(command.options.timeout);
        report_.options = command.options;
        report_.modelFile = command.model.string();
        report_.versions = {{"mesher", MESHER_VERSION}};
    }

    ExitStatus run()
    {
        if (const std::optional<ExitStatus> refused = probeTargets()) return *refused;
        noteTimeLimit(command_.options.timeout);
        if (command_.report) interrupt_.leaveBehind(*command_.report, reportOfCancelled());
        const bool isDone = work();
        interrupt_.enter(InterruptScope::Phase::Ending);
        progress_.clear();
        finishStatus();
        writeReport();
        if (isDone) summarise();
        for (const Error& failure : report_.failures)
            tell(inModel(failure, command_.model), ExitStatus::Failed, console_);
        return status_;
    }

private:
    RunSettings settings()
    {
        RunSettings settings;
        settings.threads = command_.options.threads;
        settings.stage = noteStage;
        settings.keepsPartial = command_.keepsPartial;
        settings.progress = [this](std::string_view stage, double fraction) {
            progress_.show(stage, fraction);
            return true;
        };
        return settings;
    }

    /// What ends a run where nobody could return an error is told like others; it may be that memory does not suffice.
    bool work()
    {
        try {
            return readSizes() && readGeometry() && canBeWritten() && mesh() && writeOutputs();
        } catch (...) {
            mesh_.reset();
            boundary_.reset();
            model_ = {};
            fail(errorInFlight(context_.stage()));
            return false;
        }
    }

    std::string reportOfCancelled() const
    {
        MeshReport report = report_;
        report.status = MeshReport::Status::Cancelled;
        report.stopReason = StopReason::Cancelled;
        return toJson(report);
    }

    void fail(Error error)
    {
        if (error.entity.empty()) error.entity = "model";
        report_.status = MeshReport::Status::Failed;
        report_.failures.push_back(std::move(error));
    }
    bool failIf(const Result<void>& result)
    {
        if (!result) fail(result.error());
        return !result;
    }

    /// Before anything takes time: formats that are not known are wrong usage, places that cannot be written failures.
    std::optional<ExitStatus> probeTargets()
    {
        for (const OutputTarget& output : command_.outputs) {
            const Result<const MeshFormat*> format = findFormat(output.path, output.format);
            if (!format) return tell(format.error(), ExitStatus::Usage, console_);
        }
        std::vector<std::filesystem::path> targets;
        for (const OutputTarget& output : command_.outputs) targets.push_back(output.path);
        if (command_.report) targets.push_back(*command_.report);
        if (command_.curvedBoundary) targets.push_back(*command_.curvedBoundary);
        for (const std::filesystem::path& target : targets) {
            const Result<void> possible = AtomicFile::probe(target);
            if (!possible) return tell(possible.error(), ExitStatus::Failed, console_);
        }
        return std::nullopt;
    }

    bool readGeometry()
    {
        progress_.show("reading the model", 0.0);
        interrupt_.enter(InterruptScope::Phase::Immediate);
        const StageWatch watch;
        Result<ReadModel> read = readModelFile(command_.model, command_.heals, "sizes");
        interrupt_.enter(InterruptScope::Phase::Cooperative);
        watch.addTo(report_, "reading");
        if (!read) {
            fail(read.error());
            return false;
        }
        // What there is when the time is over may take a while to be put together.
        if (command_.keepsPartial) noteTimeLimit({});
        model_ = std::move(read).value().model;
        report_.unit = model_.unit;
        return true;
    }

    bool readSizes()
    {
        Result<std::shared_ptr<const SizingField>> sizes = readSizeFields(
            command_.options.background, command_.options.sizePoints, command_.options.grading);
        if (!sizes) {
            fail(sizes.error());
            return false;
        }
        fileSizes_ = std::move(sizes).value();
        return true;
    }

    bool mesh()
    {
        MeshOutcome outcome =
            meshModel(model_, command_.options, fileSizes_, command_.boundaryOrder, context_);
        takeReport(std::move(outcome.report));
        mesh_ = std::move(outcome.mesh);
        boundary_ = std::move(outcome.curvedBoundary);
        if (mesh_) mesh_->title = command_.model.filename().string();
        const bool isWhole = report_.status == MeshReport::Status::Done;
        const bool isPartial = report_.status == MeshReport::Status::Failed;
        return mesh_.has_value() && (isWhole || (isPartial && command_.keepsPartial));
    }

    /// What the program knows beside the mesher's own report.
    void takeReport(MeshReport report)
    {
        report.modelFile = std::move(report_.modelFile);
        report.seconds.insert(report.seconds.begin(), report_.seconds.begin(), report_.seconds.end());
        report.cpuSeconds.insert(report.cpuSeconds.begin(), report_.cpuSeconds.begin(),
                                 report_.cpuSeconds.end());
        report_ = std::move(report);
    }

    bool canBeWritten() { return !failIf(checkWishes(command_, model_)); }

    /// All files or none: they appear when each has been written as a whole.
    bool writeOutputs()
    {
        noteTimeLimit({});
        const StageWatch watch;
        // What is wanted although the time is over is written without a limit.
        const TimeLimitPause pause(context_, report_.stopReason == StopReason::TimeLimit);
        std::vector<AtomicFile> files;
        for (const OutputTarget& output : command_.outputs) {
            if (!context_.reportProgress("writing", 0.0)) return stopped();
            if (!keep(prepareMesh(*mesh_, output.path, output.format, command_.writing,
                                  [this] { return context_.mayGoOn(); }),
                      files))
                return false;
        }
        MESHER_INVARIANT(!command_.curvedBoundary || boundary_);
        if (command_.curvedBoundary &&
            !keep(prepareCurvedBoundary(*boundary_, *command_.curvedBoundary), files))
            return false;
        if (!context_.reportProgress("writing", 1.0)) return stopped();
        // From here on a signal comes too late; a pipe that is not read must still be left.
        const bool isDirect =
            std::any_of(files.begin(), files.end(), [](const auto& f) { return f.isDirect(); });
        if (!isDirect) interrupt_.enter(InterruptScope::Phase::Ending);
        if (failIf(publishAll(files))) return false;
        arePublished_ = true;
        watch.addTo(report_, "writing");
        return true;
    }

    bool keep(Result<AtomicFile> file, std::vector<AtomicFile>& files)
    {
        if (!context_.mayGoOn()) return stopped();
        if (!file) {
            fail(file.error());
            return false;
        }
        files.push_back(std::move(file).value());
        return true;
    }

    bool stopped()
    {
        if (context_.isCancelled()) return cancelled();
        tellStop(StopReason::TimeLimit, report_);
        return false;
    }

    bool cancelled()
    {
        report_.status = MeshReport::Status::Cancelled;
        report_.stopReason = StopReason::Cancelled;
        return false;
    }

    /// A signal that comes when the files are there changes nothing any more.
    void finishStatus()
    {
        if (context_.isCancelled() && !arePublished_) cancelled();
        status_ = report_.status == MeshReport::Status::Done        ? ExitStatus::Done
                  : report_.status == MeshReport::Status::Cancelled ? ExitStatus::Cancelled
                                                                    : ExitStatus::Failed;
    }

    void writeReport()
    {
        if (!command_.report) return;
        const Result<void> written = writeTextFile(toJson(report_), *command_.report);
        if (written) return;
        tell(written.error(), ExitStatus::Failed, console_);
        if (status_ == ExitStatus::Done) status_ = ExitStatus::Failed;
    }

    void summarise()
    {
        double total = 0.0;
        for (const auto& [stage, seconds] : report_.seconds) total += seconds;
        console_.out << std::fixed << std::setprecision(2) << mesh_->nodes.size() << " nodes, ";
        if (report_.tetQuality) {
            tellElements(mesh_->tets.size(), "tetrahedra, dihedral angles", report_.tetQuality->dihedral);
            if (const auto& before = report_.anglesBeforeImprovement)
                console_.out << "before improvement " << before->least << " to " << before->largest << ", ";
        } else if (report_.triangleQuality) {
            tellElements(mesh_->triangles.size(), "triangles, angles", report_.triangleQuality->angle);
        }
        console_.out << total << " s\n";
        for (const OutputTarget& output : command_.outputs)
            console_.out << "wrote " << output.path.string() << '\n';
        for (const std::string& warning : report_.warnings)
            console_.err << "mesher: note: " << warning << '\n';
    }

    template <class Range>
    void tellElements(std::size_t count, const char* what, const Range& angles)
    {
        console_.out << count << ' ' << what << " from " << angles.least() << " to " << angles.largest()
                     << " degrees, ";
    }

    const MeshCommand& command_;
    Console console_;
    ProgressLine progress_;
    RunContext context_;
    InterruptScope interrupt_;
    MeshReport report_;
    BrepModel model_;
    std::shared_ptr<const SizingField> fileSizes_;
    std::optional<ClassifiedMesh> mesh_;
    std::optional<CurvedBoundary> boundary_;
    bool arePublished_ = false;
    ExitStatus status_ = ExitStatus::Done;
};

}  // namespace

ExitStatus runMesh(const MeshCommand& command, Console console) { return MeshRun(command, console).run(); }

}  // namespace mesher
