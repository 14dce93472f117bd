#pragma once

#include "brep/brep_model.h"

namespace mesher {

/// Makes solids of the faces of no solid that bound a volume together, and shells of the others: files of surfaces, and some of
/// solids, have closed shells that nobody says are solids.
/// Guarantees   faces of a new solid look outward; a closed shell inside of another is a void of it, one inside of that a solid again.
///              Notes name the faces. Faces that bound no volume, or where three and more meet in an edge, stay in open shells.
/// Cost         integrals over the faces of closed shells
void closeShells(BrepModel& model);

}  // namespace mesher
