#pragma once

#include "refinement/refinement_state3d.h"

#include <array>
#include <optional>
#include <vector>

namespace mesher {

/// Swaps the diagonal of two facets of one face, with the tetrahedra beside it. Four corners on one circle, as structured
/// faces have them, allow of either diagonal; rounding then decides which of them the tetrahedra want.
/// Guarantees   surface mesh, constraints, maps and regions agree afterwards; the surface moves by less than `mostHeight` of the
///              diagonal
class FacetSwap3d
{
public:
    /// Height of the fourth corner above the other three, as a share of the diagonal, up to which the two facets are one
    /// plane with the other diagonal: far below any tolerance, far above rounding.
    static constexpr double kNearlyPlane = 1e-9;
    /// The same for facets of a curved surface, where neither diagonal is its own.
    static constexpr double kThin = 0.2;

    explicit FacetSwap3d(RefinementState3d& state) : state_(state) {}

    /// Height up to which the surface may be moved: kThin, unless it is to stay as it is.
    [[nodiscard]] double mostHeight() const
    {
        return state_.options.boundary == BoundaryPolicy::Split ? kThin : kNearlyPlane;
    }

    /// For an unconstrained face that is not Delaunay and cannot be flipped because of a facet diagonal: swaps that. The
    /// tetrahedra that were changed are in `changed`; false if there is no such diagonal.
    bool swapAt(TetFace face, double mostHeight);
    /// A tetrahedron of a solid between two facets and their other diagonal goes to the outside, if it is no higher than that share
    /// of the diagonal. False if it is none.
    bool expel(TetId tet, double mostHeight = kNearlyPlane);
    [[nodiscard]] const std::vector<TetId>& changed() const { return changed_; }

private:
    /// An edge ab between two facets abc and abd.
    struct Diagonal
    {
        std::array<VertexId, 2> end;
        std::array<VertexId, 2> apex;
        std::array<FacetId, 2> facet;
    };

    [[nodiscard]] std::optional<Diagonal> diagonalAt(VertexId a, VertexId b);
    [[nodiscard]] double heightOf(const Diagonal& diagonal) const;
    [[nodiscard]] TetId sliverAt(const Diagonal& diagonal) const;
    [[nodiscard]] bool isFreeBehind(TetId sliver, const Diagonal& diagonal) const;
    bool swapWhatIsThere(const Diagonal& diagonal);
    bool clearOutside(const Diagonal& diagonal);
    bool flipFlat(const Diagonal& diagonal);
    void giveToOtherSide(TetId sliver, const Diagonal& diagonal);
    void swapOnSurface(const Diagonal& diagonal);

    RefinementState3d& state_;
    std::vector<TetId> ring_;
    std::vector<TetId> changed_;
};

}  // namespace mesher
