// Meshes the examples of chapter 2 and writes FOLDER/examples.md and its pictures: planar_figures FOLDER [MESHES].
// With a second folder the meshes are written there too, as Gmsh files. Ends with 1 if a mesh breaks a promise.

#include "angle_histogram.h"
#include "base/run_context.h"
#include "figures_page.h"
#include "io/draw_png.h"
#include "io/mesh_writer.h"
#include "io/write_text_file.h"
#include "pipeline/classify_planar.h"

#include <filesystem>
#include <iostream>
#include <set>

namespace mesher::test {
namespace {

Result<void> writePicture(const Image& image, const std::filesystem::path& path)
{
    Result<AtomicFile> file = AtomicFile::create(path);
    if (!file) return file.error();
    FileBuffer buffer(*file);
    writePngFile(image, buffer);
    if (auto finished = buffer.finish(); !finished) return finished;
    return file->commit();
}

ClassifiedMesh meshOf(const MeshedFigure& meshed)
{
    PlanarCurveComplex complex = meshed.figure.complex;
    for (std::uint32_t i = 0; i < complex.regionNames.size(); ++i)
        complex.regionNames[i] = nameOf(BrepFaceId(i));
    constexpr int kBoundaryOrder = 2;
    return classifyPlanar(complex, meshed.result.triangulation, kBoundaryOrder).mesh;
}

/// The triangles left beside small angles get a colour that no region of these examples has beside them.
ClassifiedMesh withMarkedTriangles(const MeshedFigure& meshed, ClassifiedMesh mesh)
{
    constexpr EntityRef kMark{2, 3};
    const PlanarTriangulation& t = meshed.result.triangulation;
    std::set<TriangleId> left;
    for (const LeftTriangle2d& triangle : meshed.result.refinement.left) left.insert(triangle.triangle);
    std::size_t exported = 0;
    for (std::uint32_t i = 0; i < t.mesh().triangleSlots(); ++i) {
        if (!t.mesh().isAlive(TriangleId(i)) || !t.isMeshed(TriangleId(i))) continue;
        if (left.count(TriangleId(i)) > 0) mesh.triangles[exported].entity = kMark;
        ++exported;
    }
    return mesh;
}

Result<void> writeFigure(const MeshedFigure& meshed, const std::filesystem::path& folder)
{
    const std::filesystem::path figures = folder / "figures";
    DrawingOptions drawing;
    drawing.width = 600;
    drawing.boundaryWidth = 2.0;
    drawing.window = meshed.figure.window;
    const Result<Image> image = drawMesh(withMarkedTriangles(meshed, meshOf(meshed)), drawing);
    if (!image) return image.error();
    if (auto r = writePicture(*image, figures / (meshed.figure.name + ".png")); !r) return r;
    return writeTextFile(drawHistogram(meshed.check.angles), figures / (meshed.figure.name + "_angles.svg"));
}

Result<MeshedFigure> meshed(PlanarFigure figure)
{
    RunContext context;
    auto result = triangulatePlanar(figure.complex, figure.options, context);
    if (!result) return result.error();
    PlanarCheck check = checkPlanar(figure.complex, *result, figure.options);
    if (!check.isClean()) {
        return Error{ErrorCode::InvalidArgument, check.violations.front(), figure.name, {}, {}};
    }
    return MeshedFigure{std::move(figure), std::move(*result), std::move(check)};
}

Result<void> run(const std::filesystem::path& folder, const std::filesystem::path& meshFolder)
{
    std::filesystem::create_directories(folder / "figures");
    std::vector<MeshedFigure> figures;
    for (PlanarFigure& figure : planarFigures()) {
        Result<MeshedFigure> made = meshed(std::move(figure));
        if (!made) return made.error();
        if (auto written = writeFigure(*made, folder); !written) return written;
        if (!meshFolder.empty()) {
            std::filesystem::create_directories(meshFolder);
            const auto path = meshFolder / (made->figure.name + ".msh");
            if (auto written = writeMesh(meshOf(*made), path); !written) return written;
        }
        figures.push_back(std::move(*made));
    }
    return writeTextFile(figuresPage(figures), folder / "examples.md");
}

}  // namespace
}  // namespace mesher::test

int main(int count, char** words)
{
    if (count != 2 && count != 3) {
        std::cerr << "planar_figures FOLDER [MESHES]\n";
        return 2;
    }
    const auto done = mesher::test::run(words[1], count == 3 ? words[2] : "");
    if (done) return 0;
    std::cerr << mesher::describe(done.error()) << '\n';
    return 1;
}
