#pragma once

#include "brep/brep_model.h"

#include <TopoDS_Face.hxx>

#include <memory>

namespace mesher {

/// The kernel's classifier of the face's loops, kept: making one costs microseconds, asking it a tenth of one.
[[nodiscard]] std::shared_ptr<const TrimClassifier> makeTrim(const TopoDS_Face& face);

}  // namespace mesher
