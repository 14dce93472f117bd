#pragma once

#include "base/box.h"
#include "base/id_vector.h"
#include "base/vec.h"
#include "brep/brep_ids.h"
#include "brep/curve.h"
#include "brep/surface.h"

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace mesher {

/// A curve in the parameter plane of a surface, over the parameter of the edge it belongs to.
class ParameterCurve
{
public:
    virtual ~ParameterCurve() = default;
    [[nodiscard]] virtual Vec2 position(double t) const = 0;
    [[nodiscard]] virtual std::unique_ptr<ParameterCurve> clone() const = 0;
};

struct BrepVertex
{
    Vec3 position;
    double tolerance = 0.0;  ///< model units
};

/// An edge; a degenerate one has no curve, both its vertices are the same, and it stands for a pole in a face's loop.
struct BrepEdge
{
    std::shared_ptr<const Curve> curve;
    Interval part;  ///< first belongs to vertex `first`, last to vertex `last`
    BrepVertexId first;
    BrepVertexId last;
    double tolerance = 0.0;
    bool isDegenerate = false;

    [[nodiscard]] bool isClosed() const { return first == last; }
};

/// A use of an edge in a loop of a face. A seam edge is used twice by its face, with different parameter curves.
struct BrepCoedge
{
    BrepEdgeId edge;
    bool isReversed = false;  ///< the loop runs against the edge's parameter
    std::shared_ptr<const ParameterCurve> parameterCurve;
};

struct BrepLoop
{
    std::vector<BrepCoedge>
        coedges;  ///< in order, the material of the face's surface (not reversed) to the left
};

enum class TrimSide : std::uint8_t
{
    Inside,
    OnBoundary,
    Outside
};

/// Tells whether parameters lie inside the loops of a face. Threads: one object per thread, made by clone().
class TrimClassifier
{
public:
    virtual ~TrimClassifier() = default;
    [[nodiscard]] virtual TrimSide classify(Vec2 uv) const = 0;
    [[nodiscard]] virtual std::unique_ptr<TrimClassifier> clone() const = 0;
};

struct BrepFace
{
    std::shared_ptr<const Surface> surface;
    std::vector<BrepLoop> loops;
    std::shared_ptr<const TrimClassifier> trim;
    Interval boundsU;  ///< of the trimmed part
    Interval boundsV;
    bool isReversed = false;  ///< the outward normal of its solid is against du x dv
    double tolerance = 0.0;
    /// Vertices and edges that lie in the face without bounding it.
    std::vector<BrepVertexId> embeddedVertices;
    std::vector<BrepEdgeId> embeddedEdges;
};

struct BrepShellFace
{
    BrepFaceId face;
    bool isReversed = false;  ///< in the shell, the face's own orientation included
};

struct BrepShell
{
    std::vector<BrepShellFace> faces;
    bool isClosed = false;
};

struct BrepSolid
{
    std::vector<BrepShell> shells;
};

/// The topology and geometry of a model, made by a backend (brep/occt, brep/analytic): all points, curves and surfaces that
/// the mesher will ever ask, with FreeCAD's names and order.
struct BrepModel
{
    IdVector<BrepVertexId, BrepVertex> vertices;
    IdVector<BrepEdgeId, BrepEdge> edges;
    IdVector<BrepFaceId, BrepFace> faces;
    IdVector<BrepSolidId, BrepSolid> solids;
    /// Shells that belong to no solid, and faces that belong to no shell, as shells of their own.
    std::vector<BrepShell> looseShells;
    Box3 box;
    std::string unit = "mm";
    /// What the pre-flight changed or noticed, one clause each, with the entity's name.
    std::vector<std::string> notes;
};

}  // namespace mesher
