#pragma once

#include "brep/brep_model.h"

namespace mesher {

/// Distance, in millimetres, below which the kernel takes two points for one: gaps below it are none.
inline constexpr double kConfusion = 1e-7;

/// Makes parameter curves agree with the curves of edges, which files do only within tolerances.
class EdgeFitting
{
public:
    explicit EdgeFitting(BrepModel& model) : model_(model) {}

    /// Measures the coedge's gap. Where its parameter curve runs beside the edge or ahead of it, points of the edge projected on the
    /// surface take its place if they are nearer.
    void fit(BrepCoedge& coedge, const BrepFace& face) const;

    /// Notes what was projected, and gaps beyond the tolerances.
    void noteGaps(const BrepCoedge& coedge, BrepFaceId face);

private:
    [[nodiscard]] double gapOf(const BrepEdge& edge, const ParameterCurve& curve,
                               const Surface& surface) const;

    BrepModel& model_;
};

}  // namespace mesher
