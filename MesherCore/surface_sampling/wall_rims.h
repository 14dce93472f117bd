#pragma once

#include "base/id_vector.h"
#include "brep/brep_ids.h"
#include "mesh/region_sides.h"
#include "mesh/wall_sides.h"

#include <vector>

namespace mesher {

class SampledFaces;

/// Where a face may be the rim of a wall: between two of its edges beyond which faces look at each other across a solid, as the
/// top and the bottom of a plate do across its sides. A facet there that is as long as the sizes want and as narrow as the rim
/// is left as it is until it is known what becomes of the wall: good facets on a rim are as small as the wall is thick, and so
/// are the tetrahedra beside them.
/// Guarantees   steps, chamfers and ribs are none: the faces beside them look away from each other
/// Threads      its questions may be asked from several threads at once
class WallRims
{
public:
    /// From the first meshes, before they are refined.
    WallRims(const SampledFaces& faces, RegionSides sides);

    /// Whether flat facets of the face between its two edges are left for now.
    [[nodiscard]] bool isBetween(BrepFaceId face, BrepEdgeId a, BrepEdgeId b) const;
    /// The walls of which such facets are rims.
    [[nodiscard]] std::vector<WallSides> wallsBetween(BrepFaceId face, BrepEdgeId a, BrepEdgeId b) const;
    /// From now on facets are left on the rims of these walls alone; ascending.
    void keep(std::vector<WallSides> walls);

private:
    /// A face beside an edge, with its normals at the edge, into the solids on its two sides.
    struct Beside
    {
        BrepFaceId face;
        std::vector<Vec3> normals;  ///< along du x dv
    };

    template <class Visit>
    void forEachWall(BrepFaceId face, BrepEdgeId a, BrepEdgeId b, Visit visit) const;
    [[nodiscard]] bool doFaceEachOther(const Beside& first, const Beside& second, RegionId region) const;
    void collect(const SampledFaces& faces, BrepFaceId f);

    RegionSides sides_;
    IdVector<BrepEdgeId, std::vector<Beside>> beside_;
    std::vector<WallSides> kept_;
    bool isDecided_ = false;
};

}  // namespace mesher
