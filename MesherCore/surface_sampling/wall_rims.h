#pragma once

#include "base/id_vector.h"
#include "brep/brep_ids.h"
#include "mesh/region_sides.h"
#include "mesh/wall_sides.h"

#include <vector>

namespace mesher {

class SampledFaces;

/// Where a face is narrow between two of its edges. That may be the rim of a wall, if the faces beyond these edges look at each other
/// across a solid, as the top and the bottom of a plate do across its sides; else it is a strip: a step, a chamfer, the flank of a rib.
/// A facet there that is as long as the sizes want and as narrow as the face is left as it is until it is known what becomes
/// of the wall or the strip: good facets are as small as it is narrow, and so are the tetrahedra beside them.
/// Threads      its questions may be asked from several threads at once
class WallRims
{
public:
    /// From the first meshes, before they are refined.
    WallRims(const SampledFaces& faces, RegionSides sides);

    /// Whether flat facets of the face between its two edges are left for now, since they may be on the rim of a wall.
    [[nodiscard]] bool isBetween(BrepFaceId face, BrepEdgeId a, BrepEdgeId b) const;
    /// The same where these edges run side by side, since the face may be a strip there; not at the end of a gap, where the faces beside
    /// it look at each other across what is outside of the solids.
    [[nodiscard]] bool isStrip(BrepFaceId face, BrepEdgeId a, BrepEdgeId b) const;
    [[nodiscard]] bool isDecided() const { return isDecided_; }
    /// The walls of which such facets are rims.
    [[nodiscard]] std::vector<WallSides> wallsBetween(BrepFaceId face, BrepEdgeId a, BrepEdgeId b) const;
    /// From now on facets are left on the rims of these walls alone, and on strips of these faces but for the rims of walls that are
    /// made good; all ascending.
    void keep(std::vector<WallSides> walls, std::vector<WallSides> goodWalls, std::vector<BrepFaceId> strips);

private:
    /// A face beside an edge, with its normals at the edge, into the solids on its two sides.
    struct Beside
    {
        BrepFaceId face;
        std::vector<Vec3> normals;  ///< along du x dv
    };

    template <class Visit>
    void forEachWall(BrepFaceId face, BrepEdgeId a, BrepEdgeId b, const std::vector<WallSides>* among,
                     Visit visit) const;
    /// Whether the faces beside it look at each other, or away from each other, across what is outside of the solids.
    [[nodiscard]] bool isEndOfGap(BrepFaceId face, BrepEdgeId a, BrepEdgeId b) const;
    [[nodiscard]] bool doFaceEachOther(const Beside& first, const Beside& second, RegionId region) const;
    void collect(const SampledFaces& faces, BrepFaceId f);

    RegionSides sides_;
    IdVector<BrepEdgeId, std::vector<Beside>> beside_;
    std::vector<WallSides> kept_;
    std::vector<WallSides> good_;
    std::vector<BrepFaceId> strips_;
    bool isDecided_ = false;
};

}  // namespace mesher
