#include "support/planar_figures.h"

#include "sizing/attractor_size.h"
#include "support/planar_examples.h"

#include <cmath>
#include <utility>

namespace mesher::test {
namespace {

PlanarFigure sized(PlanarFigure figure, double refinement, double grading)
{
    figure.options.refinement.sizing.refinement = refinement;
    figure.options.refinement.sizing.grading = grading;
    return figure;
}

/// Refined for quality alone, curves cut by their turning of so many degrees.
PlanarFigure withoutSizes(PlanarFigure figure, double maxVariation)
{
    figure.options.refinement.sizing.usesLocalFeatureSize = false;
    figure.options.sampling.maxVariation = maxVariation;
    return figure;
}

PlanarFigure closeUp(PlanarFigure figure, Vec2 low, Vec2 high)
{
    figure.window = Box2{low, high};
    return figure;
}

/// A user's size along the chord of the airfoil, growing with the distance from it.
PlanarFigure nacaWithUserSize()
{
    PlanarFigure figure("naca0012",
                        "A NACA 0012 section in a far field of 20 chords, with a size given by the user",
                        "2.9", nacaInFarField());
    DistanceProfile profile;
    profile.growth = 0.12;
    // Half the thickness is 0.06: on the section the size is a little above what is given on its chord.
    std::vector<Attractor> attractors{{{0.0, 0.0, 0.0}, {1.0, 0.0, 0.0}, 0.012}};
    figure.field = std::make_shared<AttractorSize>(std::move(attractors), profile);
    figure.options.refinement.sizing.field = figure.field.get();
    return closeUp(std::move(figure), {-0.6, -0.75}, {1.7, 0.75});
}

}  // namespace

PlanarFigure::PlanarFigure(std::string figureName, std::string figureTitle, std::string thesisFigure,
                           PlanarCurveComplex domain)
    : name(std::move(figureName)),
      title(std::move(figureTitle)),
      thesis(std::move(thesisFigure)),
      complex(std::move(domain))
{
    for (std::uint32_t i = 0; i < complex.curves.size(); ++i) complex.curves[i].edge = BrepEdgeId(i);
    for (std::uint32_t i = 0; i < complex.points.size(); ++i) complex.points[i].vertex = BrepVertexId(i);
    options.limits.maxVertices = 1'000'000;
}

std::vector<PlanarFigure> planarFigures()
{
    std::vector<PlanarFigure> list;
    list.push_back({"annulus_r1_g1", "An annulus, as coarse as can be", "2.8 (a)", annulus()});
    list.push_back(sized({"annulus_r10_g1", "R makes the boundary dense", "2.8 (c)", annulus()}, 10.0, 1.0));
    list.push_back(
        sized({"annulus_r10_g10", "G makes the interior dense", "2.8 (d)", annulus()}, 10.0, 10.0));
    list.push_back(nacaWithUserSize());
    list.push_back({"overlapping_hulls",
                    "Two arcs, one in the hull of the other: the outer one has to be split first", "2.10",
                    overlappingHulls()});
    list.push_back(sized({"bulge_outside_of_circles", "A bulge whose split point lies outside of all circles",
                          "2.11", bulgeOutsideOfCircles()},
                         3.0, 1.0));
    list.push_back({"thin_hole_between_arcs", "Two arcs with an unmeshed region between them", "2.12",
                    thinHoleBetweenArcs()});
    list.push_back(
        closeUp(withoutSizes({"three_element_tv90",
                              "A three-element airfoil, curves cut where they turn by 90 degrees, no sizes",
                              "2.16 (b)", threeElementAirfoil()},
                             90.0),
                {-0.3, -0.5}, {1.3, 0.4}));
    list.push_back(
        closeUp(withoutSizes({"three_element_tv30", "The same, curves cut where they turn by 30 degrees",
                              "2.16 (c)", threeElementAirfoil()},
                             30.0),
                {-0.3, -0.5}, {1.3, 0.4}));
    list.push_back({"disjoint_regions", "Regions side by side that do not see each other", "2.17",
                    manyDisjointRegions()});
    list.push_back({"spline_cavity_coarse", "A cavity between splines, with small angles at two corners",
                    "2.18", splineCavity()});
    list.push_back(sized({"spline_cavity_fine", "The same, finer", "2.19", splineCavity()}, 2.0, 5.0));
    list.push_back({"small_angle_fan", "A fan of lines and curves with angles from 0.5 to 45 degrees", "2.20",
                    smallAngleFan()});
    return list;
}

}  // namespace mesher::test
