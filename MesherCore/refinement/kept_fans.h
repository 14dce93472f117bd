#pragma once

#include "base/id_vector.h"
#include "delaunay/constrained_tetrahedralization.h"
#include "mesh/surface_splitter.h"

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace mesher {

/// The fans of facets around tips of faces that the surface holds. The ring around a fan lies about in one plane, which no
/// facet covers: vertices of the ring alone, or one next to that plane, make flat tetrahedra there that nothing could better,
/// one vertex in the middle of the ring makes good ones.
/// Cost     linear in the facets; a question is one look-up for each vertex
class KeptFans
{
public:
    KeptFans(const ConstrainedTetrahedralization& tetrahedralization, const SurfaceSplitter& splitter);

    [[nodiscard]] bool hasAny() const { return !balls_.empty(); }
    /// The fan in which the point is, or to whose ring it is too near, if one of the vertices beside it is on that ring.
    /// Coordinates of the tetrahedralization.
    [[nodiscard]] std::optional<std::uint32_t> crowdedBy(const Vec3& point,
                                                         std::span<const VertexId> beside) const;
    /// The fan whose ring all of the vertices are on.
    [[nodiscard]] std::optional<std::uint32_t> withRingThrough(std::span<const VertexId> vertices) const;
    /// The middle of its ring; none once that is taken.
    [[nodiscard]] std::optional<Vec3> freeCentre(std::uint32_t fan) const;
    void take(std::uint32_t fan) { balls_[fan].isTaken = true; }

private:
    struct Ball
    {
        Vec3 tip;
        Vec3 centre;
        double squaredRadius = 0.0;
        double leastCosine = 0.0;  ///< with the axis, of what is within the fan
        bool isTaken = false;
    };

    static constexpr std::uint32_t kNone = 0xffffffffu;
    std::vector<Ball> balls_;
    IdVector<VertexId, std::uint32_t> ballOf_;  ///< of the vertices on rings; shorter than the vertices
};

}  // namespace mesher
