#pragma once

#include "sizing/sizing_field.h"
#include "triangulation2d/planar_triangulation.h"

namespace mesher {

/// How large triangles are to be.
struct PlanarSizing
{
    /// Triangles grow with the local feature size. If false and without a user's field, only quality refines.
    bool usesLocalFeatureSize = true;
    double refinement = 1.0;  ///< R >= 1: the length scale at the boundary is lfs / R
    double grading = 1.0;     ///< G > 0: length scales grow by at most distance / G
    /// Edge length wanted by the user, or none; must outlive the run.
    const SizingField* field = nullptr;

    [[nodiscard]] bool isActive() const { return usesLocalFeatureSize || field != nullptr; }
};

/// Local feature size at a boundary vertex of the initial triangulation: the shortest edge at it, or the distance to a
/// subcurve opposite of it. Only meshed triangles count; infinite if there are none.
/// Reference    thesis Definition 2.2 and section 2.4.3
[[nodiscard]] double localFeatureSize(const PlanarDomain& domain, const PlanarTriangulation& triangulation, VertexId v);

/// The user's wish at a place, in units of the triangulation; infinite without a field.
[[nodiscard]] double wantedSize(const PlanarDomain& domain, const PlanarSizing& sizing, Vec2 position);

/// Sets the length scale of every vertex of the initial triangulation: lfs / R or the user's wish, graded.
/// Guarantees   independent of the order of the vertices
/// Cost         one Dijkstra search
/// Reference    thesis Equations 2.1 and 2.2
void setLengthScales(const PlanarDomain& domain, const PlanarSizing& sizing, PlanarTriangulation& triangulation);

}  // namespace mesher
