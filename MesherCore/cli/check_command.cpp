#include "cli/commands.h"
#include "cli/model_file.h"
#include "io/mesh_reader.h"
#include "io/write_text_file.h"
#include "mesh/mesh_check.h"
#include "pipeline/mesh_report.h"
#include "pipeline/model_check.h"

#include <iomanip>

namespace mesher {

namespace {

void printMesh(const MeshCheckReport& report, const MeshReport& quality, std::ostream& out)
{
    out << report.counts.nodes << " nodes, " << report.counts.points << " points, " << report.counts.lines
        << " lines, " << report.counts.triangles << " triangles, " << report.counts.tets << " tetrahedra\n"
        << std::setprecision(15);
    if (report.counts.tets > 0) {
        for (const auto& [index, volume] : report.volumeOfSolid) {
            out << "volume of " << (index == EntityRef::kNone ? "no solid" : nameOf(EntityRef{3, index}))
                << ": " << volume << '\n';
        }
        out << "dihedral angles: " << quality.tetQuality->dihedral.least() << " to "
            << quality.tetQuality->dihedral.largest() << " degrees\n";
    } else if (report.counts.triangles > 0) {
        for (const auto& [index, area] : report.areaOfFace) {
            out << "area of " << (index == EntityRef::kNone ? "no face" : nameOf(EntityRef{2, index})) << ": "
                << area << '\n';
        }
        out << "angles: " << quality.triangleQuality->angle.least() << " to "
            << quality.triangleQuality->angle.largest() << " degrees\n";
    }
}

void printModel(const ModelCheckReport& report, std::ostream& out)
{
    constexpr const char* kWhat[] = {"vertices", "edges", "faces"};
    for (std::size_t d = 0; d < 3; ++d) {
        out << "largest distance of nodes on " << kWhat[d] << ": " << report.largestDistance[d];
        if (!report.farthestEntity[d].empty()) out << " at " << report.farthestEntity[d];
        out << '\n';
    }
}

}  // namespace

ExitStatus runCheck(const CheckCommand& command, Console console)
{
    const Result<MeshFile> file = readMesh(command.mesh);
    if (!file) return tell(file.error(), ExitStatus::Failed, console);
    const ClassifiedMesh& mesh = file.value().mesh;
    const MeshCheckReport check = checkMesh(mesh);
    std::vector<std::string> problems = check.problems();
    MeshReport report;
    report.modelFile = command.model ? command.model->string() : "";
    report.versions = {{"mesher", MESHER_VERSION}};
    const bool isReadable = check.badReferences == 0 && check.nonFiniteNodes == 0;
    if (isReadable) {
        describeMesh(mesh, report);
        printMesh(check, report, console.out);
    }
    if (command.model && isReadable) {
        const Result<ReadModel> model = readModelFile(*command.model, false, "check");
        if (!model) return tell(model.error(), ExitStatus::Failed, console);
        const ModelCheckReport onModel = checkAgainstModel(mesh, model.value().model);
        printModel(onModel, console.out);
        for (const std::string& problem : onModel.problems()) problems.push_back(problem);
    }
    for (const std::string& problem : problems) {
        report.failures.push_back({ErrorCode::InvalidArgument, problem, command.mesh.string(), {}, {}});
        console.out << "wrong: " << problem << '\n';
    }
    report.status = problems.empty() ? MeshReport::Status::Done : MeshReport::Status::Failed;
    if (command.report) {
        const Result<void> written = writeTextFile(toJson(report), *command.report);
        if (!written) return tell(written.error(), ExitStatus::Failed, console);
    }
    if (!problems.empty()) {
        const Error invalid = {ErrorCode::InvalidArgument,
                               "the mesh is not valid: " + problems.front(),
                               command.mesh.string(),
                               {},
                               {}};
        return tell(invalid, ExitStatus::Failed, console);
    }
    console.out << "valid\n";
    return ExitStatus::Done;
}

}  // namespace mesher
