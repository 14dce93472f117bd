#pragma once

#include "base/result.h"
#include "base/run_context.h"
#include "base/stop_reason.h"
#include "brep/brep_model.h"
#include "mesh/surface_mesh.h"
#include "surface_sampling/curve_chains.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

namespace mesher {

struct InitialFaceMeshOptions
{
    /// Largest angle between a facet's normal and those of the surface beneath it, degrees.
    double maxNormalDeviation = 45.0;
    /// Interior points of a face before it is given up.
    std::size_t maxPointsPerFace = 50'000;
    /// Rounds in which a face may name segments to be split before it is given up. A segment is halved in each at the most.
    int maxSplitsInSeries = 24;
    /// Rounds in which segments are split and the faces beside them begun anew.
    int maxRounds = 60;
};

/// A use of a segment by the boundary of a face.
struct FaceBoundaryPiece
{
    SegmentId segment;
    std::uint32_t loop = 0;  ///< BrepFace::loops
    std::uint32_t coedge = 0;
    std::array<NodeId, 2> node;      ///< in the direction of the loop: the face lies to the left
    std::array<Vec2, 2> parameters;  ///< of this image of the segment
    Vec2 shift;                      ///< what was added to the coedge's parameter curve, whole periods
};

/// A triangle mesh of one face between the given chains.
struct InitialFaceMesh
{
    std::vector<SurfaceFacet> facets;
    /// Nodes inside of the face that `facets` use, ids from `firstInteriorNode` on.
    std::vector<MeshNode> interiorNodes;
    NodeId firstInteriorNode;
    /// On rings around the tips of the face, see apex_rings.h; curves' nodes and interior ones.
    std::vector<NodeId> ringNodes;
    /// In the order of the loops; a seam's segments come twice, the two images glued through the same nodes.
    std::vector<FaceBoundaryPiece> boundary;
    /// Facets that depart from the surface by more than the option allows, and are too small to be split, or too narrow for the
    /// face's tolerance.
    std::size_t leftAlone = 0;
    std::size_t openTips = 0;  ///< of cones and the like, without a ring
    /// Not empty: the chains are too coarse for the face. Split these and try again; there are no facets then.
    std::vector<SegmentId> tooCoarse;
};

/// Triangulates a face in its parameters, scaled so that they measure about as the surface does: the constrained Delaunay
/// triangulation of the loops, refined by points inside until facets follow the surface. `taken` are edges of other faces,
/// pairs in ascending order, which no free edge of this face may be.
/// Guarantees   facets are counter-clockwise about du x dv, conforming through the nodes, also across a seam and around a
///              pole; their normals keep to the option at corners, at centres and in the middle of sides, but
///              for `leftAlone` of them, and to 90 degrees at corners, but for facets narrower than the face's tolerance
/// Refuses      loops that cross each other or themselves wherever the chains are fine, loops that enclose nothing: an Error
///              that names the face, the place and a remedy
/// Terminates   by the options' budgets and the chains' floors
/// Reference    [gosselin] §3.3.2 for the purpose; here the topology comes from the face's loops, not from a restricted
///              Delaunay triangulation, so that it is right from the start
[[nodiscard]] Result<InitialFaceMesh>
triangulateFace(const BrepModel& model, BrepFaceId face, const CurveChains& chains,
                const IdVector<NodeId, MeshNode>& nodes, NodeId firstInteriorNode,
                const InitialFaceMeshOptions& options, std::span<const std::pair<NodeId, NodeId>> taken = {});

/// `triangulateFace` that splits segments by itself as long as they are too coarse, and appends the interior nodes.
/// For one face alone: neighbours that were meshed before a split are stale then.
[[nodiscard]] Result<std::vector<SurfaceFacet>> initialFaceMesh(const BrepModel& model, BrepFaceId face,
                                                                CurveChains& chains,
                                                                IdVector<NodeId, MeshNode>& nodes,
                                                                const InitialFaceMeshOptions& options);

/// That a face could not be meshed although its segments were split that many times.
[[nodiscard]] Error chainsTooCoarse(BrepFaceId face, const Vec3& point, int rounds);

/// The faces of a model that have a mesh, and the reasons why others have none.
struct InitialSurfaceMesh
{
    IdVector<BrepFaceId, InitialFaceMesh> faces;
    std::vector<std::pair<BrepFaceId, Error>> failures;
    std::size_t segmentSplits = 0;
    int rounds = 0;
    StopReason stopReason =
        StopReason::Done;  ///< Cancelled or TimeLimit: some faces have no facets and no failure then
};

/// Meshes all faces: in each round the faces whose chains changed propose splits, which are then made in the order of the
/// segments, so that the result does not depend on the order of the faces.
/// Guarantees   no two faces join the same two nodes by an edge that is no segment of both. Of a face that failed there are no
///              facets
/// Terminates   by the options; cancellation and the limit of time are looked at before each face
[[nodiscard]] InitialSurfaceMesh initialSurfaceMesh(const BrepModel& model, CurveChains& chains,
                                                    IdVector<NodeId, MeshNode>& nodes,
                                                    const InitialFaceMeshOptions& options,
                                                    RunContext& context);

/// Chains, nodes and facets as one mesh, facets in the order of the faces.
[[nodiscard]] SurfaceMesh assembleSurfaceMesh(const CurveChains& chains,
                                              const IdVector<NodeId, MeshNode>& nodes,
                                              const InitialSurfaceMesh& initial);

}  // namespace mesher
