#include "pipeline/stage_counts.h"

#include <cstdint>

namespace mesher {

namespace {

void add(MeshReport& report, const char* name, std::uint64_t count)
{
    report.counts.emplace_back(name, count);
}

}  // namespace

void tellCounts(const SurfaceSamplingCounts& counts, MeshReport& report)
{
    add(report, "curve_vertices", counts.curveNodes);
    add(report, "initial_surface_vertices", counts.initialVertices);
    add(report, "initial_facets_left_alone", counts.initialLeftAlone);
    add(report, "tips_without_ring", counts.openTips);
    add(report, "fan_facets_released", counts.refinement.releasedFans);
    add(report, "sample_vertices", counts.vertices);
    add(report, "sample_facets", counts.facets);
    add(report, "sample_segments", counts.segments);
    const FacetSplitCounts& splits = counts.refinement.splits;
    add(report, "projected_centres", splits.projectedCentres);
    add(report, "halved_facet_edges", splits.splitEdges);
    add(report, "folded_stars", splits.foldedStars);
    add(report, "steep_stars", splits.steepStars);
    add(report, "forced_stars", counts.refinement.forcedStars);
    add(report, "flat_walls", keptOf(counts.surveyedWalls).size());
    add(report, "rim_facets_left", counts.refinement.leftOnRims);
    add(report, "flat_strips", facesOfKept(counts.surveyedStrips).size());
    add(report, "strip_facets_left", counts.refinement.leftOnStrips);
    add(report, "wall_facet_splits", counts.walls.facetsSplit);
}

void tellCounts(const TetrahedralizationCounts& counts, MeshReport& report)
{
    add(report, "missing_edges", counts.missingEdges);
    add(report, "missing_facets", counts.missingFacets);
    add(report, "recovery_splits", counts.exactSplits);
    add(report, "recovery_vertices", counts.edgeSteiner + counts.facetSteiner + counts.freeVerticesLeft);
    add(report, "scaffold_vertices", counts.scaffoldPoints);
    add(report, "non_delaunay_faces", counts.nonDelaunayFaces);
}

void tellCounts(const RefinedVolume& refined, MeshReport& report)
{
    const RefinementCounts3d& counts = refined.counts;
    add(report, "sink_insertions", counts.sinkInsertions);
    add(report, "size_insertions", counts.sizeInsertions);
    add(report, "quality_insertions", counts.qualityInsertions);
    add(report, "segment_splits", counts.segmentSplits);
    add(report, "facet_splits", counts.facetSplits);
    add(report, "cavity_repairs", counts.cavityRepairs);
    add(report, "short_insertions", counts.shortInsertions);
    add(report, "aborted_insertions", counts.abortedInsertions);
    add(report, "refused_segments", counts.refusedSegments);
    add(report, "refused_facets", counts.refusedFacets);
    add(report, "blocked_cavities", counts.boundary.blockedCavities);
    add(report, "cut_cavities", counts.boundary.cutCavities);
    add(report, "least_splits", counts.boundary.leastExtents);
    add(report, "delaunay_flips", counts.delaunayFlips);
    add(report, "delaunay_cavities", counts.delaunayCavities);
    add(report, "facet_swaps", counts.facetSwaps);
    add(report, "bent_facet_swaps", counts.bentSwaps);
    add(report, "stubborn_tets", counts.stubbornTets);
    add(report, "tets_held_back", counts.heldBackTets);
    add(report, "lifted_insertions", counts.liftedInsertions);
    add(report, "outside_vertices", counts.outsideVertices);
    add(report, "non_delaunay_faces_left", counts.nonDelaunayFaces);
    add(report, "refinement_cut_short", refined.hasStalled ? 1 : 0);
    add(report, "quality_out_of_reach", refined.unreachable ? 1 : 0);
    add(report, "tets_left", refined.left.size());
    add(report, "tets_left_beside_small_angles", refined.leftForSmallAngles);
}

void tellCounts(const ImprovementCounts& counts, MeshReport& report)
{
    add(report, "bad_tets_before_improvement", counts.badBefore);
    add(report, "bad_tets_after_improvement", counts.badAfter);
    add(report, "edge_removals", counts.edgeRemovals);
    add(report, "face_removals", counts.faceRemovals);
    add(report, "boundary_swaps", counts.boundarySwaps);
    add(report, "contractions", counts.contractions);
    add(report, "improvement_insertions", counts.insertions);
    add(report, "inner_moves", counts.innerMoves);
    add(report, "face_moves", counts.faceMoves);
    add(report, "edge_moves", counts.edgeMoves);
    add(report, "tets_improved_with_surroundings", counts.surroundings);
}

}  // namespace mesher
