#include "brep/planarity.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <sstream>

namespace mesher {

namespace {

constexpr int kSamples = 16;

/// Newell's normal: exact for a plane polygon, an average for any other.
Vec3 normalOf(const std::vector<Vec3>& points)
{
    Vec3 sum;
    for (std::size_t i = 0; i < points.size(); ++i) {
        const Vec3 a = points[i] - points[0], b = points[(i + 1) % points.size()] - points[0];
        sum = sum + cross(a, b);
    }
    return sum;
}

Vec3 perpendicular(const Vec3& normal)
{
    const Vec3 size{std::abs(normal.x), std::abs(normal.y), std::abs(normal.z)};
    if (size.x <= size.y && size.x <= size.z) return cross(normal, {1.0, 0.0, 0.0});
    return size.y <= size.z ? cross(normal, {0.0, 1.0, 0.0}) : cross(normal, {0.0, 0.0, 1.0});
}

std::vector<Vec3> sampleFace(const BrepFace& face)
{
    std::vector<Vec3> points;
    for (int i = 0; i <= kSamples; ++i) {
        for (int j = 0; j <= kSamples; ++j) {
            const Vec2 uv{face.boundsU.at(static_cast<double>(i) / kSamples),
                          face.boundsV.at(static_cast<double>(j) / kSamples)};
            if (face.trim->classify(uv) != TrimSide::Outside) points.push_back(face.surface->position(uv));
        }
    }
    return points;
}

/// What the face and its edges may be off its plane.
double allowanceOf(const BrepModel& model, const BrepFace& face)
{
    double allowed = std::max(face.tolerance, 1e-7);
    for (const BrepLoop& loop : face.loops) {
        for (const BrepCoedge& coedge : loop.coedges)
            allowed = std::max(allowed, model.edges[coedge.edge].tolerance);
    }
    return allowed;
}

/// Where the face's own plane passes the places of its boundary, the other plane has to be as near.
bool isInPlane(const BrepModel& model, BrepFaceId id, const PlaneFrame& own, const PlaneFrame& other)
{
    const double allowed = allowanceOf(model, model.faces[id]);
    const std::vector<Vec3> boundary = sampleBoundary(model, model.faces[id]);
    return std::all_of(boundary.begin(), boundary.end(), [&](const Vec3& place) {
        const Vec3 foot = place - own.distanceTo(place) * own.normal;
        return std::abs(other.distanceTo(foot)) <= allowed;
    });
}

}  // namespace

std::vector<Vec3> sampleBoundary(const BrepModel& model, const BrepFace& face)
{
    std::vector<Vec3> points;
    for (const BrepLoop& loop : face.loops) {
        for (const BrepCoedge& coedge : loop.coedges) {
            const BrepEdge& edge = model.edges[coedge.edge];
            if (!edge.curve) continue;
            for (int i = 0; i < kSamples; ++i) {
                const double share = static_cast<double>(i) / kSamples;
                points.push_back(edge.curve->position(edge.part.at(coedge.isReversed ? 1.0 - share : share)));
            }
        }
    }
    return points;
}

Result<PlaneFrame> planeOfFace(const BrepModel& model, BrepFaceId id)
{
    const BrepFace& face = model.faces[id];
    if (const std::optional<PlaneFrame> frame = face.surface->planeFrame()) return *frame;
    std::vector<Vec3> points = sampleBoundary(model, face);
    const Vec3 normal = points.empty() ? Vec3{} : normalOf(points);
    if (!(squaredLength(normal) > 0.0)) {
        return Error{
            ErrorCode::DegenerateInput, "the face spans no plane", nameOf(id), {}, "choose plane faces"};
    }
    PlaneFrame frame;
    frame.normal = (1.0 / length(normal)) * normal;
    const SurfacePoint middle = face.surface->evaluate({face.boundsU.at(0.5), face.boundsV.at(0.5)});
    if (dot(middle.normal(), frame.normal) < 0.0) frame.normal = -1.0 * frame.normal;
    const Vec3 side = perpendicular(frame.normal);
    frame.xAxis = (1.0 / length(side)) * side;
    frame.yAxis = cross(frame.normal, frame.xAxis);
    const std::vector<Vec3> inside = sampleFace(face);
    points.insert(points.end(), inside.begin(), inside.end());
    frame.origin = points.front();
    double low = 0.0, high = 0.0;
    for (const Vec3& p : points) {
        low = std::min(low, frame.distanceTo(p));
        high = std::max(high, frame.distanceTo(p));
    }
    frame.origin = frame.origin + 0.5 * (low + high) * frame.normal;
    const double distance = 0.5 * (high - low);
    if (distance > std::max(face.tolerance, 1e-7)) {
        std::ostringstream message;
        message.precision(3);
        message << "the face is not plane: it departs from its best plane by " << distance;
        return Error{ErrorCode::DegenerateInput,
                     message.str(),
                     nameOf(id),
                     {},
                     "choose plane faces or mesh in three dimensions"};
    }
    return frame;
}

bool lieInOnePlane(const BrepModel& model, std::span<const BrepFaceId> faces)
{
    std::optional<PlaneFrame> first;
    for (const BrepFaceId id : faces) {
        const Result<PlaneFrame> own = planeOfFace(model, id);
        if (!own) return false;
        if (!first) first = own.value();
        if (!isInPlane(model, id, own.value(), *first)) return false;
    }
    return true;
}

}  // namespace mesher
