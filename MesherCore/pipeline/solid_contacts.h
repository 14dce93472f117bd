#pragma once

#include "base/run_context.h"
#include "base/vec.h"
#include "brep/brep_ids.h"
#include "pipeline/component_surface.h"

#include <optional>

namespace mesher {

/// Two solids of different groups that have a place in common, by the ids of their own models.
struct SolidContact
{
    BrepSolidId first;
    BrepSolidId second;
    Vec3 place;
    bool isOverlap = false;  ///< they have a volume in common, not only a place of their surfaces
};

/// What two groups of solids that share no entity have in common: the first overlap, else the first contact.
/// Guarantees   found are solids that cross, lie in one another or coincide by more than the tolerance where a node, the middle
///              of a facet, or the middle of what an edge of a facet has inside of the other group says so; and contacts at such
///              places, or where surfaces are led to touch by projection from one to the other
/// Terminates   early when the run is to end
/// Cost         a search for each node, facet and edge of one group that lies in the box of the other
/// Units        `tolerance` in model units: what is nearer touches, what is less deep than a hundred of it does not overlap
[[nodiscard]] std::optional<SolidContact> findContact(const ComponentSurface& first,
                                                      const ComponentSurface& second, double tolerance,
                                                      RunContext& context);

}  // namespace mesher
