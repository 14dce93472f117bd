#pragma once

#include "base/assert.h"
#include "mesh/surface_mesh.h"

#include <array>
#include <cstdint>
#include <vector>

namespace mesher {

enum class SurfaceSplitStatus : std::uint8_t
{
    Ready,
    Encroaches,  ///< the new node would lie in the ball of a segment, which is to be split first
    TooSmall,    ///< the parts would be shorter than the floor of the model's tolerance there
    NotFound     ///< no point of the exact surface was found for the facet
};

/// How many facets give way to the star of the new node.
enum class SurfaceSplitExtent : std::uint8_t
{
    Delaunay,  ///< all of the face whose surface ball has the node
    Least      ///< only those that the node lies on or beside: one facet, or the two at an edge
};

/// A change of a surface mesh by one new node, evaluated and not yet made. In `halves` and `added` the new node is an
/// invalid id.
struct SurfaceSplit
{
    SurfaceSplitStatus status = SurfaceSplitStatus::NotFound;
    MeshNode node;
    SegmentId segment;  ///< that gives way to its halves, or the one that is encroached; else invalid
    std::array<SurfaceSegment, 2> halves;
    std::vector<FacetId> removed;
    std::vector<SurfaceFacet> added;
};

/// What a split that was made has put into the mesh, in the order of the split's own lists.
struct SurfaceSplitResult
{
    NodeId node;
    std::array<SegmentId, 2> halves;
    std::vector<FacetId> added;
};

/// Splits curves and facets on the exact geometry for the stages that build volumes, so that these need not know how
/// surfaces are sampled.
/// Guarantees   evaluate changes nothing; commit and swap cannot fail; the mesh keeps the guarantees of SurfaceMesh
/// Threads      one at a time
class SurfaceSplitter
{
public:
    virtual ~SurfaceSplitter() = default;

    [[nodiscard]] virtual const SurfaceMesh& mesh() const = 0;
    /// At the middle of the segment's total variation, or on a shell beside a small angle.
    virtual void evaluateSegment(SegmentId segment, SurfaceSplitExtent extent, SurfaceSplit& split) = 0;
    /// At the centre of the facet's surface ball.
    virtual void evaluateFacet(FacetId facet, SurfaceSplitExtent extent, SurfaceSplit& split) = 0;
    /// Whether commit also takes this split, which the caller has made up at a place of its own: where the geometry is straight
    /// and plane any place is exact.
    [[nodiscard]] virtual bool accepts(const SurfaceSplit& split) const = 0;
    /// Makes a split that is Ready, with nothing changed since it was evaluated, or one that is accepted.
    virtual SurfaceSplitResult commit(const SurfaceSplit& split) = 0;

    /// Whether the facet stays as it is, whatever encroaches upon it: it is never split, and vertices keep away from it.
    [[nodiscard]] virtual bool isHeld(FacetId /*facet*/) const { return false; }

    /// Whether two facets of one face share an edge that is no segment and may become the other diagonal of the two.
    [[nodiscard]] virtual bool maySwap(FacetId /*first*/, FacetId /*second*/) const { return false; }
    /// Puts the other diagonal, and two facets with new ids, in the place of two that may be swapped.
    virtual std::array<FacetId, 2> swap(FacetId first, FacetId second);
};

inline std::array<FacetId, 2> SurfaceSplitter::swap(FacetId /*first*/, FacetId /*second*/)
{
    MESHER_PRECONDITION(false);
    return {};
}

}  // namespace mesher
