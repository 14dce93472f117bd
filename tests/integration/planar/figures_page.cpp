#include "figures_page.h"

#include "base/run_context.h"
#include "delaunay/mesh_hash2d.h"
#include "formatted.h"
#include "support/planar_examples.h"
#include "triangulation2d/small_angle_report2d.h"

#include <cinttypes>

namespace mesher::test {
namespace {

constexpr const char* kIntroduction =
    "# Examples of the planar mesher\n\n"
    "Domains of the kind of the thesis' figures in chapter 2, made anew, with a bound of 30 degrees. This "
    "page and its "
    "pictures are\nwritten by one command, `build/release/bin/planar_figures docs`; a test holds the page, "
    "and with it each "
    "mesh to the last bit of its\nvertices (`hash`), to what the mesher makes in Debug and in Release. "
    "Angles are in "
    "degrees; \"elsewhere\" are all triangles but those beside\nan input angle below 60 degrees, which are "
    "pink in the "
    "pictures and listed with that angle.\n\n"
    "| example | thesis | vertices | triangles | smallest angle | largest | smallest elsewhere | largest "
    "elsewhere | "
    "hash |\n|---|---|---:|---:|---:|---:|---:|---:|---|\n";

std::string overviewRow(const MeshedFigure& meshed)
{
    const AngleStatistics& angles = meshed.check.angles;
    return formatted("| [%s](#%s) | %s | %zu | %zu | %.1f | %.1f | %.1f | %.1f | %016" PRIx64 " |\n",
                     meshed.figure.name.c_str(), meshed.figure.name.c_str(), meshed.figure.thesis.c_str(),
                     meshed.result.counts.vertices, meshed.result.counts.triangles, angles.smallest,
                     angles.largest, angles.smallestElsewhere, angles.largestElsewhere,
                     meshHash2d(meshed.result.triangulation.mesh()));
}

std::string smallAngleTable(const PlanarResult& result)
{
    const std::vector<TrianglesBesideAngle2d> list = trianglesBesideSmallAngles(result);
    if (list.empty()) return {};
    std::string text = "\nLeft beside small input angles:\n\n| input angle | apex | triangles | smallest "
                       "angle | largest angle "
                       "|\n|---:|---|---:|---:|---:|\n";
    for (const TrianglesBesideAngle2d& beside : list) {
        text +=
            formatted("| %.1f | (%.3g, %.3g) | %zu | %.1f | %.1f |\n", beside.angle.degrees, beside.apex.x,
                      beside.apex.y, beside.triangles, beside.smallestAngle, beside.largestAngle);
    }
    return text;
}

std::string section(const MeshedFigure& meshed)
{
    const PlanarFigure& figure = meshed.figure;
    const PlanarSizing& sizing = figure.options.refinement.sizing;
    const std::string sizes = sizing.field != nullptr ? "user's size"
                              : !sizing.usesLocalFeatureSize
                                  ? "no sizes"
                                  : formatted("R = %g, G = %g", sizing.refinement, sizing.grading);
    std::string text =
        formatted("\n## %s\n\n%s (Fig. %s). Curves cut at %g degrees, %s: %zu vertices, %zu triangles.\n\n",
                  figure.name.c_str(), figure.title.c_str(), figure.thesis.c_str(),
                  figure.options.sampling.maxVariation, sizes.c_str(), meshed.result.counts.vertices,
                  meshed.result.counts.triangles);
    text += formatted("![mesh](figures/%s.png)\n\n![angles](figures/%s_angles.svg)\n", figure.name.c_str(),
                      figure.name.c_str());
    return text + smallAngleTable(meshed.result);
}

/// How dense an annulus is at its boundary and halfway between its circles.
struct AnnulusDensity
{
    PlanarCounts counts;
    double boundaryEdge = 0.0;  ///< mean length
    double interiorEdge = 0.0;  ///< mean length of the edges whose middles have radii from 1.4 to 1.6
};

AnnulusDensity densityOf(double refinement, double grading)
{
    PlanarOptions options;
    options.refinement.sizing.refinement = refinement;
    options.refinement.sizing.grading = grading;
    RunContext context;
    const auto result = triangulatePlanar(annulus(), options, context);
    const PlanarTriangulation& t = result->triangulation;
    AnnulusDensity density;
    density.counts = result->counts;
    double boundaryEdges = 0.0;
    double interiorEdges = 0.0;
    for (std::uint32_t i = 0; i < t.mesh().triangleSlots(); ++i) {
        const TriangleId id(i);
        if (!t.mesh().isAlive(id) || !t.isMeshed(id)) continue;
        for (unsigned k = 0; k < 3; ++k) {
            const Vec2 a = t.mesh().position(t.mesh().triangle(id).v[nextCorner(k)]);
            const Vec2 b = t.mesh().position(t.mesh().triangle(id).v[previousCorner(k)]);
            const double radius = length(0.5 * (a + b));
            if (t.mesh().triangle(id).isConstrained(k)) {
                density.boundaryEdge += length(b - a);
                boundaryEdges += 1.0;
            } else if (1.4 < radius && radius < 1.6) {
                density.interiorEdge += length(b - a);
                interiorEdges += 1.0;
            }
        }
    }
    density.boundaryEdge /= boundaryEdges;
    density.interiorEdge /= interiorEdges;
    return density;
}

std::string densityTable()
{
    std::string text = "\n## What R and G do\n\nThe annulus of Fig. 2.8. R divides the length scale at the "
                       "boundary, from where it "
                       "grows by distance / G: R makes the boundary dense,\nand the interior only as far as "
                       "it is near; G makes the "
                       "interior dense, and the boundary by the one halving that is left to it.\n\n| R | G | "
                       "boundary edges | vertices inside | mean "
                       "boundary edge | mean edge halfway |\n|---:|---:|---:|---:|---:|---:|\n";
    for (const auto& [refinement, grading] :
         {std::pair(1.0, 1.0), std::pair(10.0, 1.0), std::pair(20.0, 1.0), std::pair(10.0, 3.0),
          std::pair(10.0, 10.0), std::pair(1.0, 10.0)}) {
        const AnnulusDensity density = densityOf(refinement, grading);
        text +=
            formatted("| %g | %g | %zu | %zu | %.3f | %.3f |\n", refinement, grading,
                      density.counts.boundaryEdges, density.counts.vertices - density.counts.boundaryEdges,
                      density.boundaryEdge, density.interiorEdge);
    }
    return text;
}

}  // namespace

std::string figuresPage(const std::vector<MeshedFigure>& figures)
{
    std::string page = kIntroduction;
    for (const MeshedFigure& meshed : figures) page += overviewRow(meshed);
    page += densityTable();
    for (const MeshedFigure& meshed : figures) page += section(meshed);
    return page;
}

}  // namespace mesher::test
