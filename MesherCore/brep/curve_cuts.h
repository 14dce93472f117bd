#pragma once

#include "brep/tangent_variation.h"

#include <vector>

namespace mesher {

/// The end of a piece of a curve.
struct CurveCut
{
    double parameter = 0.0;
    bool isCorner = false;  ///< of the tangent; set for the end of the curve, too
};

/// Cuts a curve at its corners, and between them into pieces of equal total variation of the tangent (equal length where all
/// is straight), as few as the bound allows but no fewer than `leastPieces` in all.
/// Guarantees   ascending cuts, the last one at the end of the part; no piece turns by more than the bound, up to rounding
/// Units        radians
/// Reference    [gosselin] §2.4.1
[[nodiscard]] std::vector<CurveCut> cutByVariation(const TangentVariation& table, double maxVariation,
                                                   int leastPieces);

/// The shell around the apex of a small angle has the radius of the largest power of two that is not above two thirds of the
/// shortest edge there; this is its exponent.
/// Reference    [gosselin] §2.5
[[nodiscard]] int firstShellExponent(double shortestEdge);

}  // namespace mesher
