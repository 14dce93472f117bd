#pragma once

#include "base/budget.h"
#include "base/result.h"
#include "base/run_context.h"
#include "brep/brep_model.h"
#include "improvement/edge_removal.h"
#include "mesh/classified_mesh.h"

#include <cstdint>

namespace mesher {

struct ImprovementOptions
{
    /// Tetrahedra are bad below this smallest dihedral angle, degrees in (0, 60], and above the largest that is as bad by
    /// kObtuseWeight.
    double wantedAngle = 30.0;
    BoundaryChanges boundary = BoundaryChanges::Allowed;
    /// Chords are not moved further from curves and faces than this unless they are, model units; 0 for no such limit.
    double maxSag = 0.0;
    /// Rounds over the tetrahedra that are bad still and about which something has changed.
    int maxPasses = 8;
    BudgetLimits limits;
};

struct ImprovementCounts
{
    std::uint64_t badBefore = 0;  ///< tetrahedra below the wanted score
    std::uint64_t badAfter = 0;
    std::uint64_t edgeRemovals = 0;
    std::uint64_t boundarySwaps = 0;
    std::uint64_t faceRemovals = 0;
    std::uint64_t contractions = 0;
    std::uint64_t insertions = 0;
    std::uint64_t innerMoves = 0;  ///< of nodes inside of solids
    std::uint64_t faceMoves = 0;   ///< of nodes on faces
    std::uint64_t edgeMoves = 0;   ///< of nodes on edges
    /// Swaps and moves on the boundary that are not within planes and straight lines, so that the surface is another.
    std::uint64_t curvedChanges = 0;
    std::uint64_t passes = 0;
    std::uint64_t surroundings = 0;  ///< tetrahedra that nothing helped alone, tried with those about them
};

/// Degrees; as if there were none but right angles in a mesh without tetrahedra.
struct DihedralRange
{
    double least = 90.0;
    double largest = 90.0;
};

struct Improvement
{
    /// Done; CannotImprove when tetrahedra are left bad; or the limit that ended it.
    StopReason stopReason = StopReason::Done;
    ImprovementCounts counts;
    double scoreBefore = 0.0;  ///< least dihedralScore
    double scoreAfter = 0.0;
    DihedralRange anglesBefore;
};

/// Raises the worst tetrahedra of a finished mesh by swaps, by moving nodes, by drawing nodes into others: inside, and on the
/// boundary along the exact curves and faces of the model. What is not bad is changed only beside what is.
/// Guarantees   the sorted scores never fall (each change raises the least of those that it touches); tetrahedra stay exactly
///              positive, the boundary the same surface with the same classification, nodes on it on their own entity, nodes at
///              vertices of the model where they are (improvement_check.h proves it); the same input gives the same mesh
/// Refuses      options out of range: InvalidArgument
/// Terminates   after maxPasses, some rounds over those that are left, and by the limits; the mesh is sound also then
/// Cost         linear, and some microseconds for each bad tetrahedron
/// Units        model units; angles in degrees
/// Reference    [gosselin] section 4.6, [freitag1997]. There the boundary is frozen, which it calls its limit
[[nodiscard]] Result<Improvement> improveMesh(ClassifiedMesh& mesh, const BrepModel& model,
                                              const ImprovementOptions& options, RunContext& context);

}  // namespace mesher
