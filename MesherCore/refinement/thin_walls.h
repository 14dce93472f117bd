#pragma once

#include "base/id_vector.h"
#include "brep/brep_ids.h"
#include "delaunay/constrained_tetrahedralization.h"
#include "mesh/surface_mesh.h"
#include "mesh/wall_sides.h"

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace mesher {

/// Where two faces of a solid come nearer to each other than a quarter of the edges there.
struct ThinWall
{
    std::array<BrepFaceId, 2> face;  ///< ascending; the same twice where a face comes near to itself
    RegionId region;
    double thickness = 0.0;  ///< least, model units
    double tets = 0.0;       ///< about as many as it takes to fill it with good ones
    double facets = 0.0;     ///< on its sides, at the start
    Vec3 place;              ///< where it is thinnest, model units
    bool isKept =
        false;  ///< flat tetrahedra are left in it: it would take more than the run may spend on walls
    bool isAsked = false;  ///< to be kept, by those who made its surface
};

/// The thin walls of a model, and which of them are kept flat. A Delaunay refinement fills a wall with tetrahedra as large
/// as the wall is thick, however large they are wanted: a plate of 100 x 100 x 0.1 takes millions. Walls are made good as
/// far as a budget goes, the cheapest first; the others keep facets of the size wanted, and tetrahedra as flat as these
/// are wide.
/// Guarantees   what is kept is fixed in space from the start: it neither grows nor shrinks as the mesh is refined beside it
/// Reference    [gosselin] section 4.4, where the local feature size asks for the good ones
class ThinWalls
{
public:
    explicit ThinWalls(const ConstrainedTetrahedralization& tetrahedralization) : t_(tetrahedralization) {}

    /// Finds them in the initial tetrahedralization. Keeps those that have facets in `flat`, which ascend, and of the others those
    /// that `budget` tetrahedra do not suffice for.
    void find(const SurfaceMesh& surface, double budget, std::span<const FlatWallFacet> flat = {});
    [[nodiscard]] const std::vector<ThinWall>& walls() const { return walls_; }

    /// Whether the tetrahedron stays as flat as its wall is thin.
    [[nodiscard]] bool isInKept(TetId tet) const
    {
        return hasKept_ && shareOf(t_.mesh().tet(tet).vertex) > 2.0F && isOnItsSide(tet);
    }
    /// Whether all corners of an entity of the boundary are on kept walls, where it has the size wanted from the start.
    [[nodiscard]] bool isOnKept(std::span<const VertexId> corners) const
    {
        constexpr float kOn = 0.99F;
        return hasKept_ && shareOf(corners) >= kOn * static_cast<float>(corners.size());
    }
    /// Whether an entity of the boundary may be split for quality: `size` is its length, or the diameter of its circle.
    [[nodiscard]] bool maySplit(std::span<const VertexId> corners, double size) const;
    /// The kept wall that the tetrahedron is in or beside, or none.
    [[nodiscard]] const ThinWall* wallBeside(TetId tet) const;

    /// A new vertex on the boundary, among those around it on the surface.
    void assign(VertexId v, std::span<const VertexId> surround) { assign(v, surround, kAnyRegion); }
    /// A new vertex inside of a region, among its neighbours.
    void assign(VertexId v, std::span<const VertexId> neighbours, RegionId region);

private:
    /// Of a vertex.
    struct Mark
    {
        float share = 0.0F;  ///< 1 in a kept wall, 0 outside, between where facets are half in it
        float size = 0.0F;   ///< of the facets at the start
        RegionId region;     ///< kAnyRegion where walls of two regions meet
        std::uint32_t wall = 0;
    };
    static constexpr RegionId kAnyRegion{0xFFFFFFFFu};

    [[nodiscard]] static bool isIn(const Mark& mark, RegionId region)
    {
        return mark.region == region || mark.region == kAnyRegion;
    }
    /// A facet that looks across a wall.
    struct Side
    {
        TetFace face;
        std::uint32_t wall = 0;
    };

    void collectSides(const SurfaceMesh& surface, std::span<const FlatWallFacet> flat);
    void measureSide(TetFace face, const SurfaceMesh& surface);
    bool addFlatSides(TetFace face, std::span<const FlatWallFacet> flat);
    [[nodiscard]] BrepFaceId faceAcross(TetFace face, VertexId apex, const SurfaceMesh& surface) const;
    std::uint32_t wallBetween(BrepFaceId a, BrepFaceId b, RegionId region);
    void choose(double budget);
    void markKept(const SurfaceMesh& surface);
    [[nodiscard]] std::vector<std::uint32_t> countOwnFacets(const std::vector<std::uint32_t>& kept,
                                                            const SurfaceMesh& surface) const;
    [[nodiscard]] bool isOnItsSide(TetId tet) const;
    [[nodiscard]] float shareOf(std::span<const VertexId> corners) const
    {
        float sum = 0.0F;
        for (const VertexId v : corners) sum += v.value < marks_.size() ? marks_[v].share : 0.0F;
        return sum;
    }

    const ConstrainedTetrahedralization& t_;
    std::vector<ThinWall> walls_;
    std::vector<Side> sides_;
    IdVector<VertexId, Mark> marks_;
    bool hasKept_ = false;
};

}  // namespace mesher
