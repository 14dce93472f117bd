#include "brep/brep_ids.h"

namespace mesher {

namespace {

std::string counted(const char* kind, std::uint32_t index) { return kind + std::to_string(index + 1); }

}  // namespace

std::string nameOf(BrepVertexId id) { return counted("Vertex", id.value); }

std::string nameOf(BrepEdgeId id) { return counted("Edge", id.value); }

std::string nameOf(BrepFaceId id) { return counted("Face", id.value); }

std::string nameOf(BrepSolidId id) { return counted("Solid", id.value); }

}  // namespace mesher
