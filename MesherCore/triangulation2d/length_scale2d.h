#pragma once

#include "sizing/sizing_field.h"
#include "triangulation2d/planar_triangulation.h"

#include <vector>

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
[[nodiscard]] double localFeatureSize(const PlanarDomain& domain, const PlanarTriangulation& triangulation,
                                      VertexId v);

/// The user's wish at a place, in units of the triangulation; infinite without a field.
[[nodiscard]] double wantedSize(const PlanarDomain& domain, const PlanarSizing& sizing, Vec2 position);

/// Sets the length scale of every vertex of the initial triangulation: lfs / R or the user's wish, graded.
/// Guarantees   independent of the order of the vertices
/// Cost         one Dijkstra search
/// Reference    thesis Equations 2.1 and 2.2
void setLengthScales(const PlanarDomain& domain, const PlanarSizing& sizing,
                     PlanarTriangulation& triangulation);

/// Length scale of a vertex about to be inserted inside of a region: Equation 2.1 over the neighbours it will have, or the
/// user's wish if that is smaller.
[[nodiscard]] double lengthScaleOfCavity(const PlanarDomain& domain, const PlanarSizing& sizing,
                                         const Triangulation2d& mesh, const Cavity2d& cavity);
/// Equation 2.1 at a vertex of the mesh, over its neighbours in regions.
[[nodiscard]] double gradedLengthScale(const PlanarTriangulation& triangulation, const PlanarSizing& sizing,
                                       VertexId v);
/// The ceiling at a split: between the length scales of the subcurve's ends, by arc length. Thesis section 2.4.3.
[[nodiscard]] double interpolatedLengthScale(const PlanarDomain& domain, const Subcurve& whole, double t,
                                             double firstScale, double lastScale);
/// Lowers the length scales around a vertex, as far as its own is too low for them, by Equation 2.1.
/// `lowered` receives the vertices whose length scale has changed.
void gradeAgainFrom(VertexId v, const PlanarSizing& sizing, PlanarTriangulation& triangulation,
                    std::vector<VertexId>& lowered);

}  // namespace mesher
