#pragma once

#include "brep/brep_model.h"

#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace mesher {

/// A tolerance, and whose it is.
struct ToleranceFact
{
    double value = 0.0;
    std::string entity;
};

struct EdgeLengthFact
{
    BrepEdgeId edge;
    double length = 0.0;
};

/// The angle in degrees between two edges, or the two ends of one, where they leave a vertex.
struct AngleFact
{
    BrepVertexId vertex;
    BrepEdgeId first;
    BrepEdgeId second;
    double degrees = 0.0;
};

/// A face whose width, twice its area by its perimeter, is small beside half its perimeter.
struct SliverFact
{
    BrepFaceId face;
    double width = 0.0;
    double perimeter = 0.0;
};

/// An edge that lies off a face by more than the tolerance of both.
struct GapFact
{
    BrepEdgeId edge;
    BrepFaceId face;
    double distance = 0.0;
};

/// What a mesher should know of a model before it begins. Lengths in model units.
struct ModelFacts
{
    std::string unit;
    Box3 box;
    std::size_t solids = 0;
    std::size_t shells = 0;
    std::size_t openShells = 0;
    std::size_t faces = 0;
    std::size_t edges = 0;
    std::size_t vertices = 0;
    std::size_t degenerateEdges = 0;
    std::map<std::string, std::size_t> facesByType;
    std::map<std::string, std::size_t> edgesByType;
    double area = 0.0;
    double length = 0.0;  ///< of all edges
    ToleranceFact largestTolerance;
    std::size_t looseTolerances = 0;  ///< entities above 1e-7
    std::optional<EdgeLengthFact> smallestEdge;
    std::optional<AngleFact> smallestAngle;
    std::vector<SliverFact> slivers;          ///< thinnest first
    std::vector<GapFact> gaps;                ///< widest first
    std::vector<BrepEdgeId> freeEdges;        ///< the border of a face on one side only
    std::vector<BrepEdgeId> nonManifoldEdges; ///< of three face sides or more
    std::vector<BrepEdgeId> looseEdges;       ///< of no face
    std::vector<std::string> notes;           ///< of the model
};

/// Guarantees   measures are numbers by quadrature, right to about 1e-6 on smooth faces; names and order are the model's
/// Cost         linear but for vertices of many edges
[[nodiscard]] ModelFacts inspectModel(const BrepModel& model);

/// A page for people; lists end after ten entries.
[[nodiscard]] std::string textOf(const ModelFacts& facts);
/// The same, whole, as one JSON object with snake_case keys.
[[nodiscard]] std::string jsonOf(const ModelFacts& facts);

}  // namespace mesher
