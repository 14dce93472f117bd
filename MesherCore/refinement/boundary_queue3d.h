#pragma once

#include "base/bucket_queue.h"
#include "refinement/bad_tet_queue.h"
#include "refinement/boundary_split3d.h"
#include "refinement/narrow_gaps.h"
#include "refinement/refinement_state3d.h"

#include <optional>
#include <vector>

namespace mesher {

/// The segments and facets that wait for their split: too large, or encroached. Segments come before facets, the largest
/// first. What may not or cannot be split is refused for good.
/// Terminates   each entity is split or refused, once between two calls of forgetRefusals
/// Reference    [gosselin] sections 4.3 and 4.7.2
class BoundaryQueue3d
{
public:
    BoundaryQueue3d(RefinementState3d& state, BadTetQueue& badTets);

    /// All segments that are too long or encroached.
    void pushSegments();
    /// All facets that are too large, and what the vertices opposite of facets encroach upon.
    void pushFacets();
    /// False if it can never be split: whether it waits for its split now.
    bool pushSegment(SegmentId segment);
    bool pushFacet(FacetId facet);
    bool pushFacetAt(TetFace face);
    /// What the vertices of a tetrahedron encroach upon.
    void pushEncroachedAt(TetId tet);

    [[nodiscard]] bool isEmpty() const { return segments_.empty() && facets_.empty(); }
    [[nodiscard]] std::size_t size() const { return segments_.size() + facets_.size(); }
    /// Splits or refuses the next one.
    void serveNext();
    /// What was refused may be tried once more, now that more is allowed.
    void forgetRefusals();

    /// Beside which segments were split for their length alone.
    [[nodiscard]] const std::vector<NarrowGap>& narrowGaps() const { return gaps_.gaps(); }
    [[nodiscard]] const BoundarySplitCounts& splitCounts() const { return splitter_.counts(); }

private:
    [[nodiscard]] std::optional<ProtectingBall> ballOf(FacetId facet) const;
    [[nodiscard]] bool isTooLong(SegmentId segment) const;
    [[nodiscard]] double floor() const { return state_.options.floor * state_.t.scale; }
    void serveSegment();
    void serveFacet();
    bool trySplit(FacetId facet);
    bool splitLongestSide(FacetId facet);
    [[nodiscard]] FacetId facetBehind(FacetId facet, VertexId from, VertexId to);
    void pushNew(std::span<const TetId> created);
    void finishSplit(const BoundarySplit3d& split);
    [[nodiscard]] double ceilingAt(const BoundarySplit3d& split) const;

    RefinementState3d& state_;
    BadTetQueue& badTets_;
    BoundarySplitter3d splitter_;
    NarrowGaps gaps_;
    BucketQueue<SegmentId> segments_;
    BucketQueue<FacetId> facets_;
    std::vector<char> refusedSegments_;
    std::vector<char> refusedFacets_;
    std::vector<char> deferredFacets_;  ///< that have waited for a neighbour
    std::vector<TetId> ring_;
};

}  // namespace mesher
