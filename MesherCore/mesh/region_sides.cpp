#include "mesh/region_sides.h"

#include <cstddef>

namespace mesher {

Result<RegionSides> regionSidesOf(const BrepModel& model)
{
    RegionSides sides(model.faces.size(), {RegionId(0u), RegionId(0u)});
    for (std::uint32_t i = 0; i < model.solids.size(); ++i) {
        const RegionId region(i + 1);
        for (const BrepShell& shell : model.solids[BrepSolidId(i)].shells) {
            for (const BrepShellFace& use : shell.faces) {
                // The outward normal is du x dv unless reversed, so the solid lies behind.
                RegionId& side = sides[use.face][use.isReversed ? 0 : 1];
                if (side != RegionId(0u) && side != region) {
                    return Error{ErrorCode::InvalidArgument,
                                 nameOf(BrepSolidId(side.value - 1)) + " and " + nameOf(BrepSolidId(i)) +
                                     " lie on the same side of the face",
                                 nameOf(use.face),
                                 {},
                                 "repair the orientation of the solids, or fuse those that overlap"};
                }
                side = region;
            }
        }
    }
    return sides;
}

}  // namespace mesher
