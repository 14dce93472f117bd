#include "refinement/left_places3d.h"

#include "quality/tet_measures.h"

#include <algorithm>
#include <map>
#include <utility>

namespace mesher {

namespace {

LeftPlace3d placeOf(const LeftTet3d& tet)
{
    LeftPlace3d place;
    place.reason = tet.reason;
    place.entity = {tet.entity, tet.other, {}};
    if (tet.angle) {
        place.entity = {tet.angle->entity, tet.angle->side[0], tet.angle->side[1]};
        place.degrees = tet.angle->degrees;
    }
    return place;
}

void addTo(LeftPlace3d& place, const ConstrainedTetrahedralization& t, TetId tet)
{
    std::array<Vec3, 4> corner;
    for (unsigned i = 0; i < 4; ++i) corner[i] = t.mesh().position(t.mesh().tet(tet).vertex[i]);
    ++place.count;
    for (const double angle : dihedralAngles(corner)) {
        place.largestDihedral = std::max(place.largestDihedral, angle);
        if (angle >= place.leastDihedral) continue;
        place.leastDihedral = angle;
        place.worst = (0.25 / t.scale) * ((corner[0] + corner[1]) + (corner[2] + corner[3]));
    }
}

}  // namespace

std::vector<LeftPlace3d> groupLeftTets(const ConstrainedTetrahedralization& tetrahedralization,
                                       std::span<const LeftTet3d> left)
{
    std::map<std::pair<LeftReason3d, std::array<EntityRef, 3>>, LeftPlace3d> places;
    for (const LeftTet3d& tet : left) {
        const LeftPlace3d place = placeOf(tet);
        addTo(places.emplace(std::pair(place.reason, place.entity), place).first->second, tetrahedralization,
              tet.tet);
    }
    std::vector<LeftPlace3d> sorted;
    for (const auto& [key, place] : places) sorted.push_back(place);
    std::stable_sort(sorted.begin(), sorted.end(),
                     [](const LeftPlace3d& a, const LeftPlace3d& b) { return a.count > b.count; });
    return sorted;
}

}  // namespace mesher
