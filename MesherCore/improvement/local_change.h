#pragma once

#include "improvement/boundary_geometry.h"
#include "improvement/tet_complex.h"

#include <array>
#include <optional>
#include <vector>

namespace mesher {

/// A change of the connectivity that was evaluated and found valid and better; nothing is changed until it is applied.
struct LocalChange
{
    /// Least score of the tetrahedra that come and of those that go: it is more.
    double score = 0.0;
    double before = 0.0;
    /// One list for each solid that takes part; a swap on a face between solids has two.
    std::array<std::vector<TetId>, 2> removed;
    std::array<std::vector<TetNodes>, 2> added;
    bool swapsFacets = false;
    std::array<FacetId, 2> facets;
    std::array<FacetNodes, 2> facetNodes;
    std::vector<NodeId> gone;  ///< nodes that no tetrahedron has afterwards
    /// Where a node comes; it is an invalid id in the tetrahedra.
    std::optional<Vec3> inserted;

    void clear()
    {
        for (auto& list : removed) list.clear();
        for (auto& list : added) list.clear();
        swapsFacets = false;
        gone.clear();
        inserted.reset();
        score = before = 0.0;
    }
};

/// What the least score has to exceed: by more than rounding, or two changes could undo each other for ever.
[[nodiscard]] constexpr double leastBetter(double before) { return 1.001 * before; }

/// Applies a change that was evaluated on the complex as it is.
void apply(LocalChange& change, TetComplex& complex, BoundaryGeometry& geometry);

}  // namespace mesher
