#include "brep/face_distance.h"

#include <limits>

namespace mesher {

namespace {

bool isNearer(const FaceDistance& a, const FaceDistance& b)
{
    return a.distance - a.tolerance < b.distance - b.tolerance;
}

/// Edges count with their tolerance: one that is farther away may be the one that the place belongs to.
FaceDistance distanceFromEdges(const BrepModel& model, const BrepFace& face, const Vec3& place)
{
    FaceDistance nearest{std::numeric_limits<double>::infinity(), 0.0, {}};
    const auto look = [&](BrepEdgeId id) {
        const BrepEdge& edge = model.edges[id];
        const FaceDistance found =
            edge.isDegenerate
                ? FaceDistance{length(place - model.vertices[edge.first].position),
                               model.vertices[edge.first].tolerance,
                               {}}
                : FaceDistance{edge.curve->project(place, edge.part).distance, edge.tolerance, {}};
        if (isNearer(found, nearest)) nearest = found;
    };
    for (const BrepLoop& loop : face.loops) {
        for (const BrepCoedge& coedge : loop.coedges) look(coedge.edge);
    }
    return nearest;
}

}  // namespace

FaceDistance distanceFromFace(const BrepModel& model, BrepFaceId id, const Vec3& place,
                              std::optional<Vec2> parameters)
{
    const BrepFace& face = model.faces[id];
    FaceDistance nearest{std::numeric_limits<double>::infinity(), face.tolerance, {}};
    const auto look = [&](std::optional<Vec2> seed) {
        const SurfaceProjection foot = face.surface->project(place, seed);
        if (face.trim && face.trim->classify(foot.parameters) == TrimSide::Outside) return;
        if (foot.distance < nearest.distance) nearest = {foot.distance, face.tolerance, foot.parameters};
    };
    look(std::nullopt);
    if (parameters && nearest.distance > face.tolerance) look(parameters);
    if (nearest.distance <= face.tolerance) return nearest;
    const FaceDistance fromEdges = distanceFromEdges(model, face, place);
    return isNearer(fromEdges, nearest) ? fromEdges : nearest;
}

}  // namespace mesher
