#pragma once

#include "improvement/boundary_geometry.h"
#include "improvement/edge_removal.h"
#include "improvement/tet_complex.h"

#include <span>
#include <vector>

namespace mesher {

/// Looks for a better place of a node: climbs the least score at it along the direction that raises all active ones, those that
/// are nearly the least, fastest. Nodes of faces climb in the tangent plane and are put back on the surface, nodes of edges
/// along their curve; nodes at vertices of the model stay.
/// Guarantees   false unless all tetrahedra at the node stay positive and the least score rises; of the boundary only what
///              BoundaryGeometry allows
/// Terminates   after kClimbs steps, at `target`, or where no direction helps
/// Cost         some ten times the scores of the star, and as many projections on the boundary
/// Reference    [freitag1997]; that the sines of dihedral angles are climbed one by one, by their analytic gradients, is ours
class VertexSmoothing
{
public:
    VertexSmoothing(const TetComplex& complex, BoundaryGeometry& geometry, BoundaryChanges boundary)
        : complex_(complex), geometry_(geometry), boundary_(boundary)
    {
    }

    [[nodiscard]] bool evaluate(NodeId n, double target);
    /// Of a node yet to come, in a cavity with these faces, counter-clockwise as seen from it: the move is its place, beginning in
    /// the middle of the nodes. False if that does not see them all.
    [[nodiscard]] bool evaluateNew(std::span<const FacetNodes> hull, double target);
    /// What the last evaluation found.
    [[nodiscard]] const BoundaryMove& move() const { return best_; }
    [[nodiscard]] double score() const { return score_; }

private:
    static constexpr int kClimbs = 5;
    static constexpr int kHalvings = 4;

    struct StarTet
    {
        TetCorners corners;
        std::size_t slot = 0;
        double score = 0.0;
    };

    bool prepare(NodeId n);
    bool climbTo(double target);
    [[nodiscard]] bool isPositive() const;
    [[nodiscard]] Vec3 within(const Vec3& v) const;
    [[nodiscard]] Vec3 direction();
    bool evaluatePlace(const Vec3& target);
    [[nodiscard]] double leastAt(const Vec3& position, double floor);
    bool climb(const Vec3& along, double& step);

    const TetComplex& complex_;
    BoundaryGeometry& geometry_;
    BoundaryChanges boundary_;
    std::vector<StarTet> star_;
    std::vector<double> trialScores_;
    std::vector<Vec3> gradients_;
    int dimension_ = 3;
    Vec3 axis_;  ///< normal of the plane or tangent of the curve in which the node moves
    double shortest_ = 0.0;
    double score_ = 0.0;
    BoundaryMove best_;
    BoundaryMove trial_;
};

}  // namespace mesher
