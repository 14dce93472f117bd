#include "cli/wishes.h"

#include "brep/planarity.h"
#include "io/mesh_writer.h"
#include "pipeline/planar_model.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace mesher {

namespace {

/// Whether the face can have all of its nodes at one z.
bool isLevel(const BrepFace& face)
{
    constexpr double kLargestTilt = 1e-6;  // what is less may be rounding; the writer sees it exactly
    const std::optional<PlaneFrame> frame = face.surface->planeFrame();
    return frame && std::hypot(frame->normal.x, frame->normal.y) <= kLargestTilt;
}

}  // namespace

Result<void> checkWishes(const MeshCommand& command, const BrepModel& model)
{
    if (command.options.dimension == 3) return {};
    const Result<std::vector<BrepFaceId>> faces = facesToMesh(model, command.options);
    if (!faces) return faces.error();
    if (command.curvedBoundary && !lieInOnePlane(model, faces.value())) {
        return Error{ErrorCode::InvalidArgument,
                     "is of faces in one plane, and these are meshed as surfaces in space",
                     "--curved-boundary",
                     {},
                     "leave the option out"};
    }
    for (const OutputTarget& output : command.outputs) {
        const Result<const MeshFormat*> format = findFormat(output.path, output.format);
        if (!format || !format.value()->wantsLevelPlane) continue;
        const auto face = std::find_if(faces->begin(), faces->end(),
                                       [&](BrepFaceId f) { return !isLevel(model.faces[f]); });
        if (face == faces->end()) continue;
        return Error{ErrorCode::InvalidArgument,
                     nameOf(EntityRef{2, face->value}) + " is not at constant z, and " +
                         std::string(format.value()->name) + " of faces wants a plane mesh that is",
                     output.path.string(),
                     {},
                     "turn the face into the plane z = 0, choose another format, or mesh the solid"};
    }
    return {};
}

}  // namespace mesher
