#pragma once

#include "brep/brep_model.h"

#include <string>
#include <vector>

namespace mesher {

/// Moves the edges of some faces that lie off them, as tolerances allow, onto the faces: to where the parameter curves of the file agree
/// that they are, else to where the two faces meet. Faces narrower than the tolerance have loops that do not cross then.
/// For faces that have no mesh else: a place that is on the faces and off the edge of the file may be found on neither by those who
/// measure to trimmed faces.
/// Guarantees   an edge moves by no more than one and a half times its tolerance or the gap that it had, and lies off its faces by less
///              than a tenth of that gap then; vertices stay where they are
/// Returns a clause for each edge that was moved
std::vector<std::string> moveEdgesOntoFaces(BrepModel& model, const std::vector<BrepFaceId>& faces);

}  // namespace mesher
