#pragma once

#include "base/result.h"
#include "delaunay/constrained_tetrahedralization.h"
#include "mesh/surface_splitter.h"
#include "tetrahedralization/temporary_splits.h"

#include <array>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace mesher {

/// Two vertices that are to be joined, the smaller id first.
using EdgeKey = std::pair<VertexId, VertexId>;

/// The segments and facets of the surface mesh as they come to be constraints of the tetrahedralization: what is there is
/// locked, what is not is listed. Edges of facets that are not yet there are locked for the time as well.
/// Guarantees   flags and maps of the tetrahedralization agree with the surface mesh after each call
class SurfaceConstraints
{
public:
    SurfaceConstraints(SurfaceSplitter& surface, ConstrainedTetrahedralization& tets)
        : exact_(surface), active_(&surface), tets_(tets)
    {
    }

    [[nodiscard]] const SurfaceMesh& surface() const { return active_->mesh(); }
    [[nodiscard]] SurfaceSplitter& splitter() { return *active_; }
    [[nodiscard]] ConstrainedTetrahedralization& tets() { return tets_; }
    [[nodiscard]] Triangulation3d& mesh() { return tets_.mesh(); }
    [[nodiscard]] const Triangulation3d& mesh() const { return std::as_const(tets_).mesh(); }

    [[nodiscard]] std::array<VertexId, 3> cornersOf(FacetId facet) const;
    /// Invalid for a vertex that recovery or a scaffold added.
    [[nodiscard]] NodeId nodeAt(VertexId vertex) const;
    /// The live facets at the edge, in the order of their ids. Cost: the facets at a node, once all were listed by node.
    std::vector<FacetId> facetsAt(VertexId a, VertexId b);
    /// Invalid if the edge is no segment.
    [[nodiscard]] SegmentId segmentAt(VertexId a, VertexId b) const;
    /// Whether the edge is locked or bounds a constrained face.
    [[nodiscard]] bool isConstraint(TetId tet, VertexId a, VertexId b) const;

    void lockEdge(TetId tet, VertexId a, VertexId b);
    void lockFacet(TetFace face);
    /// Locks the edges of the facets around a vertex instead of these themselves, which are listed as missing: edges leave
    /// more freedom for the recovery of others.
    void loosenFacetsAt(VertexId vertex);
    /// Takes the locks from edges that are no segments.
    void releaseTemporaryLocks();

    /// Takes off the constraints what a split is to remove, so that its vertex can be inserted; then either `make` or
    /// `restore` has to follow.
    void release(const SurfaceSplit& split);
    void restore(const SurfaceSplit& split);
    /// Makes the released split, `vertex` being the new node: what it adds becomes a constraint, or is listed as missing.
    void make(const SurfaceSplit& split, VertexId vertex);

    // --- splits off the exact geometry
    /// From now on splits change a copy of the surface mesh, and any place is accepted. False if so already.
    bool startTemporarySplits();
    /// Null before the start.
    [[nodiscard]] const TemporarySplits* temporarySplits() const { return temporary_.get(); }
    /// Takes a temporary split back in the maps; the tetrahedralization has the constraints that it had split already.
    void takeBack(std::size_t index);
    /// Goes back to the surface mesh itself. What temporary splits are left are made there: the first one that is not
    /// accepted is told by its entity, and the maps are of no use then.
    Result<void> endTemporarySplits();

    /// "Edge3" for a segment, "Face6" for another edge of a facet or a facet, "Vertex2" …
    std::string nameOfEdge(VertexId a, VertexId b);
    [[nodiscard]] std::string nameOfFacet(FacetId facet) const;
    [[nodiscard]] std::string nameOfVertex(VertexId vertex) const;
    [[nodiscard]] Vec3 modelPosition(const Vec3& kernel) const { return (1.0 / tets_.scale) * kernel; }

    /// What is yet to be recovered. Entries may have become obsolete.
    std::vector<EdgeKey> missingEdges;
    std::vector<FacetId> missingFacets;

    /// Locks the facet if it is a face, else lists it and those of its edges that are missing.
    void require(FacetId facet);
    void require(SegmentId segment);

private:
    void requireEdge(VertexId a, VertexId b);
    void listFacetsByNode();
    void unlock(VertexId a, VertexId b);

    SurfaceSplitter& exact_;
    SurfaceSplitter* active_;
    std::unique_ptr<TemporarySplits> temporary_;
    ConstrainedTetrahedralization& tets_;
    std::vector<EdgeKey> temporaryLocks_;
    /// Not 0: no facet at the vertex is locked.
    IdVector<VertexId, std::uint8_t> isLoose_;
    /// Also dead ones; empty until it is asked for.
    IdVector<NodeId, std::vector<FacetId>> facetsByNode_;
};

}  // namespace mesher
