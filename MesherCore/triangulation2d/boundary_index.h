#pragma once

#include "base/box.h"
#include "triangulation2d/boundary.h"

#include <memory>
#include <vector>

namespace mesher {

/// Boundary edges by the boxes of their diametral circles: the spatial index of Algorithm 2.1. A crossing of two edges, or
/// a vertex in a circle, shows as overlapping boxes.
class BoundaryIndex
{
public:
    /// Of all subcurves that are alive.
    explicit BoundaryIndex(const Boundary& boundary);
    ~BoundaryIndex();
    BoundaryIndex(const BoundaryIndex&) = delete;
    BoundaryIndex& operator=(const BoundaryIndex&) = delete;

    void insert(const Boundary& boundary, SubcurveId s);
    void remove(const Boundary& boundary, SubcurveId s);
    /// The subcurves whose circle's box meets the given box, in order of their ids.
    void query(const Box2& box, std::vector<SubcurveId>& found) const;

private:
    struct Tree;
    std::unique_ptr<Tree> tree_;
};

}  // namespace mesher
