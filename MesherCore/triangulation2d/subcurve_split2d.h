#pragma once

#include "triangulation2d/planar_triangulation.h"

#include <cstddef>
#include <vector>

namespace mesher {

enum class SplitOutcome2d
{
    Split,
    Blocked,  ///< another subcurve has to be split first, or edges would cross
    Refused   ///< too short, or its new vertex would fall on one that is there: nothing was changed
};

struct SubcurveSplit2d
{
    SplitOutcome2d outcome = SplitOutcome2d::Refused;
    SubcurveId blocker;
    Boundary::Halves halves;
    std::size_t removedVertices = 0;
};

struct SubcurveSplitCounters2d
{
    std::size_t splits = 0;
    std::size_t removedVertices = 0;
    std::size_t blocked = 0;
    /// Those where an unmeshed region lies between, as in Fig. 2.12.
    std::size_t blockedAcrossUnmeshed = 0;
    /// New vertices outside of all circles of the meshed side, as in Fig. 2.11.
    std::size_t outsideCircles = 0;
    /// New edges that had to be recovered by flips, and regions flooded anew for it.
    std::size_t recoveredEdges = 0;
};

/// Splits subcurves of a refined triangulation: deletes the free vertices in the diametral circle of the edge, inserts the
/// curve's point, and replaces the edge by the two new ones.
/// Guarantees   the triangulation stays constrained Delaunay, and each triangle keeps to the region of its side of the
///              curves; if a new edge would cross another one nothing is changed and that one is named
/// Cost         that of the deletions and one insertion
/// Reference    thesis sections 2.3 and 2.4.4, Figs. 2.5, 2.10 and 2.11. Because unmeshed triangles are kept, the walk also
///              sees what lies across a hole, which prevents the intersections of Fig. 2.12
class SubcurveSplitter2d
{
public:
    SubcurveSplitter2d(const PlanarDomain& domain, PlanarTriangulation& triangulation)
        : domain_(domain), t_(triangulation)
    {
    }

    SubcurveSplit2d split(SubcurveId s);

    /// Vertices around which triangles may have changed in the last split, the new vertex apart; some may be gone.
    [[nodiscard]] const std::vector<VertexId>& touchedVertices() const { return touched_; }
    [[nodiscard]] const SubcurveSplitCounters2d& counters() const { return counters_; }

private:
    /// The first boundary edge that reaches into the triangle of an edge and the new point; invalid if none does.
    [[nodiscard]] EdgeLink findBlocker(EdgeLink edge, Vec2 point);
    std::size_t removeFreeVertices(EdgeLink edge, Vec2 point);
    void collectFreeVertices(EdgeLink side, Vec2 point);
    [[nodiscard]] VertexId insertPoint(Vec2 point, TriangleId hint);
    void connectHalf(VertexId from, VertexId to, bool& wasFlipped);
    void restoreRegions(SubcurveId s, VertexId middle, bool isWide);

    const PlanarDomain& domain_;
    PlanarTriangulation& t_;
    SubcurveSplitCounters2d counters_;
    std::vector<VertexId> touched_;
    std::vector<VertexId> doomed_;
    std::vector<EdgeLink> stack_;
    Cavity2d cavity_;
};

}  // namespace mesher
