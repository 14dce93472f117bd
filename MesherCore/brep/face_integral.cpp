#include "brep/face_integral.h"

#include <algorithm>
#include <cmath>
#include <numbers>

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

/// The rule of four points is right to 1e-7 on a quarter of a turn.
double widestPanel(const BrepFace& face)
{
    switch (face.surface->kind()) {
        case SurfaceKind::Plane: return face.boundsU.length();
        case SurfaceKind::Cylinder:
        case SurfaceKind::Cone:
        case SurfaceKind::Sphere:
        case SurfaceKind::Torus: return 0.5 * std::numbers::pi;
        default: return 0.25 * face.boundsU.length();
    }
}

std::size_t stepsAlong(const BrepModel& model, const BrepFace& face, const BrepCoedge& coedge)
{
    constexpr std::size_t kLeast = 64, kMost = 1024, kPerSpan = 4, kExact = 2;
    const BrepEdge& edge = model.edges[coedge.edge];
    const bool isStraight = edge.curve && edge.curve->kind() == CurveKind::Line;
    if (isStraight && face.surface->kind() == SurfaceKind::Plane) return kExact;
    std::size_t spans =
        breaksWithin(face.surface->breaksV(), face.surface->periodV(), face.boundsV).size() + 1;
    if (edge.curve) spans = std::max(spans, edge.curve->knots().size() + 1);
    return std::clamp(kPerSpan * spans, kLeast, kMost);
}

bool areLevel(const std::vector<Vec2>& places, Interval boundsV)
{
    constexpr double kRounding = 1e-12;
    const auto isLower = [](Vec2 a, Vec2 b) { return a.y < b.y; };
    const auto [lowest, highest] = std::minmax_element(places.begin(), places.end(), isLower);
    return highest->y - lowest->y <= kRounding * boundsV.length();
}

}  // namespace

std::vector<double> panelEnds(const BrepFace& face)
{
    const Surface& surface = *face.surface;
    std::vector<double> borders = breaksWithin(surface.breaksU(), surface.periodU(), face.boundsU);
    borders.insert(borders.begin(), face.boundsU.first);
    borders.push_back(face.boundsU.last);
    const double widest = widestPanel(face);
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

std::vector<Vec2> placesAlong(const BrepModel& model, const BrepFace& face, const BrepCoedge& coedge)
{
    const Interval part = model.edges[coedge.edge].part;
    const std::size_t steps = stepsAlong(model, face, coedge);
    std::vector<Vec2> places;
    places.reserve(steps + 1);
    for (std::size_t i = 0; i <= steps; ++i) {
        const double share = static_cast<double>(i) / static_cast<double>(steps);
        places.push_back(coedge.parameterCurve->position(part.at(share)));
    }
    if (areLevel(places, face.boundsV)) places.clear();
    return places;
}

}  // namespace mesher
