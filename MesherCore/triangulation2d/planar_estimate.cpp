#include "triangulation2d/planar_estimate.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace mesher {
namespace {

/// Triangles per area in units of the size; measured on a square and an annulus at uniform size.
constexpr double kTrianglesPerSquare = 2.72;
constexpr int kDeepestSubdivision = 7;

class Integral
{
public:
    Integral(const PlanarDomain& domain, const PlanarSizing& sizing) : domain_(domain), sizing_(sizing) {}

    double over(const std::array<Vec2, 3>& corners, const std::array<double, 3>& scales) const
    {
        return integrate(corners, corners, scales, kDeepestSubdivision);
    }

private:
    [[nodiscard]] double sizeAt(Vec2 p, const std::array<Vec2, 3>& corners,
                                const std::array<double, 3>& scales) const
    {
        double size = wantedSize(domain_, sizing_, p);
        for (std::size_t i = 0; i < 3; ++i)
            size = std::min(size, scales[i] + length(p - corners[i]) / sizing_.grading);
        return size;
    }

    double integrate(const std::array<Vec2, 3>& part, const std::array<Vec2, 3>& corners,
                     const std::array<double, 3>& scales, int depth) const
    {
        const Vec2 middle = (1.0 / 3.0) * (part[0] + part[1] + part[2]);
        const double size = sizeAt(middle, corners, scales);
        const double reach =
            std::max({length(part[0] - middle), length(part[1] - middle), length(part[2] - middle)});
        if (depth == 0 || !varies(part, corners, scales, size) || reach < size) {
            // No piece of the initial triangulation is less than a triangle.
            const double pieces = std::ldexp(1.0, -2 * (kDeepestSubdivision - depth));
            const double area = 0.5 * cross(part[1] - part[0], part[2] - part[0]);
            return std::max(pieces, kTrianglesPerSquare * area / (size * size));
        }
        const Vec2 m0 = 0.5 * (part[1] + part[2]);
        const Vec2 m1 = 0.5 * (part[2] + part[0]);
        const Vec2 m2 = 0.5 * (part[0] + part[1]);
        return integrate({part[0], m2, m1}, corners, scales, depth - 1) +
               integrate({m2, part[1], m0}, corners, scales, depth - 1) +
               integrate({m1, m0, part[2]}, corners, scales, depth - 1) +
               integrate({m0, m1, m2}, corners, scales, depth - 1);
    }

    [[nodiscard]] bool varies(const std::array<Vec2, 3>& part, const std::array<Vec2, 3>& corners,
                              const std::array<double, 3>& scales, double size) const
    {
        constexpr double kTolerance = 0.2;
        return std::any_of(part.begin(), part.end(), [&](Vec2 p) {
            return std::abs(sizeAt(p, corners, scales) - size) > kTolerance * size;
        });
    }

    const PlanarDomain& domain_;
    const PlanarSizing& sizing_;
};

}  // namespace

Result<double> estimateTriangleCount(const PlanarCurveComplex& complex, const PlanarOptions& options,
                                     RunContext& context)
{
    PlanarOptions initial = options;
    initial.isRefined = false;
    auto result = triangulatePlanar(complex, initial, context);
    if (!result) return result.error();
    const auto domain = PlanarDomain::make(complex);
    if (!domain) return domain.error();
    const PlanarTriangulation& t = result->triangulation;
    if (!options.refinement.sizing.isActive()) return static_cast<double>(result->counts.initialTriangles);
    const Integral integral(*domain, options.refinement.sizing);
    double count = 0.0;
    for (std::uint32_t i = 0; i < t.mesh().triangleSlots(); ++i) {
        const TriangleId id(i);
        if (!t.mesh().isAlive(id) || !t.isMeshed(id)) continue;
        std::array<Vec2, 3> corners;
        std::array<double, 3> scales{};
        for (unsigned k = 0; k < 3; ++k) {
            corners[k] = t.mesh().position(t.mesh().triangle(id).v[k]);
            scales[k] = t.mesh().lengthScale(t.mesh().triangle(id).v[k]);
        }
        count += integral.over(corners, scales);
    }
    return count;
}

}  // namespace mesher
