#include "triangulation2d/planar_estimate.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace mesher {
namespace {

/// Triangles per area in units of the size; measured on a square and an annulus at uniform size.
constexpr double kTrianglesPerSquare = 2.72;
/// Where the largest size is less than this times the smallest one, the size at the middle stands for all.
constexpr double kEvenSizes = 1.6;
constexpr double kLeastSize =
    1e-100;  ///< smaller ones, whose square is nothing, make too many triangles anyway
constexpr std::size_t kMostSubdivisions = 100'000;

/// A part of a triangle of the initial triangulation.
struct Part
{
    std::array<Vec2, 3> corner;
    TriangleId whole;
    double share = 1.0;  ///< of the whole
};

/// Divides triangles where the size varies, the larger parts first, until it hardly does in any of them.
class Integral
{
public:
    Integral(const PlanarDomain& domain, const PlanarSizing& sizing, const Triangulation2d& mesh)
        : domain_(domain), sizing_(sizing), mesh_(mesh)
    {
    }

    void add(TriangleId t)
    {
        const Triangle2d& record = mesh_.triangle(t);
        parts_.push_back(
            {{mesh_.position(record.v[0]), mesh_.position(record.v[1]), mesh_.position(record.v[2])}, t});
    }

    double sum()
    {
        double count = 0.0;
        for (std::size_t next = 0; next < parts_.size(); ++next) count += countOrDivide(Part(parts_[next]));
        return count;
    }

private:
    /// The number of triangles in a part, or none if it is divided.
    double countOrDivide(const Part& part)
    {
        const auto& [a, b, c] = part.corner;
        const Vec2 middle = (1.0 / 3.0) * (a + b + c);
        const double size = sizeAt(middle, part.whole);
        const double reach = std::max({length(a - middle), length(b - middle), length(c - middle)});
        const auto [smallest, largest] = rangeIn(part, middle, reach, size);
        const bool isResolved = reach < smallest || largest < kEvenSizes * smallest;
        if (!isResolved && subdivisions_ < kMostSubdivisions) {
            ++subdivisions_;
            divide(part);
            return 0.0;
        }
        // What could not be divided any further counts for the worst; no part of the initial triangulation goes away.
        const double wanted = isResolved ? size : smallest;
        return std::max(part.share, kTrianglesPerSquare * (0.5 * cross(b - a, c - a) / wanted) / wanted);
    }

    void divide(const Part& part)
    {
        const auto& [a, b, c] = part.corner;
        const Vec2 ab = 0.5 * (a + b);
        const Vec2 bc = 0.5 * (b + c);
        const Vec2 ca = 0.5 * (c + a);
        for (const std::array<Vec2, 3>& corner :
             {std::array{a, ab, ca}, std::array{ab, b, bc}, std::array{ca, bc, c}, std::array{bc, ca, ab}}) {
            parts_.push_back({corner, part.whole, 0.25 * part.share});
        }
    }

    /// By the length scales of the corners and of the subcurves among the sides, between whose ends they are interpolated.
    [[nodiscard]] double sizeAt(Vec2 p, TriangleId whole) const
    {
        const Triangle2d& record = mesh_.triangle(whole);
        double size = wantedSize(domain_, sizing_, p);
        for (unsigned i = 0; i < 3; ++i) {
            const VertexId a = record.v[nextCorner(i)];
            const VertexId b = record.v[previousCorner(i)];
            const Vec2 along = mesh_.position(b) - mesh_.position(a);
            const Vec2 toP = p - mesh_.position(a);
            // A side that is no subcurve stands for its first end only.
            const double share =
                record.isConstrained(i) ? std::clamp(dot(toP, along) / squaredLength(along), 0.0, 1.0) : 0.0;
            const double scale = (1.0 - share) * mesh_.lengthScale(a) + share * mesh_.lengthScale(b);
            size = std::min(size, scale + length(toP - share * along) / sizing_.grading);
        }
        return std::max(size, kLeastSize);
    }

    /// Of the sizes in a part. A field may be small at a place between all those that it is asked at.
    [[nodiscard]] std::pair<double, double> rangeIn(const Part& part, Vec2 middle, double reach,
                                                    double size) const
    {
        std::pair<double, double> range = {size, size};
        for (const Vec2 p : part.corner) {
            const double there = sizeAt(p, part.whole);
            range = {std::min(range.first, there), std::max(range.second, there)};
        }
        if (sizing_.field == nullptr) return range;
        const double unit = domain_.scale();
        const double inside = unit * sizing_.field->smallestNear(domain_.toSpace(middle), reach / unit);
        return {std::max(kLeastSize, std::min(range.first, inside)), range.second};
    }

    const PlanarDomain& domain_;
    const PlanarSizing& sizing_;
    const Triangulation2d& mesh_;
    std::vector<Part> parts_;
    std::size_t subdivisions_ = 0;
};

}  // namespace

double expectedTriangleCount(const PlanarDomain& domain, const PlanarSizing& sizing,
                             const PlanarTriangulation& triangulation)
{
    const Triangulation2d& mesh = triangulation.mesh();
    Integral integral(domain, sizing, mesh);
    double unsized = 0.0;
    for (std::uint32_t i = 0; i < mesh.triangleSlots(); ++i) {
        const TriangleId id(i);
        if (!mesh.isAlive(id) || !triangulation.isMeshed(id)) continue;
        if (sizing.isActive()) {
            integral.add(id);
        } else {
            unsized += 1.0;
        }
    }
    return unsized + integral.sum();
}

}  // namespace mesher
