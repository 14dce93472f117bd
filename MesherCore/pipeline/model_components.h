#pragma once

#include "brep/brep_model.h"
#include "mesh/classified_mesh.h"

#include <string>
#include <vector>

namespace mesher {

/// A part of a model as a model of its own, and what its entities are called in the whole.
struct ModelComponent
{
    BrepModel model;
    IdVector<BrepVertexId, BrepVertexId> vertexOf;
    IdVector<BrepEdgeId, BrepEdgeId> edgeOf;
    IdVector<BrepFaceId, BrepFaceId> faceOf;
    IdVector<BrepSolidId, BrepSolidId> solidOf;
    /// Vertices and edges of the whole that others stand for, see brep/model_welding.h; one clause each.
    std::vector<std::string> notes;

    /// The entity of the whole model that one of the component's is.
    [[nodiscard]] EntityRef inWhole(EntityRef entity) const;
    /// "Face3" of the component as it is called in the whole; other words stay.
    [[nodiscard]] std::string inWhole(const std::string& text) const;
};

/// The solids of a model, in groups that share no face, edge or vertex: such groups have nothing in common that a mesh would
/// have to keep, whether they touch or not. Within a group, vertices and edges at one place are made one. In the order of their first solids. Faces of no solid are in no component.
[[nodiscard]] std::vector<ModelComponent> solidComponents(const BrepModel& model);

/// One solid, or faces with their edges, whatever else shares them.
[[nodiscard]] ModelComponent solidAlone(const BrepModel& model, BrepSolidId solid);
[[nodiscard]] ModelComponent facesAlone(const BrepModel& model, std::vector<BrepFaceId> faces);

/// Appends the mesh of a component to that of the whole.
void appendComponent(const ModelComponent& component, const ClassifiedMesh& part, ClassifiedMesh& whole);

}  // namespace mesher
