#include "pipeline/plane_region.h"

#include <algorithm>
#include <limits>

namespace mesher {

PlaneRegion::PlaneRegion(const PlaneFrame& frame, std::vector<Chord> boundary)
    : frame_(frame), boundary_(std::move(boundary))
{
    double high = -std::numeric_limits<double>::infinity();
    low_ = std::numeric_limits<double>::infinity();
    for (const Chord& chord : boundary_) {
        low_ = std::min({low_, chord[0].y, chord[1].y});
        high = std::max({high, chord[0].y, chord[1].y});
    }
    const std::size_t strips = std::max<std::size_t>(1, boundary_.size());
    start_.assign(strips + 1, 0);
    if (!(high > low_)) return;
    stripsPerLength_ = static_cast<double>(strips) / (high - low_);
    const auto forStrips = [&](const Chord& chord, auto visit) {
        const std::size_t last = stripOf(std::max(chord[0].y, chord[1].y));
        for (std::size_t s = stripOf(std::min(chord[0].y, chord[1].y)); s <= last; ++s) visit(s);
    };
    for (const Chord& chord : boundary_) forStrips(chord, [&](std::size_t s) { ++start_[s + 1]; });
    for (std::size_t s = 0; s < strips; ++s) start_[s + 1] += start_[s];
    chords_.resize(start_.back());
    std::vector<std::size_t> next(start_.begin(), start_.end() - 1);
    for (std::uint32_t i = 0; i < boundary_.size(); ++i) {
        forStrips(boundary_[i], [&](std::size_t s) { chords_[next[s]++] = i; });
    }
}

std::size_t PlaneRegion::stripOf(double y) const
{
    const double strip = (y - low_) * stripsPerLength_;
    return static_cast<std::size_t>(std::clamp(strip, 0.0, static_cast<double>(start_.size() - 2)));
}

bool PlaneRegion::contains(const Vec3& point) const
{
    const Vec2 p = frame_.toPlane(point);
    const std::size_t strip = stripOf(p.y);
    bool isInside = false;
    for (std::size_t i = start_[strip]; i < start_[strip + 1]; ++i) {
        const auto& [a, b] = boundary_[chords_[i]];
        if ((a.y <= p.y) == (b.y <= p.y)) continue;
        const double x = a.x + (b.x - a.x) * ((p.y - a.y) / (b.y - a.y));
        if (x > p.x) isInside = !isInside;
    }
    return isInside;
}

}  // namespace mesher
