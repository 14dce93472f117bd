#include "improvement/local_change.h"

namespace mesher {

void apply(const LocalChange& change, TetComplex& complex, BoundaryGeometry& geometry)
{
    for (std::size_t s = 0; s < 2; ++s) {
        if (!change.removed[s].empty()) complex.replaceTets(change.removed[s], change.added[s]);
    }
    if (change.swapsFacets) {
        geometry.commitSwap(change.facets, change.facetNodes);
        complex.replaceFacets(change.facets, change.facetNodes);
    }
    if (change.contracted.isValid()) complex.removeNode(change.contracted);
}

}  // namespace mesher
