// Meshes the faces of model files coarsely and checks the result: sample_faces [--faces] [--size H] MODEL…
// One line per model: faces meshed and found valid, facets, segments, time; with --faces one line for each face that failed.
// Exit 0 if all faces of all models are valid, 1 if not, 2 wrong usage.

#include "brep/occt/read_model.h"
#include "sizing/uniform_size.h"
#include "surface_sampling/initial_face_mesh.h"
#include "surface_sampling/surface_check.h"

#include <sys/resource.h>

#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace {

struct Settings
{
    bool listsFaces = false;
    double size = 0.0;
    std::vector<const char*> models;
};

struct Totals
{
    std::size_t models = 0;
    std::size_t soundModels = 0;
    std::size_t faces = 0;
    std::size_t validFaces = 0;
    std::size_t facets = 0;
    double seconds = 0.0;
    std::map<std::string, std::size_t> reasons;
};

double userSeconds()
{
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    return static_cast<double>(usage.ru_utime.tv_sec) + 1e-6 * static_cast<double>(usage.ru_utime.tv_usec);
}

/// A message without its numbers.
std::string kindOf(std::string_view message)
{
    std::string kind;
    bool wasNumber = false;
    for (const char c : message) {
        const bool isNumber =
            (c >= '0' && c <= '9') || (wasNumber && (c == '.' || c == 'e' || c == '-' || c == '+'));
        if (!isNumber) kind += c;
        if (isNumber && !wasNumber) kind += '#';
        wasNumber = isNumber;
    }
    return kind;
}

void tell(const Settings& settings, Totals& totals, const std::string& entity, const std::string& reason)
{
    ++totals.reasons[kindOf(reason)];
    if (settings.listsFaces) std::printf("    %s: %s\n", entity.c_str(), reason.c_str());
}

/// One line for each face that failed, and the reasons counted.
void tellFailures(const Settings& settings, const mesher::InitialSurfaceMesh& initial,
                  const mesher::SurfaceCheck& check, Totals& totals)
{
    std::vector<bool> hasError(check.faces.size(), false);
    for (const auto& [face, error] : initial.failures) {
        hasError[face.value] = true;
        tell(settings, totals, error.entity, mesher::describe(error));
    }
    for (std::uint32_t f = 0; f < check.faces.size(); ++f) {
        const mesher::CheckReport& report = check.faces[mesher::BrepFaceId(f)].report;
        if (!report.isValid() && !hasError[f])
            tell(settings, totals, nameOf(mesher::BrepFaceId(f)), report.problem);
    }
    if (!check.nodes.isValid()) tell(settings, totals, "nodes", check.nodes.problem);
    if (!check.shells.isValid() && initial.failures.empty())
        tell(settings, totals, "shells", check.shells.problem);
}

void sampleModel(const Settings& settings, const char* path, const mesher::BrepModel& model, Totals& totals)
{
    totals.faces += model.faces.size();
    const double start = userSeconds();
    const mesher::UniformSize size(settings.size);
    mesher::CurveChainOptions chainOptions;
    if (settings.size > 0.0) chainOptions.sizes = &size;
    mesher::IdVector<mesher::NodeId, mesher::MeshNode> nodes;
    mesher::RunContext context;
    auto chains = mesher::sampleCurveChains(model, chainOptions, nodes, context);
    if (!chains) {
        ++totals.reasons[kindOf(chains.error().message)];
        std::printf("curves  %s: %s\n", path, mesher::describe(chains.error()).c_str());
        return;
    }
    const double chained = userSeconds();
    const auto initial = mesher::initialSurfaceMesh(model, *chains, nodes, {}, context);
    const double meshed = userSeconds();
    const mesher::SurfaceMesh mesh = mesher::assembleSurfaceMesh(*chains, nodes, initial);
    const mesher::SurfaceCheck check = mesher::checkSurfaceMesh(model, mesh);
    std::size_t valid = 0, leftAlone = 0;
    for (const mesher::FaceCheck& face : check.faces) valid += face.report.isValid() ? 1 : 0;
    for (const mesher::InitialFaceMesh& face : initial.faces) leftAlone += face.leftAlone;
    std::printf("%s %s: %zu of %zu faces, %zu facets (%zu left alone), %zu segments, %zu splits, %d rounds, "
                "%zu complexes, curves %.3f s, faces %.3f s\n",
                check.isValid() ? "sound  " : "BROKEN ", path, valid, model.faces.size(), mesh.facets.size(),
                leftAlone, chains->aliveCount(), initial.segmentSplits, initial.rounds,
                chains->smallAngles().size(), chained - start, meshed - chained);
    tellFailures(settings, initial, check, totals);
    totals.validFaces += valid;
    totals.soundModels += check.isValid() ? 1 : 0;
    totals.facets += mesh.facets.size();
    totals.seconds += meshed - chained;
    std::fflush(stdout);
}

void sample(const Settings& settings, const char* path, Totals& totals)
{
    ++totals.models;
    const auto read = mesher::readModel(path);
    if (read) return sampleModel(settings, path, read->model, totals);
    std::printf("refused %s: %s\n", path, mesher::describe(read.error()).c_str());
}

}  // namespace

int main(int count, char** arguments)
{
    Settings settings;
    for (int i = 1; i < count; ++i) {
        const std::string_view argument = arguments[i];
        if (argument == "--faces") {
            settings.listsFaces = true;
        } else if (argument == "--size" && i + 1 < count) {
            settings.size = std::atof(arguments[++i]);
        } else {
            settings.models.push_back(arguments[i]);
        }
    }
    if (settings.models.empty()) {
        std::fputs("usage: sample_faces [--faces] [--size H] MODEL…\n", stderr);
        return 2;
    }
    Totals totals;
    for (const char* path : settings.models) sample(settings, path, totals);
    std::printf("%zu of %zu models sound, %zu of %zu faces valid, %zu facets at %.0f facets/s\n",
                totals.soundModels, totals.models, totals.validFaces, totals.faces, totals.facets,
                static_cast<double>(totals.facets) / totals.seconds);
    for (const auto& [reason, times] : totals.reasons) std::printf("%6zu  %s\n", times, reason.c_str());
    return totals.soundModels == totals.models ? 0 : 1;
}
