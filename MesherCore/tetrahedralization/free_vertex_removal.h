#pragma once

#include "delaunay/constrained_tetrahedralization.h"
#include "delaunay/hole_refill.h"
#include "tetrahedralization/flip_search.h"
#include "tetrahedralization/tetrahedralize.h"

#include <cstdint>
#include <vector>

namespace mesher {

/// Removes one vertex that is no node of the surface and no end of a constraint: with the Delaunay tetrahedra of its
/// neighbours, by moving it into one of them, after flips as well, or with a hole that grows beyond its own tetrahedra.
/// Guarantees   constraints and regions stay
class FreeVertexRemover
{
public:
    explicit FreeVertexRemover(ConstrainedTetrahedralization& tets)
        : tets_(tets), mesh_(tets.mesh()), flips_(mesh_), replacement_(mesh_), holes_(mesh_)
    {
    }

    /// False, with nothing changed, if none of these can, or the vertex is on the hull.
    bool remove(VertexId vertex);

private:
    bool contract(VertexId vertex);
    bool contractAfterFlips(VertexId vertex);
    bool removeWithNeighbours(VertexId vertex);
    bool fillFrom(VertexId vertex, VertexId target);
    std::vector<VertexId> neighboursOf(VertexId vertex);

    ConstrainedTetrahedralization& tets_;
    Triangulation3d& mesh_;
    FlipSearch flips_;
    TetReplacement3d replacement_;
    HoleRefill holes_;
    std::vector<TetId> hole_;
    std::vector<TetCorners> filling_;
};

struct FreeVertexRemoval
{
    std::uint32_t removed = 0;
    std::uint32_t left = 0;  ///< inside of solids
};

/// Removes the vertices inside of solids that are no nodes, scaffold points and those that recovery added, as far as the
/// tetrahedralization stays valid without them. Those outside stay, and scaffold points inside if they are to be Kept.
/// Terminates   always; a budget that refuses leaves the rest
/// Guarantees   constraints and regions stay; faces that were locally Delaunay stay so
FreeVertexRemoval removeFreeVertices(ConstrainedTetrahedralization& tets, SurfaceScaffold scaffold,
                                     Budget& budget, RunContext& context);

}  // namespace mesher
