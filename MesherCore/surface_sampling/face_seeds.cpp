#include "surface_sampling/face_seeds.h"

#include "surface_sampling/face_triangulation.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <span>

namespace mesher {

namespace {

constexpr double kTurnPerLine = 0.25 * std::numbers::pi;
constexpr std::size_t kMostLines = 256;
constexpr std::size_t kMostStations = 512;

/// The bounds, and between the breaks inside of them a few places each.
std::vector<double> stationsOf(Interval bounds, std::span<const double> breaks)
{
    std::vector<double> borders{bounds.first};
    for (const double b : breaks) {
        if (borders.back() < b && b < bounds.last) borders.push_back(b);
    }
    borders.push_back(bounds.last);
    const std::size_t spans = borders.size() - 1;
    const std::size_t perSpan = std::clamp<std::size_t>(kMostStations / spans, 1, spans < 4 ? 12 : 4);
    std::vector<double> stations{bounds.first};
    for (std::size_t i = 0; i < spans; ++i) {
        for (std::size_t k = 1; k <= perSpan; ++k) {
            const double share = static_cast<double>(k) / static_cast<double>(perSpan);
            stations.push_back(Interval{borders[i], borders[i + 1]}.at(share));
        }
    }
    return stations;
}

/// Where the normal has turned by a further step, going along the stations on the worst of some parallel lines.
template <class NormalAt>
std::vector<double> linesAlong(const std::vector<double>& stations, const NormalAt& normalAt)
{
    constexpr int kParallels = 5;
    std::vector<double> turned(stations.size(), 0.0);
    for (std::size_t i = 1; i < stations.size(); ++i) {
        double most = 0.0;
        for (int k = 0; k < kParallels; ++k) {
            const double across = (k + 0.5) / kParallels;
            const Vec3 a = normalAt(stations[i - 1], across), b = normalAt(stations[i], across);
            if (a == Vec3{} || b == Vec3{}) continue;
            most = std::max(most, std::atan2(length(cross(a, b)), dot(a, b)));
        }
        turned[i] = turned[i - 1] + most;
    }
    const double total = turned.back();
    const auto steps =
        static_cast<std::size_t>(std::min(std::ceil(total / kTurnPerLine - 1e-6), double(kMostLines)));
    std::vector<double> lines;
    for (std::size_t k = 1; k < steps; ++k) {
        const double wanted = total * static_cast<double>(k) / static_cast<double>(steps);
        const auto above = std::upper_bound(turned.begin(), turned.end(), wanted);
        const auto i = static_cast<std::size_t>(above - turned.begin());
        if (i == 0 || i >= turned.size()) continue;
        const double share = (wanted - turned[i - 1]) / (turned[i] - turned[i - 1]);
        lines.push_back(Interval{stations[i - 1], stations[i]}.at(share));
    }
    return lines;
}

}  // namespace

std::vector<Vec2> seedsOf(const BrepFace& face)
{
    const Surface& surface = *face.surface;
    const auto normalAt = [&](Vec2 uv) { return FaceTriangulation::unitNormal(surface.evaluate(uv)); };
    const std::vector<double> u =
        linesAlong(stationsOf(face.boundsU, surface.breaksU()), [&](double x, double across) {
            return normalAt({x, face.boundsV.at(across)});
        });
    if (u.empty()) return {};
    const std::vector<double> v =
        linesAlong(stationsOf(face.boundsV, surface.breaksV()), [&](double y, double across) {
            return normalAt({face.boundsU.at(across), y});
        });
    std::vector<Vec2> seeds;
    seeds.reserve(u.size() * v.size());
    for (const double y : v) {
        for (const double x : u) seeds.push_back({x, y});
    }
    return seeds;
}

}  // namespace mesher
