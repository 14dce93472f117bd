#pragma once

#include "base/result.h"
#include "brep/analytic/axes.h"
#include "brep/brep_model.h"

namespace mesher {

/// Exact solids made without a CAD kernel, for tests and examples. Entities are numbered as said with each; sizes must be
/// positive and finite, else an Error of code InvalidArgument.

/// Faces xmin, xmax, ymin, ymax, zmin, zmax.
[[nodiscard]] Result<BrepModel> makeBox(const Vec3& low, const Vec3& high);
/// Faces: side, bottom, top; edges: bottom, seam, top.
[[nodiscard]] Result<BrepModel> makeCylinder(const Axes& axes, double radius, double height);
/// A cone that ends in a point if the top radius is zero. Faces: side, bottom, top if there is one; edges: bottom, seam, top.
[[nodiscard]] Result<BrepModel> makeCone(const Axes& axes, double bottomRadius, double topRadius, double height);
/// One face; edges: south pole, seam, north pole.
[[nodiscard]] Result<BrepModel> makeSphere(const Axes& axes, double radius);
/// One face; edges: along the ring, around the tube.
[[nodiscard]] Result<BrepModel> makeTorus(const Axes& axes, double ringRadius, double tubeRadius);

}  // namespace mesher
