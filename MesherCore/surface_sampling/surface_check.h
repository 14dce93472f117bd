#pragma once

#include "base/id_vector.h"
#include "brep/brep_model.h"
#include "delaunay/check_report.h"
#include "mesh/surface_mesh.h"

#include <cstddef>
#include <vector>

namespace mesher {

struct SurfaceCheckOptions
{
    /// Largest distance of a node from its own entity: relative to the model's box, or model units if that is more.
    double relativeDistance = 1e-9;
    double absoluteDistance = 1e-7;
    /// Largest angle between a facet's normal and the surface's at its corners, degrees.
    double maxCornerAngle = 90.0;
    /// Largest difference of a face's area and that of its facets, relative to the face's. A coarse mesh has less area.
    double maxAreaDefect = 0.35;
};

struct FaceCheck
{
    CheckReport report;
    std::size_t facets = 0;
    int components = 0;
    int eulerCharacteristic = 0;
    double area = 0.0;       ///< of the facets
    double exactArea = 0.0;  ///< of the face
    double worstCornerAngle = 0.0;
};

struct SurfaceCheck
{
    IdVector<BrepFaceId, FaceCheck> faces;
    /// Nodes off their entity, and chains that are no chains.
    CheckReport nodes;
    /// Shells that are closed in the model and not in the mesh.
    CheckReport shells;
    /// By solid, from the facets and the orientation of the faces in the shells; model units cubed.
    IdVector<BrepSolidId, double> volumes;

    [[nodiscard]] bool isValid() const;
    /// The first problem found, empty if there is none.
    [[nodiscard]] std::string problem() const;
};

/// Checks a surface mesh against the model without knowing how it was made: each face is a 2-manifold that is bounded by the
/// segments of its loops, each in its direction, and nothing else; components and Euler characteristic are those of the
/// face's loops; nodes lie on their entities; corners lie at their parameters; facets look to the surface's side; areas
/// agree; closed shells are closed and consistently oriented.
/// Cost         linear, one surface evaluation per corner
[[nodiscard]] SurfaceCheck checkSurfaceMesh(const BrepModel& model, const SurfaceMesh& mesh,
                                            const SurfaceCheckOptions& options = {});

}  // namespace mesher
