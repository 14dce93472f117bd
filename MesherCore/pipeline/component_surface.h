#pragma once

#include "brep/brep_model.h"
#include "mesh/region_sides.h"
#include "mesh/surface_mesh.h"
#include "sizing/box_tree.h"

#include <array>
#include <optional>
#include <vector>

namespace mesher {

/// The sampled surface of a group of solids, asked from outside where places lie: on its exact faces, inside of a solid, or
/// neither.
/// Requires     model, mesh and sides to stay as they are while the object lives; a mesh without a hole
/// Cost         O(n log n) and a projection for each facet to make; a search of a tree, and a projection where the place is near the surface, for each question
class ComponentSurface
{
public:
    ComponentSurface(const BrepModel& model, const SurfaceMesh& mesh, const RegionSides& sides);

    /// The facet nearest to a place.
    struct Nearest
    {
        FacetId facet;
        double distance = 0.0;
        Vec3 place;  ///< on the facet
        Vec2 parameters;
    };

    /// A face at a place.
    struct Touch
    {
        BrepFaceId face;
        Vec3 normal;  ///< du x dv, of length 1 or 0
    };

    /// Where a place lies with respect to the solids.
    struct Position
    {
        enum class Kind
        {
            Outside,
            Touching,  ///< within the tolerance of a face
            Inside
        };
        Kind kind = Kind::Outside;
        BrepSolidId solid;           ///< that it touches or is in
        std::vector<Touch> touched;  ///< the faces, if it touches any
        double depth = 0.0;          ///< from the surface, if it is inside
        double clearance = 0.0;      ///< no facet is nearer, if it is outside and beyond what facets cut off
    };

    [[nodiscard]] const Box3& box() const { return box_; }
    [[nodiscard]] const SurfaceMesh& mesh() const { return mesh_; }
    [[nodiscard]] const BrepModel& model() const { return model_; }
    [[nodiscard]] const RegionSides& sides() const { return sides_; }

    [[nodiscard]] Nearest nearest(const Vec3& place) const;
    [[nodiscard]] Position positionOf(const Vec3& place, double tolerance) const;
    /// A bound of how far a facet is from its face.
    [[nodiscard]] double sagOf(FacetId facet) const { return sag_[facet]; }
    [[nodiscard]] double largestSag() const { return largestSag_; }
    /// The exact point of a facet's face by about these parameters; nothing outside of the face.
    [[nodiscard]] std::optional<SurfaceProjection> onFace(FacetId facet, const Vec3& place,
                                                          Vec2 parameters) const;
    /// Ascending shares of the way from a to b at which facets are met.
    [[nodiscard]] std::vector<double> crossings(const Vec3& a, const Vec3& b) const;

private:
    [[nodiscard]] BrepSolidId solidAt(BrepFaceId face, bool isInFront) const;
    /// The nearest facet of each face that may pass through a place, in the order of the faces: those that depart from their
    /// facets by that much, and that of the nearest facet.
    [[nodiscard]] std::vector<Nearest> facesAbout(const Vec3& place, double tolerance,
                                                  const Nearest& nearestFacet) const;
    [[nodiscard]] Nearest footOn(FacetId facet, const Vec3& place) const;
    /// Whether the face is there without asking for its exact boundary.
    [[nodiscard]] bool isOnFacet(FacetId facet, Vec2 parameters) const;

    const BrepModel& model_;
    const SurfaceMesh& mesh_;
    const RegionSides& sides_;
    Box3 box_;
    IdVector<FacetId, double> sag_;
    IdVector<FacetId, std::uint8_t>
        isFlush_;  ///< in parameters it has no part beyond the boundary of its face
    double largestSag_ = 0.0;
    std::vector<FacetId> facets_;               ///< of the boxes of the trees
    BoxTree tree_;                              ///< of the facets
    std::vector<std::array<Vec3, 3>> corners_;  ///< in the order of the tree
    BoxTree faceTree_;                          ///< of facets with what they may depart from their face
};

}  // namespace mesher
