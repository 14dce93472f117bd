#pragma once

#include "base/result.h"
#include "brep/brep_model.h"
#include "brep/planar_curve_complex.h"

#include <span>

namespace mesher {

/// The curve complex of one or several faces in one plane, holes, slits, embedded edges and embedded vertices included.
///
/// Guarantees   points and curves in the order of the model's vertices and edges; region r + 1 is faces[r]; a curve has on
///              each side the region of the face whose material is there; curves meet in points of the complex only
/// Requires     faces that lie in one plane, edges too, within their tolerances, also planes that the file gives as splines;
///              closed wires that run around their material and do not cross themselves; else an Error that names face and
///              edges and the point. An edge may have one face of the list on each side.
[[nodiscard]] Result<PlanarCurveComplex> planarCurveComplex(const BrepModel& model, std::span<const BrepFaceId> faces);

}  // namespace mesher
