#pragma once

#include "delaunay/cavity_retriangulation.h"
#include "tetrahedralization/surface_constraints.h"
#include "tetrahedralization/temporary_splits.h"

#include <array>
#include <vector>

namespace mesher {

/// Takes the vertex of a temporary split off the surface, so that the facets and the segment that it had split are there in
/// one piece. The surface parts the tetrahedra at the vertex into sectors: two at a facet, one between each two facets at an
/// edge. The vertex sees all the surface of a sector from its place in the plane of the facets, so a point a little inside of
/// the sector sees that as well as the whole facets. Each sector is filled with the Delaunay tetrahedra of its vertices, or
/// those at one vertex that sees all of it, or those at such a new point: so any surface that does not intersect itself is
/// recovered without a vertex more on it. Where rounded coordinates leave no such point, the sector takes in the tetrahedra
/// behind the faces that are not seen.
/// Reference    [george2003] moves vertices off the surface into the volume; sectors with their own points are in [si2015]
class SurfaceVertexLift
{
public:
    explicit SurfaceVertexLift(SurfaceConstraints& constraints)
        : constraints_(constraints),
          cavities_(std::as_const(constraints).mesh()),
          replacement_(constraints.mesh())
    {
    }

    /// Changes tetrahedra and their flags; the caller has to update the maps. False, with nothing changed, if a sector
    /// cannot be filled in coordinates of finite precision.
    /// Requires  the facets that the split added as constrained faces
    bool lift(const TemporarySplits::Made& made);

    [[nodiscard]] std::uint32_t addedVertices() const { return addedVertices_; }
    /// Of the vertex of the last call that was in vain: neighbours that are no nodes of the surface and no ghosts.
    [[nodiscard]] std::vector<VertexId> freeNeighbours() const;

private:
    struct Sector
    {
        CavityShell shell;
        Vec3 inwards;                          ///< sum of the unit normals of its facets
        std::vector<VertexId> insideVertices;  ///< after it was enlarged
        std::vector<TetCorners> filling;
        Vec3 starPoint;
        bool isStar = false;
    };

    bool partStar(const TemporarySplits::Made& made);
    void spreadSector(std::size_t first, int sector);
    bool addFacets(const TemporarySplits::Made& made);
    bool addFacet(const std::array<VertexId, 3>& facet, const std::array<VertexId, 3>& part);
    [[nodiscard]] int sectorAt(TetId tet) const;
    bool fill(Sector& sector);
    bool fillAsItIs(Sector& sector);
    void listBlocking(const Sector& sector);
    bool enlarge(Sector& sector);
    bool takeIn(Sector& sector, TetFace outer);
    bool fillFromCorner(Sector& sector) const;
    bool findStarPoint(Sector& sector) const;
    [[nodiscard]] bool seesAll(const Sector& sector, const Vec3& point) const;
    void commit(const TemporarySplits::Made& made);

    SurfaceConstraints& constraints_;
    CavityRetriangulation cavities_;
    TetReplacement3d replacement_;
    VertexId vertex_;
    std::vector<TetId> star_;
    std::vector<int> sectorOf_;  ///< by place in the star
    std::vector<TetId> tets_;    ///< the star and those that sectors took in
    std::vector<Sector> sectors_;
    std::vector<TetId> queue_;
    std::vector<TetFace> blocking_;
    std::uint32_t addedVertices_ = 0;
};

}  // namespace mesher
