#pragma once

#include "base/id_vector.h"
#include "brep/brep_model.h"

#include <cstdint>
#include <vector>

namespace mesher {

/// Which entities of a model stand for others that are at the same place; itself for one that stays.
struct WeldedEntities
{
    IdVector<BrepVertexId, BrepVertexId> vertex;
    IdVector<BrepEdgeId, BrepEdgeId> edge;
    std::size_t vertices = 0;  ///< that others stand for
    std::size_t edges = 0;
};

/// Lets one vertex stand for all that are at one place, and one edge for all that join the same vertices along the same curve:
/// a body that touches itself along an edge or in a point comes from CAD programs with two of each, which no conforming mesh
/// can tell apart. Loops name the edge that stays, which keeps its curve; the parameter curves of the others are taken over
/// by it. Entities that others stand for stay in the model and bound nothing.
/// Guarantees   in the order of the ids; vertices that an edge joins, and edges that bound one face, are never made one
/// Cost         n log n for the vertices, a few projections for each pair of edges between the same vertices
WeldedEntities weldCoincidences(BrepModel& model);

/// Which edges may be welded, with their vertices, and over which distances.
struct WeldingScope
{
    IdVector<BrepEdgeId, std::uint8_t> mayWeld;
    double distance = 0.0;  ///< that is always welded
    double most = 0.0;      ///< that is welded where the tolerances of both entities reach over it
};

/// The same for some edges. What stays gets a tolerance that covers what it stands for.
WeldedEntities weldEdges(BrepModel& model, WeldingScope scope);

}  // namespace mesher
