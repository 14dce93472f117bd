#pragma once

#include "base/run_context.h"
#include "brep/tangent_variation.h"
#include "sizing/sizing_field.h"

#include <vector>

namespace mesher {

/// What the pieces of a curve are asked to be.
struct CurveWishes
{
    double maxVariation = 0.0;  ///< radians, of the tangent over a piece; > 0
    double maxSag = 0.0;        ///< model units; 0 for no wish
    const SizingField* sizes = nullptr;
    double floor = 0.0;  ///< no piece is made shorter for any of these wishes; > 0
    int leastPieces = 1;
    double mostPieces = 5e7;
};

/// The ends of pieces of a curve, first and last of the part included: at its corners, and between them so that each piece is as long
/// as the sizes on it in the mean, and turns and departs from its chord by no more than may be.
/// Guarantees   ascending parameters; the wishes for turning and sag hold for each piece that is not below twice the floor; without
///              sizes pieces between two corners turn equally. Nothing where there would be more than `mostPieces`
/// Terminates   early when the run is to end; the last piece is too long then
/// Cost         linear in the pieces; at most some thousand questions for sizes on each smooth part
/// Reference    [gosselin] §2.4.1
[[nodiscard]] std::vector<double> divideCurve(const TangentVariation& table, const CurveWishes& wishes,
                                              StepWatch& watch);

}  // namespace mesher
