#pragma once

#include "mesh/region_sides.h"
#include "sizing/box_tree.h"
#include "surface_sampling/sampled_surface.h"

#include <array>
#include <cstddef>
#include <vector>

namespace mesher {

/// A facet that is coarse for the wall behind it.
struct CoarseWallFacet
{
    BrepFaceId face;
    TriangleId triangle;
    BrepFaceId across;       ///< the other side of the wall
    double thickness = 0.0;  ///< least at the corners, model units
    double longest = 0.0;    ///< of its edges, model units
    double sag = 0.0;        ///< about how far it is from its surface, model units
    double chordSag =
        0.0;  ///< the same by its sides alone, along which the surface may turn less than it does elsewhere
    double area = 0.0;
    RegionId region;
    bool isInWall = false;  ///< the chords of its sides are in the wall, and eat its thickness
};

/// Measures the walls of solids at the vertices of curved faces, on the exact surfaces: facets may be further from these than the
/// wall is thick.
/// Guarantees   a thickness is the distance of a vertex from the exact surface of a face that looks at it across a solid; a facet
///              counts where the wall goes on at its three corners, and is no more than twice as thick at one of them as at
///              another: a wedge or a cusp runs out however fine its facets are
/// Terminates   early when the run is to end: walls are missing then
/// Cost         a tree of the facets, a search in it and a projection for each vertex of a curved face
class WallThickness
{
public:
    WallThickness(const SampledSurface& surface, const RegionSides& sides, RunContext& context);

    /// Facets whose sag is more than `share` of the thickness behind them and whose edges are longer than `leastEdges` times
    /// that, by face and triangle.
    [[nodiscard]] std::vector<CoarseWallFacet> coarseFacets(double share, double leastEdges) const;

    /// What is behind a point on one side of its face.
    struct Wall
    {
        double thickness = 0.0;  ///< 0 for none
        BrepFaceId across;
    };
    /// A point on the exact surface of a face.
    struct Probe
    {
        BrepFaceId face;
        Vec3 position;
        Vec3 normal;  ///< along du x dv
        NodeId node;  ///< invalid inside of facets
    };
    /// What of a solid is behind a point, up to `reach` from it.
    [[nodiscard]] Wall wallBehind(const Probe& probe, std::size_t side, double reach) const;

private:
    [[nodiscard]] std::vector<double> reachesIn(BrepFaceId f, double share, double leastEdges) const;
    void addCoarse(BrepFaceId f, std::size_t side, double share, double leastEdges,
                   std::vector<CoarseWallFacet>& coarse) const;
    [[nodiscard]] std::vector<FacetId> facetsNear(const Vec3& from, const Vec3& to) const;

    const SampledSurface& surface_;
    const RegionSides& sides_;
    RunContext& context_;
    std::vector<FacetId> facets_;
    std::vector<Box3> boxes_;
    BoxTree tree_;
    double largestSize_;  ///< of any wish: the model's diagonal
};

}  // namespace mesher
