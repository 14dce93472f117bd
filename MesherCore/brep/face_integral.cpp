#include "brep/face_integral.h"

#include <algorithm>
#include <cmath>

namespace mesher {

namespace {

/// The breaks that lie between, and the images of those of a periodic direction.
std::vector<double> breaksWithin(std::span<const double> breaks, double period, Interval bounds)
{
    std::vector<double> within;
    for (const double first : breaks) {
        double at = period > 0.0 ? first + period * std::ceil((bounds.first - first) / period) : first;
        for (; at < bounds.last; at += period) {
            if (at > bounds.first) within.push_back(at);
            if (!(period > 0.0)) break;
        }
    }
    std::sort(within.begin(), within.end());
    return within;
}

}  // namespace

std::vector<double> panelEnds(const BrepFace& face, int panels)
{
    const Surface& surface = *face.surface;
    std::vector<double> borders = breaksWithin(surface.breaksU(), surface.periodU(), face.boundsU);
    borders.insert(borders.begin(), face.boundsU.first);
    borders.push_back(face.boundsU.last);
    const double widest = face.boundsU.length() / panels;
    std::vector<double> ends = {borders.front()};
    for (std::size_t i = 1; i < borders.size(); ++i) {
        const double left = borders[i - 1], length = borders[i] - left;
        constexpr double kRounding = 1e-9;
        const double parts = std::max(1.0, std::ceil(length / widest - kRounding));
        for (double part = 1.0; part < parts; ++part) ends.push_back(left + part / parts * length);
        ends.push_back(borders[i]);
    }
    return ends;
}

std::size_t integrationSteps(const BrepModel& model, const BrepFace& face, const BrepCoedge& coedge)
{
    constexpr std::size_t kLeast = 64, kMost = 1024, kPerSpan = 4;
    const BrepEdge& edge = model.edges[coedge.edge];
    std::size_t spans =
        breaksWithin(face.surface->breaksV(), face.surface->periodV(), face.boundsV).size() + 1;
    if (edge.curve) spans = std::max(spans, edge.curve->knots().size() + 1);
    return std::clamp(kPerSpan * spans, kLeast, kMost);
}

}  // namespace mesher
