#pragma once

#include "base/result.h"
#include "brep/brep_model.h"
#include "surface_sampling/curve_chains.h"
#include "surface_sampling/face_scaling.h"

#include <cstdint>
#include <vector>

namespace mesher {

/// An image of a node in the parameters of a face. A seam's nodes have two, a pole has several.
struct OutlinePoint
{
    NodeId node;
    Vec2 uv;
    Vec2 plane;
    bool isPole = false;
    bool isPoleAlongU =
        false;  ///< the pole is a line of equal v, so that u means nothing there; else one of equal u
};

/// A straight piece of the outline in the plane, the face to its left.
struct OutlinePiece
{
    std::uint32_t from = 0;  ///< points of the outline
    std::uint32_t to = 0;
    SegmentId segment;  ///< invalid along a pole
    std::uint32_t loop = 0;
    std::uint32_t coedge = 0;
    Vec2 shift;
    double bulge = 0.0;  ///< how far the parameter curve's middle lies to the left of the piece, in the plane
    Vec3 sag;            ///< from the middle of the segment to that of its curve, in space
    bool isEmbedded = false;  ///< the face lies on both sides
};

/// The loops of a face as polygons of its parameter plane.
struct FaceOutline
{
    FaceScaling scaling;
    std::vector<OutlinePoint> points;
    std::vector<OutlinePiece> pieces;
    double size = 0.0;  ///< extent of the plane's box
};

/// Lifts the chains into the parameters by each coedge's parameter curve and joins the ends of successive coedges: by one
/// point where they differ by a gap, by a pole where the parametrisation is singular, by a shift by whole periods.
/// Refuses      loops that are open in the parameters, or go once around a period
[[nodiscard]] Result<FaceOutline> outlineOf(const BrepModel& model, BrepFaceId face,
                                            const CurveChains& chains,
                                            const IdVector<NodeId, MeshNode>& nodes);

}  // namespace mesher
