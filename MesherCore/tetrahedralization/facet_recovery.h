#pragma once

#include "delaunay/cavity_retriangulation.h"
#include "tetrahedralization/edge_crossing.h"
#include "tetrahedralization/facet_crossing.h"
#include "tetrahedralization/flip_search.h"
#include "tetrahedralization/segment_recovery.h"
#include "tetrahedralization/surface_constraints.h"

namespace mesher {

enum class FacetMethod : std::uint8_t
{
    Present,
    Flips,
    Cavity,
    Star
};

/// How far a recovery of a facet goes before it gives up.
enum class FacetEffort : std::uint8_t
{
    Cavity,
    Star  ///< may add a vertex
};

/// Recovers a missing facet, whose edges are there, without a change of the surface: by removing the edges that cross it; by
/// filling what is above and what is below it with Delaunay tetrahedra, the cavities growing where their surface is not
/// Delaunay; by an additional vertex that sees a whole cavity. A recovered facet is locked.
/// Reference    [gosselin] §3.3.3 "Facet Recovery", [si2005] for the cavities
class FacetRecovery
{
public:
    FacetRecovery(SurfaceConstraints& constraints, FlipSearch& flips)
        : constraints_(constraints),
          flips_(flips),
          crossings_(std::as_const(constraints).mesh()),
          cavities_(std::as_const(constraints).mesh()),
          replacement_(constraints.mesh())
    {
    }

    RecoveryStatus recover(FacetId facet, int depth, FacetEffort effort);

    /// What the last recovery did it by.
    [[nodiscard]] FacetMethod method() const { return method_; }
    /// Of the last call that did not recover.
    [[nodiscard]] const FacetCrossing& crossing() const { return found_; }
    [[nodiscard]] const RecoveryObstacle& obstacle() const { return obstacle_; }
    [[nodiscard]] std::uint32_t addedVertices() const { return addedVertices_; }

private:
    /// What is on one side of the facet.
    struct Side
    {
        CavityShell shell;
        std::vector<VertexId> insideVertices;
        std::vector<TetCorners> filling;
        Vec3 starPoint;
        bool isStar = false;
    };

    RecoveryStatus findObstacle();
    bool lock();
    bool removeCrossingEdges(int depth);
    bool retriangulate(FacetEffort effort);
    void splitShells();
    bool fill(Side& side, bool& mayGrow);
    bool enlarge(Side& side, const Side& other);
    [[nodiscard]] bool keepsConstraints() const;
    bool fillStar(Side& side);
    void commit();

    SurfaceConstraints& constraints_;
    FlipSearch& flips_;
    FacetCrossings crossings_;
    CavityRetriangulation cavities_;
    TetReplacement3d replacement_;
    std::array<VertexId, 3> facet_;
    FacetCrossing found_;
    FacetCrossing trial_;
    RecoveryObstacle obstacle_;
    FacetMethod method_ = FacetMethod::Present;
    std::uint32_t addedVertices_ = 0;
    std::array<Side, 2> sides_;                      ///< below and above
    std::vector<TetId> tets_;                        ///< those that both cavities are made of
    std::vector<CavityShell::Corners> innerFacets_;  ///< constrained faces between those
};

/// The point where an edge that crosses a facet meets its plane, rounded.
[[nodiscard]] Vec3 facetCrossingPoint(const Triangulation3d& mesh, const std::array<VertexId, 3>& facet,
                                      const std::array<VertexId, 2>& edge);

}  // namespace mesher
