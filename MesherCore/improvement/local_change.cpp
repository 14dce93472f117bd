#include "improvement/local_change.h"

#include <algorithm>

namespace mesher {

void apply(LocalChange& change, TetComplex& complex, BoundaryGeometry& geometry)
{
    if (change.inserted) {
        const std::uint32_t solid = complex.solid(change.removed[0].front());
        const NodeId node = complex.addNode({*change.inserted, {3, solid}, {}});
        for (TetNodes& tet : change.added[0]) std::replace(tet.begin(), tet.end(), NodeId(), node);
    }
    for (std::size_t s = 0; s < 2; ++s) {
        if (!change.removed[s].empty()) complex.replaceTets(change.removed[s], change.added[s]);
    }
    if (change.swapsFacets) {
        geometry.commitSwap(change.facets, change.facetNodes);
        complex.replaceFacets(change.facets, change.facetNodes);
    }
    for (const NodeId node : change.gone) complex.removeNode(node);
}

}  // namespace mesher
