#pragma once

#include "surface_sampling/curve_chains.h"

namespace mesher {

/// Finds the small angle complexes of newly sampled chains and cuts their segments at a shell around the apex, so that the
/// segments at the apex have one length and no cascade of splits can start there.
/// Guarantees   segments of a complex at its apex are all 2^k long, up to rounding and `unprotectedCount`; where the distance
///              from the apex does not grow all the way to the shell, k is made smaller for all of the complex
///              the edges of a face at its tip, as at that of a cone, are one complex whatever their angles
/// Cost         linear, but quadratic in the number of edges at a vertex
/// Reference    [gosselin] §2.5, [miller2003]; in space there is no order of curves around a point, so a complex is what
///              pairs of small angles connect
void protectSmallAngles(CurveChains& chains, IdVector<NodeId, MeshNode>& nodes,
                        const CurveChainOptions& options);

}  // namespace mesher
