#include "surface_sampling/face_pinch.h"

#include <cmath>

namespace mesher {

namespace {

/// Whether the face goes through the line of constant v, and not only along it.
bool crosses(const BrepFace& face, double v)
{
    constexpr int kPlaces = 32;
    constexpr double kMargin = 1e-6;
    const double least = kMargin * face.boundsV.length();
    if (v - face.boundsV.first < least || face.boundsV.last - v < least) return false;
    if (!face.trim) return true;
    for (int i = 0; i < kPlaces; ++i) {
        const double u = face.boundsU.at((i + 0.5) / kPlaces);
        if (face.trim->classify({u, v}) == TrimSide::Inside) return true;
    }
    return false;
}

}  // namespace

std::optional<Error> refusePinch(const BrepModel& model, BrepFaceId f)
{
    const BrepFace& face = model.faces[f];
    const double period = face.surface->periodV();
    for (const double pinch : face.surface->pinchesV()) {
        // The image in the bounds of the face.
        const double v =
            period > 0.0 ? pinch + period * std::ceil((face.boundsV.first - pinch) / period) : pinch;
        if (!crosses(face, v)) continue;
        return Error{ErrorCode::IntersectingConstraints,
                     "the face meets itself in a point on the axis of its surface", nameOf(f),
                     face.surface->position({face.boundsU.at(0.5), v}),
                     "end the face at that point, or keep its profile off the axis"};
    }
    return {};
}

}  // namespace mesher
