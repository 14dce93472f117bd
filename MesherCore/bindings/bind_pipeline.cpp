#include "bindings/bindings.h"
#include "bindings/python_error.h"
#include "bindings/python_options.h"
#include "bindings/python_sizes.h"
#include "brep/occt/read_model.h"
#include "pipeline/estimate_model.h"
#include "pipeline/mesh_model.h"
#include "pipeline/report_steps.h"

#include <pybind11/stl.h>

#include <chrono>
#include <exception>
#include <memory>
#include <optional>
#include <string>

namespace mesher::python {

namespace py = pybind11;

namespace {

using Clock = std::chrono::steady_clock;

/// Hands progress to a Python function and listens to Ctrl+C meanwhile. What Python raises ends the run and is raised again
/// behind it, since no exception may cross the mesher. The interpreter may be busy with other threads, and each word to it has
/// to wait for them: it hears of new stages, of each tenth and of the end, and of what is between every few milliseconds.
class PythonProgress
{
public:
    /// `stage` is what the function hears until the first is told.
    PythonProgress(py::object callback, std::string stage)
        : callback_(std::move(callback)), stage_(std::move(stage))
    {
    }

    bool operator()(std::string_view stage, double fraction)
    {
        const Clock::time_point now = Clock::now();
        const bool isNews = stage != stage_ || fraction >= 1.0 || fraction >= fraction_ + kStep;
        if (!isNews && now - told_ < kPause) return !raised_;
        stage_ = stage;
        fraction_ = fraction;
        return tell(now);
    }
    /// Between two words of progress: whether Ctrl+C or the function has ended the run meanwhile.
    bool poll()
    {
        const Clock::time_point now = Clock::now();
        return now - told_ < kPatience ? !raised_ : tell(now);
    }
    void raiseAgain() const
    {
        if (raised_) std::rethrow_exception(raised_);
    }

private:
    bool tell(Clock::time_point now)
    {
        told_ = now;
        const py::gil_scoped_acquire acquired;
        if (raised_) return false;
        try {
            if (PyErr_CheckSignals() != 0) throw py::error_already_set();
            if (callback_.is_none()) return true;
            return !callback_(stage_, fraction_).is(py::bool_(false));
        } catch (py::error_already_set&) {
            raised_ = std::current_exception();
            return false;
        }
    }

    static constexpr std::chrono::milliseconds kPause{10};
    static constexpr std::chrono::milliseconds kPatience{100};
    static constexpr double kStep = 0.1;

    py::object callback_;
    std::string stage_;
    double fraction_ = 0.0;
    Clock::time_point told_;
    std::exception_ptr raised_;
};

struct AskedFor
{
    MeshOptions options;
    std::shared_ptr<const SizingField> sizes;
};

/// Raises       TypeError and OptionError for what makes no sense
AskedFor askedFor(const py::dict& named)
{
    AskedFor asked;
    asked.options = meshOptionsOf(named);
    asked.sizes = sizingFieldOf(named, asked.options);
    if (const Result<void> valid = validate(asked.options); !valid) raise("OptionError", valid.error());
    return asked;
}

RunSettings settingsFor(const MeshOptions& options, PythonProgress& progress)
{
    RunSettings settings;
    settings.threads = options.threads;
    settings.progress = [&progress](std::string_view stage, double fraction) {
        return progress(stage, fraction);
    };
    settings.poll = [&progress] { return progress.poll(); };
    return settings;
}

std::pair<std::shared_ptr<ClassifiedMesh>, std::string> run(const ReadModel& read, const py::dict& named,
                                                            py::object callback)
{
    const AskedFor asked = askedFor(named);
    PythonProgress progress(std::move(callback), "sizes");
    RunContext context(settingsFor(asked.options, progress));
    constexpr int kBoundaryOrder = 2;  // the least: nobody sees the curved boundary from here
    MeshOutcome outcome;
    std::string report;
    {
        const py::gil_scoped_release released;
        outcome = meshModel(read.model, asked.options, asked.sizes, kBoundaryOrder, context);
        report = toJson(outcome.report);
    }
    progress.raiseAgain();
    std::shared_ptr<ClassifiedMesh> mesh;
    if (outcome.mesh) mesh = std::make_shared<ClassifiedMesh>(std::move(*outcome.mesh));
    return {std::move(mesh), std::move(report)};
}

py::dict estimate(const ReadModel& read, const py::dict& named, py::object callback)
{
    const AskedFor asked = askedFor(named);
    PythonProgress progress(std::move(callback), "estimate");
    RunContext context(settingsFor(asked.options, progress));
    const Result<MeshEstimate> found = [&] {
        const py::gil_scoped_release released;
        return estimateModel(read.model, asked.options, asked.sizes, context);
    }();
    progress.raiseAgain();
    if (const std::optional<StopReason> reason = context.stopReason())
        raise(*reason == StopReason::Cancelled ? "Cancelled" : "MeshingError",
              errorOf(*reason, asked.options));
    if (!found) {
        const bool isOption = found.error().entity.starts_with("--");
        raise(isOption ? "OptionError" : "MeshingError", found.error());
    }
    py::dict told;
    told["elements"] = found.value().elements;
    told["bytes"] = found.value().bytes;
    told["seconds"] = found.value().seconds;
    told["at_least"] = found.value().isLeast;
    return told;
}

}  // namespace

void bindPipeline(py::module_& module)
{
    module.def("run", &run, py::arg("model"), py::arg("options"), py::arg("progress") = py::none());
    module.def(
        "validate", [](const py::dict& named) { askedFor(named); }, py::arg("options"));
    module.def("estimate", &estimate, py::arg("model"), py::arg("options"), py::arg("progress") = py::none());
}

}  // namespace mesher::python
