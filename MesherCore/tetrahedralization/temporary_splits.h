#pragma once

#include "mesh/surface_splitter.h"
#include "tetrahedralization/linear_splitter.h"

#include <vector>

namespace mesher {

/// A copy of a surface mesh that recovery may split wherever it helps, whatever the geometry is: such splits are to be taken
/// back, the last one first, once all constraints are there.
/// Guarantees   with all splits taken back, and before the first one, ids and facets are those of the original; ids are
///              never used twice
class TemporarySplits final : public SurfaceSplitter
{
public:
    struct Made
    {
        SurfaceSplit split;
        SurfaceSplitResult result;
        std::vector<BrepFaceId> faces{};  ///< of the facets that were removed
        bool isTakenBack = false;
    };

    explicit TemporarySplits(const SurfaceMesh& original) : mesh_(original), linear_(mesh_) {}

    [[nodiscard]] const SurfaceMesh& mesh() const override { return mesh_; }
    /// NotFound.
    void evaluateSegment(SegmentId segment, SurfaceSplitExtent extent, SurfaceSplit& split) override;
    void evaluateFacet(FacetId facet, SurfaceSplitExtent extent, SurfaceSplit& split) override;
    [[nodiscard]] bool accepts(const SurfaceSplit& /*split*/) const override { return true; }
    SurfaceSplitResult commit(const SurfaceSplit& split) override;

    /// In the order in which they were made.
    [[nodiscard]] const std::vector<Made>& made() const { return made_; }
    /// Whether none of what it added was split in its turn, by a split that is still there.
    [[nodiscard]] bool mayTakeBack(std::size_t index) const;
    void takeBack(std::size_t index);

private:
    SurfaceMesh mesh_;
    LinearSplitter linear_;
    std::vector<Made> made_;
};

}  // namespace mesher
