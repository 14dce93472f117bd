#include "pipeline/planar_model.h"

#include "brep/planar_domain.h"
#include "mesh/classified_mesh.h"

#include <algorithm>
#include <optional>
#include <vector>

namespace mesher {

Result<std::vector<BrepFaceId>> facesToMesh(const BrepModel& model, const MeshOptions& options)
{
    std::vector<BrepFaceId> faces;
    for (const std::string& name : options.faces) {
        const std::optional<EntityRef> entity = entityNamed(name);
        if (!entity || entity->dimension != 2 || entity->index >= model.faces.size()) {
            return Error{ErrorCode::InvalidArgument,
                         "the model has no such face, its faces are Face1 to Face" +
                             std::to_string(model.faces.size()),
                         name,
                         {},
                         "see mesher info for the names of the model"};
        }
        const BrepFaceId face(entity->index);
        if (std::find(faces.begin(), faces.end(), face) != faces.end()) {
            return Error{
                ErrorCode::InvalidArgument, "the face is named twice", name, {}, "name each face once"};
        }
        faces.push_back(face);
    }
    if (!options.faces.empty()) return faces;
    for (std::uint32_t i = 0; i < model.faces.size(); ++i) faces.push_back(BrepFaceId(i));
    if (!faces.empty()) return faces;
    return Error{
        ErrorCode::DegenerateInput, "the model has no faces", "model", {}, "make a face of its edges first"};
}

Result<PlanarCurveComplex> planarModel(const BrepModel& model, const MeshOptions& options)
{
    const Result<std::vector<BrepFaceId>> faces = facesToMesh(model, options);
    if (!faces) return faces.error();
    return planarCurveComplex(model, faces.value());
}

}  // namespace mesher
