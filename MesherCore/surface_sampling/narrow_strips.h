#pragma once

#include "mesh/flat_strip_facet.h"
#include "surface_sampling/sampled_surface.h"
#include "surface_sampling/wall_survey.h"

#include <functional>
#include <vector>

namespace mesher {

/// A face that runs between two of its edges, somewhere, more narrowly than a quarter of the edges that are wanted there: a
/// step, a chamfer, the flank of a letter.
struct SurveyedStrip
{
    BrepFaceId face;
    double width = 0.0;   ///< least, model units
    Vec3 place;           ///< where it is narrowest, model units
    double coarse = 0.0;  ///< length of its segments that are long for its width, model units
    double fine = 0.0;    ///< of the others, model units
    double tets = 0.0;    ///< about as many as good facets there bring about in the solids beside it
    bool isKept = false;  ///< its facets stay as long as the sizes want: good ones would take too many
    double needed = 0.0;  ///< budget that suffices for it and all that are cheaper
    bool isBelowLeastSize = false;  ///< narrower than the least edge that may be asked for
};

/// The faces on which flat facets wait, but for the rims of surveyed walls, which have the wall's own lot. Good facets are as small as
/// the face is narrow, all along it, and what is beside it grows from there: about 80 tetrahedra for each piece of an edge that is as
/// long as the face is wide.
/// Cost   linear in the facets
[[nodiscard]] std::vector<SurveyedStrip> surveyStrips(const SampledSurface& surface,
                                                      const std::vector<SurveyedWall>& walls,
                                                      const WallSurveyOptions& options);

/// As keepDearWalls.
void keepDearStrips(std::vector<SurveyedStrip>& strips, double budget, double leastSize);

/// Keeps those no longer whose edges have become fine, since faces beside them had to be: what is flat there spares nothing. Whether
/// there are any.
bool letFineStripsGo(const SampledSurface& surface, const std::vector<SurveyedWall>& walls,
                     const WallSurveyOptions& options, std::vector<SurveyedStrip>& strips);

/// The faces of those that are kept, ascending.
[[nodiscard]] std::vector<BrepFaceId> facesOfKept(const std::vector<SurveyedStrip>& strips);

/// The facets that were left flat there, ascending, as the surface is now.
[[nodiscard]] std::vector<FlatStripFacet> facetsOnStrips(const SampledSurface& surface);

}  // namespace mesher
