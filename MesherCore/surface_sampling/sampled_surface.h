#pragma once

#include "base/id_vector.h"
#include "mesh/surface_mesh.h"
#include "mesh/surface_splitter.h"
#include "surface_sampling/sampled_faces.h"

#include <memory>
#include <vector>

namespace mesher {

/// The sampled faces of a model as one surface mesh, with segments, facets and nodes numbered face by face, and the splits by
/// which the stages that build volumes change it.
/// Guarantees   as SurfaceSplitter: the mesh and the faces' own meshes stay the same; ids never change
/// Cost         assembly linear; a split about that of an insertion
class SampledSurface final : public SurfaceSplitter
{
public:
    explicit SampledSurface(std::unique_ptr<SampledFaces> faces);

    [[nodiscard]] const SurfaceMesh& mesh() const override { return mesh_; }
    void evaluateSegment(SegmentId segment, SurfaceSplitExtent extent, SurfaceSplit& split) override;
    void evaluateFacet(FacetId facet, SurfaceSplitExtent extent, SurfaceSplit& split) override;
    [[nodiscard]] bool accepts(const SurfaceSplit& split) const override;
    SurfaceSplitResult commit(const SurfaceSplit& split) override;
    [[nodiscard]] bool isHeld(FacetId facet) const override;
    [[nodiscard]] bool maySwap(FacetId first, FacetId second) const override;
    std::array<FacetId, 2> swap(FacetId first, FacetId second) override;

    [[nodiscard]] SampledFaces& faces() { return *faces_; }
    [[nodiscard]] const SampledFaces& faces() const { return *faces_; }
    /// Where the facet is in its face's own mesh.
    [[nodiscard]] TriangleId triangleOf(FacetId facet) const { return triangleOf_[facet]; }
    /// Whether the facet is narrow, and to stay so, on the rim of a wall or across a strip that is kept flat.
    [[nodiscard]] bool isOnFlatRim(FacetId facet) const;
    /// Numbers nodes and facets again after the faces were refined: all ids of facets and of nodes inside of faces change.
    void assemble();

private:
    void numberNodes(BrepFaceId f);
    void numberFacets(BrepFaceId f);
    [[nodiscard]] Vec2 insideBounds(BrepFaceId f, Vec2 uv) const;
    [[nodiscard]] EdgeLink sideBetween(FacetId first, FacetId second) const;
    [[nodiscard]] bool isSpoke(SegmentId segment) const;
    void appendStar(BrepFaceId f, const FaceStar& star, SurfaceSplit& split) const;
    void commitFace(BrepFaceId f, const SurfaceSplit& split, SurfaceSplitResult& result);

    std::unique_ptr<SampledFaces> faces_;
    SurfaceMesh mesh_;
    IdVector<FacetId, TriangleId> triangleOf_;
    IdVector<BrepFaceId, std::vector<FacetId>> facetOf_;  ///< by triangle
};

}  // namespace mesher
