#include "pipeline/planar_area.h"

#include <array>
#include <cmath>
#include <vector>

namespace mesher {

namespace {

constexpr int kPanels = 16;
/// Abscissae in [-1, 1] and weights of the Gauss rule of five points.
constexpr std::array<double, 5> kAbscissa = {-0.9061798459386640, -0.5384693101056831, 0.0,
                                             0.5384693101056831, 0.9061798459386640};
constexpr std::array<double, 5> kWeight = {0.2369268850561891, 0.4786286704993665, 0.5688888888888889,
                                           0.4786286704993665, 0.2369268850561891};

/// Integral over the edge's part of a function of the curve's point and derivative.
template <class Integrand>
double integrate(const BrepEdge& edge, Integrand integrand)
{
    std::vector<double> cuts = {edge.part.first};
    for (const double knot : edge.curve->knots()) {
        if (knot > edge.part.first && knot < edge.part.last) cuts.push_back(knot);
    }
    cuts.push_back(edge.part.last);
    double sum = 0.0;
    for (std::size_t i = 0; i + 1 < cuts.size(); ++i) {
        const double width = (cuts[i + 1] - cuts[i]) / kPanels;
        for (int panel = 0; panel < kPanels; ++panel) {
            const double middle = cuts[i] + (panel + 0.5) * width;
            for (std::size_t k = 0; k < kAbscissa.size(); ++k) {
                const CurvePoint point = edge.curve->evaluate(middle + 0.5 * width * kAbscissa[k]);
                sum += 0.5 * width * kWeight[k] * integrand(point);
            }
        }
    }
    return sum;
}

}  // namespace

std::optional<double> planarArea(const BrepModel& model, BrepFaceId face)
{
    const std::optional<PlaneFrame> frame = model.faces[face].surface->planeFrame();
    if (!frame) return std::nullopt;
    double doubled = 0.0;
    for (const BrepLoop& loop : model.faces[face].loops) {
        for (const BrepCoedge& coedge : loop.coedges) {
            const BrepEdge& edge = model.edges[coedge.edge];
            if (edge.isDegenerate) continue;
            const double part = integrate(edge, [&](const CurvePoint& point) {
                return cross(frame->toPlane(point.position), frame->directionToPlane(point.d1));
            });
            doubled += coedge.isReversed ? -part : part;
        }
    }
    return 0.5 * std::abs(doubled);
}

double edgeLength(const BrepEdge& edge)
{
    if (edge.isDegenerate) return 0.0;
    return integrate(edge, [](const CurvePoint& point) { return length(point.d1); });
}

}  // namespace mesher
