#include "brep/analytic/solids.h"

#include "brep/analytic/conic_curves.h"
#include "brep/analytic/line_curve.h"
#include "brep/analytic/parameter_curves.h"
#include "brep/analytic/plane_surface.h"
#include "brep/analytic/round_surfaces.h"
#include "brep/analytic/simple_trims.h"

#include <array>
#include <cmath>
#include <utility>

namespace mesher {

namespace {

constexpr double kTolerance = 1e-7;
constexpr double kTurn = RoundSurface::kTurn;

std::optional<Error> refuseSize(double size, const char* name)
{
    if (size > 0.0 && std::isfinite(size)) return {};
    return Error{ErrorCode::InvalidArgument, std::string(name) + " is not positive and finite", "", {}, ""};
}

BrepEdgeId addEdge(BrepModel& model, std::shared_ptr<const Curve> curve, BrepVertexId first, BrepVertexId last)
{
    const Interval part = curve->range();
    return model.edges.push_back({std::move(curve), part, first, last, kTolerance, false});
}

BrepEdgeId addPole(BrepModel& model, BrepVertexId pole)
{
    return model.edges.push_back({nullptr, {0.0, kTurn}, pole, pole, kTolerance, true});
}

std::shared_ptr<const Curve> circle(const Axes& axes, double radius, Interval range = {0.0, kTurn})
{
    return std::make_shared<CircleCurve>(axes, radius, range);
}

std::shared_ptr<const Curve> segment(const Vec3& a, const Vec3& b)
{
    return std::make_shared<LineCurve>(LineCurve::between(a, b));
}

BrepCoedge use(BrepEdgeId edge, bool isReversed, Vec2 start, Vec2 direction)
{
    return {edge, isReversed, std::make_shared<LineParameterCurve>(start, direction), 0.0};
}

/// A face over a rectangle of parameters whose sides are bottom, right, top (reversed) and left (reversed).
BrepFaceId addRoundFace(BrepModel& model, std::shared_ptr<const Surface> surface, BrepLoop loop, Interval v)
{
    BrepFace face;
    face.surface = std::move(surface);
    face.loops.push_back(std::move(loop));
    face.boundsU = {0.0, kTurn};
    face.boundsV = v;
    const Vec2 periods{face.surface->periodU(), face.surface->periodV()};
    face.trim = std::make_shared<RectangleTrim>(face.boundsU, v, Vec2{1e-9, 1e-9 * (1.0 + v.length())}, periods);
    face.tolerance = kTolerance;
    return model.faces.push_back(std::move(face));
}

BrepFaceId addDisk(BrepModel& model, const Axes& axes, double height, double radius, BrepEdgeId edge, bool isTop)
{
    PlaneFrame frame{axes.toSpace({0.0, 0.0, height}), axes.x, axes.y, axes.z};
    if (!isTop) frame = {frame.origin, axes.x, -1.0 * axes.y, -1.0 * axes.z};
    BrepFace face;
    face.surface = std::make_shared<PlaneSurface>(frame);
    face.loops.push_back({{{edge, !isTop, std::make_shared<CircleParameterCurve>(radius, !isTop), 0.0}}});
    face.boundsU = face.boundsV = {-radius, radius};
    face.trim = std::make_shared<DiskTrim>(radius, 1e-9 * radius);
    face.tolerance = kTolerance;
    return model.faces.push_back(std::move(face));
}

BrepModel closeSolid(BrepModel model)
{
    BrepShell shell;
    shell.isClosed = true;
    for (std::uint32_t f = 0; f < model.faces.size(); ++f) shell.faces.push_back({BrepFaceId(f), false});
    model.solids.push_back({{std::move(shell)}});
    return model;
}

void includeDisk(Box3& box, const Axes& axes, double height, double radius)
{
    const Vec3 centre = axes.toSpace({0.0, 0.0, height});
    const auto reach = [&](double x, double y) { return radius * std::hypot(x, y); };
    const Vec3 extent{reach(axes.x.x, axes.y.x), reach(axes.x.y, axes.y.y), reach(axes.x.z, axes.y.z)};
    box.include(centre - extent);
    box.include(centre + extent);
}

Axes raised(const Axes& axes, double height)
{
    Axes result = axes;
    result.origin = axes.toSpace({0.0, 0.0, height});
    return result;
}

/// The half plane of u = 0: angles in it run from x to z.
Axes meridian(const Axes& axes, double ringRadius)
{
    return {axes.toSpace({ringRadius, 0.0, 0.0}), axes.x, axes.z, -1.0 * axes.y};
}

/// Side, bottom and top of a cylinder or cone.
BrepModel makeRound(const Axes& axes, double bottomRadius, double topRadius, double height,
                    std::shared_ptr<const Surface> side, double slant)
{
    const bool isPointed = topRadius == 0.0;
    BrepModel model;
    const BrepVertexId low = model.vertices.push_back({axes.toSpace({bottomRadius, 0.0, 0.0}), kTolerance});
    const BrepVertexId high = model.vertices.push_back({axes.toSpace({topRadius, 0.0, height}), kTolerance});
    const BrepEdgeId bottom = addEdge(model, circle(axes, bottomRadius), low, low);
    const BrepEdgeId seam = addEdge(model, segment(model.vertices[low].position, model.vertices[high].position), low, high);
    const BrepEdgeId top =
        isPointed ? addPole(model, high) : addEdge(model, circle(raised(axes, height), topRadius), high, high);
    BrepLoop loop{{use(bottom, false, {0.0, 0.0}, {1.0, 0.0}), use(seam, false, {kTurn, 0.0}, {0.0, 1.0}),
                   use(top, true, {0.0, slant}, {1.0, 0.0}), use(seam, true, {0.0, 0.0}, {0.0, 1.0})}};
    addRoundFace(model, std::move(side), std::move(loop), {0.0, slant});
    addDisk(model, axes, 0.0, bottomRadius, bottom, false);
    includeDisk(model.box, axes, 0.0, bottomRadius);
    if (!isPointed) addDisk(model, axes, height, topRadius, top, true);
    includeDisk(model.box, axes, height, topRadius);
    return closeSolid(std::move(model));
}

/// Adds the face of a box at the low or high side of an axis; edges[axis][b + 2 c] runs along the axis.
void addBoxFace(BrepModel& model, const std::array<Vec3, 2>& corners, std::size_t axis, bool isHigh,
                const std::array<std::array<BrepEdgeId, 4>, 3>& edges)
{
    const std::array<Vec3, 3> units{Vec3{1.0, 0.0, 0.0}, Vec3{0.0, 1.0, 0.0}, Vec3{0.0, 0.0, 1.0}};
    const Vec3 size = corners[1] - corners[0];
    // x and y of the frame are two axes of space, so that the normal points out of the box.
    const std::size_t x = (axis + (isHigh ? 1 : 2)) % 3, y = (axis + (isHigh ? 2 : 1)) % 3;
    const double width = dot(size, units[x]), depth = dot(size, units[y]);
    const Vec3 origin = corners[0] + (isHigh ? dot(size, units[axis]) : 0.0) * units[axis];
    const auto edgeAlong = [&](std::size_t along, std::size_t other, bool isOtherHigh) {
        const std::size_t first = (along + 1) % 3;
        const std::size_t otherBit = other == first ? 1 : 2, axisBit = axis == first ? 1 : 2;
        return edges[along][(isOtherHigh ? otherBit : 0) + (isHigh ? axisBit : 0)];
    };
    BrepFace face;
    face.surface = std::make_shared<PlaneSurface>(
        PlaneFrame{origin, units[x], units[y], (isHigh ? 1.0 : -1.0) * units[axis]});
    face.loops.push_back({{use(edgeAlong(x, y, false), false, {0.0, 0.0}, {1.0, 0.0}),
                           use(edgeAlong(y, x, true), false, {width, 0.0}, {0.0, 1.0}),
                           use(edgeAlong(x, y, true), true, {0.0, depth}, {1.0, 0.0}),
                           use(edgeAlong(y, x, false), true, {0.0, 0.0}, {0.0, 1.0})}});
    face.boundsU = {0.0, width};
    face.boundsV = {0.0, depth};
    face.trim = std::make_shared<RectangleTrim>(face.boundsU, face.boundsV, Vec2{1e-9 * width, 1e-9 * depth}, Vec2{});
    face.tolerance = kTolerance;
    model.faces.push_back(std::move(face));
}

}  // namespace

Result<BrepModel> makeBox(const Vec3& low, const Vec3& high)
{
    const Vec3 size = high - low;
    for (const double extent : {size.x, size.y, size.z}) {
        if (auto error = refuseSize(extent, "an extent of the box")) return *error;
    }
    BrepModel model;
    for (unsigned bits = 0; bits < 8; ++bits) {
        const Vec3 p{(bits & 1u) ? high.x : low.x, (bits & 2u) ? high.y : low.y, (bits & 4u) ? high.z : low.z};
        model.vertices.push_back({p, kTolerance});
        model.box.include(p);
    }
    std::array<std::array<BrepEdgeId, 4>, 3> edges;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        for (std::uint32_t side = 0; side < 4; ++side) {
            const std::uint32_t first = (side & 1u) << ((axis + 1) % 3) | (side >> 1) << ((axis + 2) % 3);
            const BrepVertexId a(first), b(first | 1u << axis);
            edges[axis][side] = addEdge(model, segment(model.vertices[a].position, model.vertices[b].position), a, b);
        }
    }
    for (std::size_t axis = 0; axis < 3; ++axis) {
        for (const bool isHigh : {false, true}) addBoxFace(model, {low, high}, axis, isHigh, edges);
    }
    return closeSolid(std::move(model));
}

Result<BrepModel> makeCylinder(const Axes& axes, double radius, double height)
{
    if (auto error = refuseSize(radius, "the radius")) return *error;
    if (auto error = refuseSize(height, "the height")) return *error;
    return makeRound(axes, radius, radius, height, std::make_shared<CylinderSurface>(axes, radius), height);
}

Result<BrepModel> makeCone(const Axes& axes, double bottomRadius, double topRadius, double height)
{
    if (auto error = refuseSize(bottomRadius, "the bottom radius")) return *error;
    if (topRadius != 0.0) {
        if (auto error = refuseSize(topRadius, "the top radius")) return *error;
    }
    if (auto error = refuseSize(height, "the height")) return *error;
    const double angle = std::atan2(topRadius - bottomRadius, height);
    return makeRound(axes, bottomRadius, topRadius, height, std::make_shared<ConeSurface>(axes, bottomRadius, angle),
                     std::hypot(topRadius - bottomRadius, height));
}

Result<BrepModel> makeSphere(const Axes& axes, double radius)
{
    if (auto error = refuseSize(radius, "the radius")) return *error;
    const Interval latitudes{-0.25 * kTurn, 0.25 * kTurn};
    BrepModel model;
    const BrepVertexId south = model.vertices.push_back({axes.toSpace({0.0, 0.0, -radius}), kTolerance});
    const BrepVertexId north = model.vertices.push_back({axes.toSpace({0.0, 0.0, radius}), kTolerance});
    const BrepEdgeId southPole = addPole(model, south);
    const BrepEdgeId seam = addEdge(model, circle(meridian(axes, 0.0), radius, latitudes), south, north);
    const BrepEdgeId northPole = addPole(model, north);
    BrepLoop loop{{use(southPole, false, {0.0, latitudes.first}, {1.0, 0.0}), use(seam, false, {kTurn, 0.0}, {0.0, 1.0}),
                   use(northPole, true, {0.0, latitudes.last}, {1.0, 0.0}), use(seam, true, {0.0, 0.0}, {0.0, 1.0})}};
    addRoundFace(model, std::make_shared<SphereSurface>(axes, radius), std::move(loop), latitudes);
    model.box.include(axes.origin - Vec3{radius, radius, radius});
    model.box.include(axes.origin + Vec3{radius, radius, radius});
    return closeSolid(std::move(model));
}

Result<BrepModel> makeTorus(const Axes& axes, double ringRadius, double tubeRadius)
{
    if (auto error = refuseSize(tubeRadius, "the tube's radius")) return *error;
    if (auto error = refuseSize(ringRadius - tubeRadius, "the ring's radius less the tube's")) return *error;
    BrepModel model;
    const BrepVertexId vertex = model.vertices.push_back({axes.toSpace({ringRadius + tubeRadius, 0.0, 0.0}), kTolerance});
    const BrepEdgeId ring = addEdge(model, circle(axes, ringRadius + tubeRadius), vertex, vertex);
    const BrepEdgeId tube = addEdge(model, circle(meridian(axes, ringRadius), tubeRadius), vertex, vertex);
    BrepLoop loop{{use(ring, false, {0.0, 0.0}, {1.0, 0.0}), use(tube, false, {kTurn, 0.0}, {0.0, 1.0}),
                   use(ring, true, {0.0, kTurn}, {1.0, 0.0}), use(tube, true, {0.0, 0.0}, {0.0, 1.0})}};
    addRoundFace(model, std::make_shared<TorusSurface>(axes, ringRadius, tubeRadius), std::move(loop), {0.0, kTurn});
    // The exact extent along a direction d: the tube all around, the ring by the part of d in its plane.
    Box3 ringBox;
    includeDisk(ringBox, axes, 0.0, ringRadius);
    const Vec3 tubeExtent{tubeRadius, tubeRadius, tubeRadius};
    model.box.include(ringBox.low - tubeExtent);
    model.box.include(ringBox.high + tubeExtent);
    return closeSolid(std::move(model));
}

}  // namespace mesher
