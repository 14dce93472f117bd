#include "tetrahedralization/temporary_splits.h"

#include "base/assert.h"

#include <algorithm>

namespace mesher {

void TemporarySplits::evaluateSegment(SegmentId segment, SurfaceSplitExtent extent, SurfaceSplit& split)
{
    linear_.evaluateSegment(segment, extent, split);
}

void TemporarySplits::evaluateFacet(FacetId facet, SurfaceSplitExtent extent, SurfaceSplit& split)
{
    linear_.evaluateFacet(facet, extent, split);
}

SurfaceSplitResult TemporarySplits::commit(const SurfaceSplit& split)
{
    Made made;
    made.split = split;
    // Facets that are removed lose their face, and get it back from here.
    for (const FacetId facet : split.removed) made.faces.push_back(mesh_.facets[facet].face);
    made.result = linear_.commit(split);
    made_.push_back(made);
    return made.result;
}

bool TemporarySplits::mayTakeBack(std::size_t index) const
{
    const Made& made = made_[index];
    const auto isFacetAlive = [&](FacetId facet) { return mesh_.facets[facet].isAlive(); };
    if (!std::all_of(made.result.added.begin(), made.result.added.end(), isFacetAlive)) return false;
    if (!made.split.segment.isValid()) return true;
    return std::all_of(made.result.halves.begin(), made.result.halves.end(),
                       [&](SegmentId half) { return mesh_.segments[half].isAlive(); });
}

void TemporarySplits::takeBack(std::size_t index)
{
    MESHER_PRECONDITION(!made_[index].isTakenBack && mayTakeBack(index));
    Made& made = made_[index];
    made.isTakenBack = true;
    for (const FacetId facet : made.result.added) mesh_.facets[facet].face = BrepFaceId();
    for (std::size_t i = 0; i < made.split.removed.size(); ++i)
        mesh_.facets[made.split.removed[i]].face = made.faces[i];
    if (!made.split.segment.isValid()) return;
    const BrepEdgeId edge = mesh_.segments[made.result.halves[0]].edge;
    for (const SegmentId half : made.result.halves) mesh_.segments[half].edge = BrepEdgeId();
    mesh_.segments[made.split.segment].edge = edge;
}

}  // namespace mesher
