#pragma once

#include "base/id_vector.h"
#include "delaunay/constrained_tetrahedralization.h"
#include "mesh/flat_strip_facet.h"

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace mesher {

/// Narrow faces whose facets stay as long as the sizes want. Seen from the inside such a strip is one edge: tetrahedra that have
/// corners on both of its sides are flat whatever is done, and are let be once they are as large as its facets are long.
/// Guarantees   vertices that split a side of a strip are on that side
class FlatStrips
{
public:
    explicit FlatStrips(const ConstrainedTetrahedralization& tetrahedralization) : t_(tetrahedralization) {}

    void find(const SurfaceMesh& surface, std::span<const FlatStripFacet> facets);

    /// Whether the tetrahedron has corners on both sides of a strip, and is no larger than its facets are long.
    [[nodiscard]] bool isAcross(TetId tet) const { return hasAny_ && isAcrossSome(tet); }
    /// Whether an entity of the boundary is a facet across a strip.
    [[nodiscard]] bool isAcross(std::span<const VertexId> corners) const
    {
        return hasAny_ && faceAcrossed(corners).has_value();
    }
    /// Whether an entity of the boundary may be split for quality: none across a strip, segments on its sides not below their
    /// length at the start, and others that touch it not below half of that. `size` is a length, or the diameter of a circle.
    [[nodiscard]] bool maySplit(std::span<const VertexId> corners, double size) const;
    /// The face of the strip that the tetrahedron is across, or has two corners on one side of.
    [[nodiscard]] std::optional<BrepFaceId> faceBeside(TetId tet) const;

    /// A new vertex on the boundary, among those around it on the surface: the two ends of a segment, or the corners of facets.
    void assign(VertexId v, std::span<const VertexId> surround);

private:
    /// Of a vertex: a strip, and the edge of the model that it is on there.
    struct Side
    {
        BrepFaceId strip;
        BrepEdgeId edge;  ///< invalid inside of the strip
        friend auto operator<=>(const Side&, const Side&) = default;
    };
    struct Mark
    {
        std::vector<Side> sides;  ///< ascending
        double length = 0.0;      ///< of the facets at the start
        Vec3 along;               ///< of that length, along the strip
    };

    [[nodiscard]] bool isAcrossSome(TetId tet) const;
    [[nodiscard]] std::optional<BrepFaceId> faceAcrossed(std::span<const VertexId> corners) const;
    [[nodiscard]] std::optional<BrepFaceId> faceBetween(VertexId v, VertexId w) const;
    [[nodiscard]] const Mark* markOf(VertexId v) const
    {
        const std::uint32_t mark = v.value < markOf_.size() ? markOf_[v] : 0;
        return mark == 0 ? nullptr : &marks_[mark];
    }
    Mark& marked(VertexId v);
    [[nodiscard]] static std::vector<Side> common(const Mark& a, const Mark& b);

    const ConstrainedTetrahedralization& t_;
    IdVector<VertexId, std::uint32_t> markOf_;  ///< in marks_; 0 is none
    std::vector<Mark> marks_;
    bool hasAny_ = false;
};

}  // namespace mesher
