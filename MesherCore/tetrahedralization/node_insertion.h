#pragma once

#include "tetrahedralization/tetrahedralize.h"

namespace mesher {

/// Scales the nodes by a power of two, so that the predicates are exact, and inserts them, with the corners of a box around
/// them, so that no constraint lies on the hull, and with scaffold points if they pay.
/// Errors       nodes at one place, coordinates that are not finite
Result<void> insertNodes(const SurfaceMesh& surface, const TetrahedralizationOptions& options,
                         RunContext& context, Tetrahedralization& result);

/// The class of a vertex at a node.
[[nodiscard]] VertexClass vertexClassOf(const MeshNode& node);

}  // namespace mesher
