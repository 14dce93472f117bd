#pragma once

#include "refinement/boundary_queue3d.h"
#include "refinement/facet_swap3d.h"
#include "refinement/insert_circumcentre.h"
#include "refinement/refinement_state3d.h"

#include <vector>

namespace mesher {

/// Bad tetrahedra that refinement could do nothing for, and what is tried for them at the end, when the mesh around them is good
/// and they are few: their circumcentre, although edges beside an angle that is not very small get shorter; else a point nearer
/// to them; else the split of a facet of their own; else the other diagonal of two facets that they lie on.
/// Terminates   with the tries of the caller: each makes one change at the most
class StubbornTets
{
public:
    StubbornTets(RefinementState3d& state, BoundaryQueue3d& boundary, CircumcentreInsertion& insertion,
                 FacetSwap3d& swap)
        : state_(state), boundary_(boundary), insertion_(insertion), swap_(swap)
    {
    }

    /// Those that there are, ascending; nothing if there are more than that. Cost: linear in the tetrahedra.
    [[nodiscard]] std::vector<TetId> findFew(std::size_t most) const;

    /// Rejected: something of the boundary was queued, try again when it is split. Tetrahedra that were changed without an
    /// insertion are in `changed`.
    Attempt attempt(TetId tet);
    [[nodiscard]] const std::vector<TetId>& changed() const { return changed_; }

private:
    bool pushOwnFacet(TetId tet);

    RefinementState3d& state_;
    BoundaryQueue3d& boundary_;
    CircumcentreInsertion& insertion_;
    FacetSwap3d& swap_;
    std::vector<TetId> changed_;
};

}  // namespace mesher
