#pragma once

#include "brep/brep_model.h"

#include <TopoDS_Face.hxx>

#include <memory>
#include <string>

namespace mesher {

/// The kernel's classifier of the face's loops, kept: making one costs microseconds, asking it a tenth of one.
/// `own` is the face with its surface and bounds. Where the kernel gives up, it throws a GeometryFailure about `entity`.
[[nodiscard]] std::shared_ptr<const TrimClassifier> makeTrim(const std::string& entity,
                                                             const TopoDS_Face& face, const BrepFace& own);

}  // namespace mesher
