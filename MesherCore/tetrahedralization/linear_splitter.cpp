#include "tetrahedralization/linear_splitter.h"

namespace mesher {

void LinearSplitter::evaluateSegment(SegmentId segment, SurfaceSplitExtent extent, SurfaceSplit& split)
{
    static_cast<void>(segment);
    static_cast<void>(extent);
    split = SurfaceSplit{};
}

void LinearSplitter::evaluateFacet(FacetId facet, SurfaceSplitExtent extent, SurfaceSplit& split)
{
    static_cast<void>(facet);
    static_cast<void>(extent);
    split = SurfaceSplit{};
}

SurfaceSplitResult LinearSplitter::commit(const SurfaceSplit& split)
{
    MESHER_PRECONDITION(split.status == SurfaceSplitStatus::Ready);
    SurfaceSplitResult result;
    result.node = mesh_.nodes.push_back(split.node);
    const auto withNode = [&](NodeId node) { return node.isValid() ? node : result.node; };
    if (split.segment.isValid()) {
        mesh_.segments[split.segment].edge = BrepEdgeId();
        for (unsigned half = 0; half < 2; ++half) {
            SurfaceSegment segment = split.halves[half];
            for (NodeId& node : segment.node) node = withNode(node);
            result.halves[half] = mesh_.segments.push_back(segment);
        }
    }
    for (const FacetId facet : split.removed) mesh_.facets[facet].face = BrepFaceId();
    for (SurfaceFacet facet : split.added) {
        for (NodeId& node : facet.node) node = withNode(node);
        result.added.push_back(mesh_.facets.push_back(facet));
    }
    return result;
}

}  // namespace mesher
