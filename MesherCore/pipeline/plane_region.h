#pragma once

#include "brep/plane_frame.h"
#include "sizing/region_size.h"

#include <array>
#include <cstdint>
#include <vector>

namespace mesher {

/// A region of a plane by the chords of its boundary, in any order and direction: tells inside from outside up to the distance
/// of the chords from the curves that they stand for.
/// Cost         linear to make; a question looks at the chords of one strip of the plane, as many strips as chords
class PlaneRegion final : public SizeRegion
{
public:
    using Chord = std::array<Vec2, 2>;

    PlaneRegion(const PlaneFrame& frame, std::vector<Chord> boundary);

    /// Of the point's projection onto the plane.
    [[nodiscard]] bool contains(const Vec3& point) const override;

private:
    [[nodiscard]] std::size_t stripOf(double y) const;

    PlaneFrame frame_;
    std::vector<Chord> boundary_;
    double low_ = 0.0;
    double stripsPerLength_ = 0.0;
    std::vector<std::size_t> start_;     ///< of each strip in `chords_`, and the end
    std::vector<std::uint32_t> chords_;  ///< by strip
};

}  // namespace mesher
