#pragma once

#include "improvement/boundary_geometry.h"
#include "improvement/improve_mesh.h"
#include "improvement/tet_complex.h"
#include "improvement/vertex_insertion.h"
#include "improvement/vertex_smoothing.h"

#include <cstdint>
#include <utility>
#include <vector>

namespace mesher {

struct ScoreRange
{
    double low = 0.0;
    double high = 0.0;
};

/// Improves one tetrahedron at a time by the changes that help most often first.
/// Guarantees   each change raises the least score of the tetrahedra that it touches
class TetImprover
{
public:
    TetImprover(TetComplex& complex, BoundaryGeometry& geometry, BoundaryChanges boundary,
                ImprovementCounts& counts)
        : complex_(complex),
          geometry_(geometry),
          boundary_(boundary),
          counts_(counts),
          smoothing_(complex, geometry, boundary),
          insertion_(complex, smoothing_)
    {
    }

    /// One change, or one move of each of its nodes: edges or faces go, nodes move, one goes, one comes. False if none helps.
    bool improve(TetId t, double wanted);
    /// First takes the tetrahedra about this one with a score in the range `around` towards its end: what keeps a tetrahedron bad
    /// are neighbours no better than they had to be, which leave its nodes no room.
    /// Cost   one change for each of some sixty tetrahedra, half a millisecond
    void improveWithSurroundings(TetId t, double wanted, ScoreRange around);

private:
    enum class Kind
    {
        None,
        Edge,
        Swap,
        Face
    };

    bool reconnect(TetId t, double wanted);
    bool moveNodes(TetId t, double wanted);
    bool contract(TetId t);
    bool insert(TetId t, double wanted);

    TetComplex& complex_;
    BoundaryGeometry& geometry_;
    BoundaryChanges boundary_;
    ImprovementCounts& counts_;
    VertexSmoothing smoothing_;
    VertexInsertion insertion_;
    LocalChange best_;
    LocalChange change_;
    std::vector<std::pair<double, TetId>> around_;
};

}  // namespace mesher
