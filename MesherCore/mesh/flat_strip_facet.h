#pragma once

#include "brep/brep_ids.h"
#include "mesh/surface_mesh.h"

namespace mesher {

/// A facet across a narrow face that is kept flat: as long as the sizes want, and as narrow as the face.
struct FlatStripFacet
{
    FacetId facet;
    BrepFaceId face;
};

}  // namespace mesher
