#pragma once

#include "base/ids.h"

#include <string>

namespace mesher {

/// Entities of a B-rep model, counted from 0 in the order of TopExp::MapShapes over the whole shape; people and files
/// see them counted from 1: BrepFaceId(5) is Face6.
using BrepVertexId = Id<struct BrepVertexTag>;
using BrepEdgeId = Id<struct BrepEdgeTag>;
using BrepFaceId = Id<struct BrepFaceTag>;
using BrepSolidId = Id<struct BrepSolidTag>;

/// "Vertex1", "Edge3", "Face6", "Solid1".
[[nodiscard]] std::string nameOf(BrepVertexId id);
[[nodiscard]] std::string nameOf(BrepEdgeId id);
[[nodiscard]] std::string nameOf(BrepFaceId id);
[[nodiscard]] std::string nameOf(BrepSolidId id);

}  // namespace mesher
