#pragma once

#include "mesh/surface_splitter.h"

namespace mesher {

/// A surface mesh without geometry behind it: it proposes no split, and makes those that others propose.
class LinearSplitter final : public SurfaceSplitter
{
public:
    explicit LinearSplitter(SurfaceMesh& mesh) : mesh_(mesh) {}

    [[nodiscard]] const SurfaceMesh& mesh() const override { return mesh_; }
    /// NotFound.
    void evaluateSegment(SegmentId segment, SurfaceSplitExtent extent, SurfaceSplit& split) override;
    void evaluateFacet(FacetId facet, SurfaceSplitExtent extent, SurfaceSplit& split) override;
    [[nodiscard]] bool accepts(const SurfaceSplit& /*split*/) const override { return true; }
    SurfaceSplitResult commit(const SurfaceSplit& split) override;

private:
    SurfaceMesh& mesh_;
};

}  // namespace mesher
