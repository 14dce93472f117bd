#pragma once

#include "base/budget.h"
#include "delaunay/constrained_flips3d.h"
#include "delaunay/constrained_tetrahedralization.h"
#include "mesh/surface_splitter.h"
#include "refinement/delaunay_refinement3d.h"
#include "refinement/flat_strips.h"
#include "refinement/kept_fans.h"
#include "refinement/length_scale3d.h"
#include "refinement/refinement_criteria.h"
#include "refinement/small_angle_guard.h"
#include "refinement/thin_walls.h"
#include "refinement/work_ledger3d.h"

namespace mesher {

/// What the steps of one refinement share: the mesh, what is wanted of it, and what was counted.
struct RefinementState3d
{
    RefinementState3d(ConstrainedTetrahedralization& tetrahedralization, SurfaceSplitter& surfaceSplitter,
                      const DelaunayRefinementOptions3d& wanted, RunContext& context)
        : t(tetrahedralization),
          mesh(t.mesh()),
          splitter(surfaceSplitter),
          options(wanted),
          scale(t, options.sizing),
          criteria(mesh, scale, options.quality, options.leastGap * t.scale),
          guard(t, splitter.mesh()),
          fans(t, splitter),
          walls(t),
          strips(t),
          ledger(t, options.allowance),
          flips(*t.delaunay, DelaunayPart::Inside),
          flipBudget({}, context)
    {
    }

    /// A finite tetrahedron of a region.
    [[nodiscard]] bool isMeshed(TetId tet) const
    {
        return mesh.isAlive(tet) && mesh.region(tet) != kExteriorRegion && !mesh.isGhostTet(tet);
    }
    [[nodiscard]] std::array<VertexId, 3> cornersOf(FacetId facet) const
    {
        const auto& node = splitter.mesh().facets[facet].node;
        return {t.vertexOf[node[0]], t.vertexOf[node[1]], t.vertexOf[node[2]]};
    }
    /// In a wall, or across a narrow face, that is kept flat.
    [[nodiscard]] bool isLeftFlat(TetId tet) const { return walls.isInKept(tet) || strips.isAcross(tet); }
    /// What a meshed tetrahedron needs; nothing where it is left flat, at facets of the sizes wanted.
    [[nodiscard]] TetVerdict judge(TetId tet) const
    {
        if (isLeftFlat(tet)) return {};
        TetVerdict verdict = criteria.judge(tet);
        if (verdict.need == TetNeed::HeldBack && isLambdaLifted && !smallAngleNear(tet))
            verdict.need = TetNeed::Quality;
        return verdict;
    }
    /// Whether lambda allows the split of a segment or facet for quality.
    [[nodiscard]] bool maySplit(VertexId a, VertexId b) const
    {
        return criteria.maySplit(a, b) || (isLambdaLifted && !isBesideSmallAngle(std::array{a, b}));
    }
    [[nodiscard]] bool maySplit(const std::array<VertexId, 3>& facet) const
    {
        return criteria.maySplit(facet) || (isLambdaLifted && !isBesideSmallAngle(facet));
    }
    /// From now on lambda holds beside small angles only, where edges could get shorter without an end.
    void liftLambda()
    {
        guard.collectPlaces(splitter.mesh());
        isLambdaLifted = true;
    }
    /// The small angle that a tetrahedron is beside: about as far as refinement for it spreads. Needs SmallAngleGuard::collectPlaces.
    [[nodiscard]] std::optional<SmallInputAngle> smallAngleNear(TetId tet) const;
    /// By the length scale. On walls that are kept flat facets are as long as they may be, whatever is beside the walls.
    [[nodiscard]] bool isTooLarge(const std::array<VertexId, 3>& facet) const
    {
        return criteria.isTooLarge(facet) && !walls.isOnKept(facet) && !strips.isAcross(facet);
    }
    [[nodiscard]] bool isTooLong(VertexId a, VertexId b) const
    {
        return criteria.isTooLong(a, b) && !walls.isOnKept(std::array{a, b});
    }
    [[nodiscard]] EntityRef entityOf(FacetId facet) const
    {
        return {2, splitter.mesh().facets[facet].face.value};
    }
    [[nodiscard]] EntityRef entityOf(SegmentId segment) const
    {
        return {1, splitter.mesh().segments[segment].edge.value};
    }
    /// The facet of a constrained face, or none.
    [[nodiscard]] const FacetId* facetAt(TetFace face) const;
    /// The segment between two vertices, or none.
    [[nodiscard]] const SegmentId* segmentAt(VertexId a, VertexId b) const
    {
        return t.segmentOf.find(unorderedPair(a, b));
    }
    /// Whether the entity has a vertex on a small angle: there the two sides of the angle always encroach upon each other.
    [[nodiscard]] bool isBesideSmallAngle(std::span<const VertexId> entity) const
    {
        return smallAngleBeside(entity) < SmallAngleGuard::kSmallDihedral;
    }

    /// Of a vertex that was made outside of the solids: it has no size, and no part in any wall.
    void addOutside(VertexId v);

    /// The least of these angles, in degrees; 180 without one.
    [[nodiscard]] double smallAngleBeside(std::span<const VertexId> entity) const;

    /// Makes the faces of new tetrahedra Delaunay as far as flips can; returns the tetrahedra of the flips.
    const std::vector<TetId>& flipAround(std::span<const TetId> created);

    ConstrainedTetrahedralization& t;
    Triangulation3d& mesh;
    SurfaceSplitter& splitter;
    const DelaunayRefinementOptions3d& options;
    LengthScale3d scale;
    RefinementCriteria3d criteria;
    SmallAngleGuard guard;
    KeptFans fans;
    ThinWalls walls;
    FlatStrips strips;
    WorkLedger3d ledger;
    ConstrainedFlips3d flips;
    Budget flipBudget;  ///< flips end by themselves: it only lets them be cancelled
    RefinementCounts3d counts;
    bool isLambdaLifted = false;
};

}  // namespace mesher
