#include "brep/model_box.h"

#include "brep/root_finding.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <span>
#include <vector>

namespace mesher {

namespace {

constexpr std::array<Vec3, 3> kAxes{Vec3{1.0, 0.0, 0.0}, Vec3{0.0, 1.0, 0.0}, Vec3{0.0, 0.0, 1.0}};

/// An interval cut at the borders that lie in it, each piece in equal steps.
std::vector<double> stations(Interval part, std::span<const double> borders)
{
    constexpr std::size_t kFewest = 8, kPerPiece = 3, kMost = 200;
    std::vector<double> ends{part.first};
    for (const double border : borders) {
        if (ends.back() < border && border < part.last) ends.push_back(border);
    }
    ends.push_back(part.last);
    const std::size_t pieces = ends.size() - 1;
    const std::size_t wanted = std::max((kFewest + pieces - 1) / pieces, kPerPiece);
    const std::size_t steps = pieces * wanted > kMost ? 1 : wanted;
    std::vector<double> result{part.first};
    for (std::size_t i = 0; i < pieces; ++i) {
        for (std::size_t k = 1; k <= steps; ++k) {
            const double share = static_cast<double>(k) / static_cast<double>(steps);
            result.push_back(k == steps ? ends[i + 1] : ends[i] + share * (ends[i + 1] - ends[i]));
        }
    }
    return result;
}

bool isRuled(SurfaceKind kind)
{
    return kind == SurfaceKind::Plane || kind == SurfaceKind::Cylinder || kind == SurfaceKind::Cone ||
           kind == SurfaceKind::Extrusion;
}

/// How far a surface goes along a direction: the first and second derivatives of that by the parameters.
struct Height
{
    double value;
    Vec2 slope;
    double uu, uv, vv;

    Height(const SurfacePoint& p, const Vec3& direction)
        : value(dot(p.position, direction)),
          slope{dot(p.du, direction), dot(p.dv, direction)},
          uu(dot(p.duu, direction)),
          uv(dot(p.duv, direction)),
          vv(dot(p.dvv, direction))
    {
    }

    /// An estimate from above of what is reached within so many parameters.
    [[nodiscard]] double within(double reachU, double reachV) const
    {
        const double first = std::abs(slope.x) * reachU + std::abs(slope.y) * reachV;
        const double second = std::abs(uu) * reachU * reachU + 2.0 * std::abs(uv) * reachU * reachV +
                              std::abs(vv) * reachV * reachV;
        return value + first + 0.5 * second;
    }
    /// Newton's step where there is a summit near, else one up the slope.
    [[nodiscard]] Vec2 stepUp() const
    {
        const double determinant = uu * vv - uv * uv;
        if (uu < 0.0 && vv < 0.0 && determinant > 1e-8 * uu * vv)
            return {(uv * slope.y - vv * slope.x) / determinant, (uv * slope.x - uu * slope.y) / determinant};
        const auto alone = [](double s, double curvature) { return curvature < 0.0 ? -s / curvature : s; };
        return {alone(slope.x, uu), alone(slope.y, vv)};
    }
};

/// Points of a surface over the bounds of a face, fine enough that its summits are near to the highest of them.
struct FaceGrid
{
    std::vector<double> u, v;
    std::vector<SurfacePoint> points;  ///< by u, then v

    explicit FaceGrid(const BrepFace& face)
        : u(stations(face.boundsU, face.surface->breaksU())),
          v(stations(face.boundsV, face.surface->breaksV()))
    {
        points.reserve(u.size() * v.size());
        for (const double a : u) {
            for (const double b : v) points.push_back(face.surface->evaluate({a, b}));
        }
    }

    [[nodiscard]] const SurfacePoint& at(std::size_t i, std::size_t j) const
    {
        return points[i * v.size() + j];
    }
    static Interval around(const std::vector<double>& lines, std::size_t i)
    {
        return {lines[i > 0 ? i - 1 : 0], lines[std::min(i + 1, lines.size() - 1)]};
    }
    [[nodiscard]] bool isSummit(std::size_t i, std::size_t j, const Vec3& direction) const
    {
        const double here = dot(at(i, j).position, direction);
        for (std::size_t a = i > 0 ? i - 1 : 0; a <= std::min(i + 1, u.size() - 1); ++a) {
            for (std::size_t b = j > 0 ? j - 1 : 0; b <= std::min(j + 1, v.size() - 1); ++b) {
                if (dot(at(a, b).position, direction) > here) return false;
            }
        }
        return true;
    }
};

/// The highest place near a point of the grid, within its cells.
Vec2 climb(const Surface& surface, const Vec3& direction, Vec2 uv, Interval windowU, Interval windowV)
{
    constexpr int kMostSteps = 40;
    Height here(surface.evaluate(uv), direction);
    for (int i = 0; i < kMostSteps; ++i) {
        Vec2 step = here.stepUp();
        bool isHigher = false;
        // Halved until it leads up, or until it is nothing.
        for (; !isHigher; step = 0.5 * step) {
            const Vec2 next{windowU.clamp(uv.x + step.x), windowV.clamp(uv.y + step.y)};
            if (next == uv) return uv;
            const Height there(surface.evaluate(next), direction);
            isHigher = there.value > here.value;
            if (!isHigher) continue;
            uv = next;
            here = there;
        }
    }
    return uv;
}

class BoxBuilder
{
public:
    void addVertex(const BrepVertex& vertex) { box_.include(vertex.position); }

    void addEdge(const BrepEdge& edge)
    {
        if (!edge.curve) return;
        const Curve& curve = *edge.curve;
        box_.include(curve.position(edge.part.first));
        box_.include(curve.position(edge.part.last));
        if (curve.kind() == CurveKind::Line) return;
        const std::vector<double> at = stations(edge.part, curve.knots());
        CurvePoint before = curve.evaluate(at[0]);
        for (std::size_t i = 1; i < at.size(); ++i) {
            const CurvePoint here = curve.evaluate(at[i]);
            box_.include(here.position);
            for (const Vec3& axis : kAxes)
                addTurn(curve, axis, {at[i - 1], at[i]}, dot(before.d1, axis), dot(here.d1, axis));
            before = here;
        }
    }

    void addFace(const BrepFace& face)
    {
        if (isRuled(face.surface->kind())) return;
        const FaceGrid grid(face);
        for (const Vec3& axis : kAxes) {
            addSummits(face, grid, axis);
            addSummits(face, grid, -1.0 * axis);
        }
    }

    [[nodiscard]] const Box3& box() const { return box_; }

private:
    void addTurn(const Curve& curve, const Vec3& axis, Interval part, double first, double last)
    {
        constexpr double kRounding = 1e-15;
        if (!(first < 0.0 && last > 0.0) && !(first > 0.0 && last < 0.0)) return;
        const auto slope = [&](double t) { return dot(curve.evaluate(t).d1, axis); };
        const double tolerance = kRounding * std::max(std::abs(part.first), std::abs(part.last));
        box_.include(curve.position(findRoot(slope, part.first, part.last, first, last, tolerance)));
    }

    void addSummits(const BrepFace& face, const FaceGrid& grid, const Vec3& direction)
    {
        for (std::size_t i = 0; i < grid.u.size(); ++i) {
            for (std::size_t j = 0; j < grid.v.size(); ++j) {
                const Interval windowU = FaceGrid::around(grid.u, i), windowV = FaceGrid::around(grid.v, j);
                const Height height(grid.at(i, j), direction);
                const bool mayMatter = height.within(windowU.length(), windowV.length()) > top(direction);
                if (!mayMatter || !grid.isSummit(i, j, direction)) continue;
                const Vec2 uv = climb(*face.surface, direction, {grid.u[i], grid.v[j]}, windowU, windowV);
                const Vec3 place = face.surface->position(uv);
                if (!(dot(place, direction) > top(direction))) continue;
                if (!face.trim || face.trim->classify(uv) != TrimSide::Outside) box_.include(place);
            }
        }
    }

    /// How far the box goes along a direction of an axis.
    [[nodiscard]] double top(const Vec3& direction) const
    {
        return std::max(dot(box_.low, direction), dot(box_.high, direction));
    }

    Box3 box_;
};

}  // namespace

Box3 boxOf(const BrepModel& model)
{
    BoxBuilder builder;
    for (const BrepVertex& vertex : model.vertices) builder.addVertex(vertex);
    for (const BrepEdge& edge : model.edges) builder.addEdge(edge);
    for (const BrepFace& face : model.faces) builder.addFace(face);
    return builder.box();
}

}  // namespace mesher
