#pragma once

#include "brep/brep_ids.h"
#include "delaunay/constrained_tetrahedralization.h"
#include "mesh/surface_mesh.h"

#include <array>
#include <optional>
#include <vector>

namespace mesher {

/// A small angle of the model inside a solid.
struct SmallInputAngle
{
    EntityRef entity;  ///< the edge at which two faces meet, or the vertex at which two edges meet
    double degrees = 0.0;
    std::array<EntityRef, 2> side;  ///< the two faces, or the two edges, ascending
};

/// The small angles of the input, which no refinement can remove: what tetrahedra beside them may not be refined for, and
/// what is to blame for those that are left bad.
/// Guarantees   read off the initial tetrahedralization: dihedral angles between facets at a segment over a region, and
///              angles between segments at a model vertex
/// Reference    [gosselin] section 4.3: below 90 degrees they can make edges shorter and shorter
class SmallAngleGuard
{
public:
    /// Dihedral angles below it are small.
    static constexpr double kSmallDihedral = 60.0;
    static constexpr double kSmallCorner = 45.0;

    SmallAngleGuard(const ConstrainedTetrahedralization& tetrahedralization, const SurfaceMesh& surface);

    /// Finds the nodes on small angles in the refined mesh; call before blameFor.
    void collectPlaces(const SurfaceMesh& surface);
    /// The angle nearest to a point within `reach`, model units, if any: refinement for an angle spreads about as far as the
    /// length scale there.
    [[nodiscard]] std::optional<SmallInputAngle> blameFor(const Vec3& point, double reach) const;
    [[nodiscard]] bool hasAny() const { return !edges_.empty() || !vertices_.empty(); }
    /// The small angle of a model edge or vertex, in degrees; 180 without one.
    [[nodiscard]] double degreesAt(EntityRef entity) const
    {
        const SmallInputAngle* angle = entity.dimension == 0   ? vertices_.find(entity.index)
                                       : entity.dimension == 1 ? edges_.find(entity.index)
                                                               : nullptr;
        return angle != nullptr ? angle->degrees : 180.0;
    }

private:
    void measureSegments(const ConstrainedTetrahedralization& tetrahedralization, const SurfaceMesh& surface);
    void measureCorners(const SurfaceMesh& surface);

    IndexedMap<std::uint32_t, SmallInputAngle> edges_;     ///< by model edge
    IndexedMap<std::uint32_t, SmallInputAngle> vertices_;  ///< by model vertex

    struct Place
    {
        Vec3 position;
        SmallInputAngle angle;
    };
    std::vector<Place> places_;  ///< in lexicographic order
};

}  // namespace mesher
