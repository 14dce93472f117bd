#include "brep/model_inspection.h"

#include "brep/face_area.h"
#include "brep/tangent_variation.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace mesher {

namespace {

constexpr double kUsualTolerance = 1e-7;
constexpr double kSliverRatio = 0.01;

const char* nameOf(SurfaceKind kind)
{
    switch (kind) {
        case SurfaceKind::Plane: return "plane";
        case SurfaceKind::Cylinder: return "cylinder";
        case SurfaceKind::Cone: return "cone";
        case SurfaceKind::Sphere: return "sphere";
        case SurfaceKind::Torus: return "torus";
        case SurfaceKind::Bezier: return "bezier";
        case SurfaceKind::BSpline: return "bspline";
        case SurfaceKind::Extrusion: return "extrusion";
        case SurfaceKind::Revolution: return "revolution";
        case SurfaceKind::Offset: return "offset";
        case SurfaceKind::Other: break;
    }
    return "other";
}

const char* nameOf(CurveKind kind)
{
    switch (kind) {
        case CurveKind::Line: return "line";
        case CurveKind::Circle: return "circle";
        case CurveKind::Ellipse: return "ellipse";
        case CurveKind::Hyperbola: return "hyperbola";
        case CurveKind::Parabola: return "parabola";
        case CurveKind::Bezier: return "bezier";
        case CurveKind::BSpline: return "bspline";
        case CurveKind::Other: break;
    }
    return "other";
}

class Inspection
{
public:
    explicit Inspection(const BrepModel& model) : model_(model), lengths_(model.edges.size(), 0.0) {}

    ModelFacts run()
    {
        countTopology();
        findTolerances();
        measureEdges();
        measureFaces();
        findSmallestAngle();
        findUnmatchedEdges();
        facts_.notes = model_.notes;
        return std::move(facts_);
    }

private:
    void countTopology()
    {
        facts_.unit = model_.unit;
        facts_.box = model_.box;
        facts_.solids = model_.solids.size();
        facts_.faces = model_.faces.size();
        facts_.edges = model_.edges.size();
        facts_.vertices = model_.vertices.size();
        const auto count = [&](const BrepShell& shell) {
            ++facts_.shells;
            if (!shell.isClosed) ++facts_.openShells;
        };
        for (const BrepSolid& solid : model_.solids)
            std::for_each(solid.shells.begin(), solid.shells.end(), count);
        std::for_each(model_.looseShells.begin(), model_.looseShells.end(), count);
    }

    template <class IdType, class Entities>
    void includeTolerances(const Entities& entities)
    {
        for (std::uint32_t i = 0; i < entities.size(); ++i) {
            const double tolerance = entities[IdType(i)].tolerance;
            // A hair above is still what CAD programs write for "exact".
            if (tolerance > 1.01 * kUsualTolerance) ++facts_.looseTolerances;
            if (tolerance > facts_.largestTolerance.value) {
                facts_.largestTolerance = {tolerance, mesher::nameOf(IdType(i))};
            }
        }
    }

    void findTolerances()
    {
        includeTolerances<BrepFaceId>(model_.faces);
        includeTolerances<BrepEdgeId>(model_.edges);
        includeTolerances<BrepVertexId>(model_.vertices);
    }

    void measureEdges()
    {
        for (std::uint32_t i = 0; i < model_.edges.size(); ++i) {
            const BrepEdge& edge = model_.edges[BrepEdgeId(i)];
            if (!edge.curve) {
                ++facts_.degenerateEdges;
                continue;
            }
            ++facts_.edgesByType[nameOf(edge.curve->kind())];
            lengths_[i] = TangentVariation(edge.curve, edge.part).totalLength();
            facts_.length += lengths_[i];
            if (!facts_.smallestEdge || lengths_[i] < facts_.smallestEdge->length) {
                facts_.smallestEdge = EdgeLengthFact{BrepEdgeId(i), lengths_[i]};
            }
        }
    }

    void measureFaces()
    {
        for (std::uint32_t i = 0; i < model_.faces.size(); ++i) {
            const BrepFaceId id(i);
            const BrepFace& face = model_.faces[id];
            ++facts_.facesByType[nameOf(face.surface->kind())];
            const double area = areaOf(model_, face);
            double perimeter = 0.0;
            for (const BrepLoop& loop : face.loops) {
                for (const BrepCoedge& coedge : loop.coedges) {
                    perimeter += lengths_[coedge.edge.value];
                    noteGap(id, coedge);
                }
            }
            facts_.area += area;
            const double width = perimeter > 0.0 ? 2.0 * area / perimeter : 0.0;
            if (perimeter > 0.0 && width < kSliverRatio * 0.5 * perimeter) {
                facts_.slivers.push_back({id, width, perimeter});
            }
        }
        const auto isThinner = [](const SliverFact& a, const SliverFact& b) { return a.width < b.width; };
        std::stable_sort(facts_.slivers.begin(), facts_.slivers.end(), isThinner);
        const auto isWider = [](const GapFact& a, const GapFact& b) { return a.distance > b.distance; };
        std::stable_sort(facts_.gaps.begin(), facts_.gaps.end(), isWider);
    }

    void noteGap(BrepFaceId id, const BrepCoedge& coedge)
    {
        const BrepEdge& edge = model_.edges[coedge.edge];
        const double allowed = std::max({edge.tolerance, model_.faces[id].tolerance,
                                         edge.isDegenerate ? model_.vertices[edge.first].tolerance : 0.0});
        if (coedge.gap > allowed) facts_.gaps.push_back({coedge.edge, id, coedge.gap});
    }

    struct Ray
    {
        BrepEdgeId edge;
        Vec3 direction;
    };

    void findSmallestAngle()
    {
        std::vector<std::vector<Ray>> rays(model_.vertices.size());
        for (std::uint32_t i = 0; i < model_.edges.size(); ++i) {
            const BrepEdge& edge = model_.edges[BrepEdgeId(i)];
            if (!edge.curve) continue;
            rays[edge.first.value].push_back({BrepEdgeId(i), edge.curve->evaluate(edge.part.first).d1});
            rays[edge.last.value].push_back({BrepEdgeId(i), -1.0 * edge.curve->evaluate(edge.part.last).d1});
        }
        for (std::uint32_t v = 0; v < rays.size(); ++v) {
            for (std::size_t i = 0; i < rays[v].size(); ++i) {
                for (std::size_t j = i + 1; j < rays[v].size(); ++j) {
                    const Vec3 a = rays[v][i].direction, b = rays[v][j].direction;
                    if (!(squaredLength(a) > 0.0) || !(squaredLength(b) > 0.0)) continue;
                    const double angle =
                        std::atan2(length(cross(a, b)), dot(a, b)) * 180.0 / std::numbers::pi;
                    if (facts_.smallestAngle && facts_.smallestAngle->degrees <= angle) continue;
                    facts_.smallestAngle =
                        AngleFact{BrepVertexId(v), rays[v][i].edge, rays[v][j].edge, angle};
                }
            }
        }
    }

    void findUnmatchedEdges()
    {
        std::vector<int> uses(model_.edges.size(), 0);
        std::vector<bool> isEmbedded(model_.edges.size(), false);
        for (const BrepFace& face : model_.faces) {
            for (const BrepLoop& loop : face.loops) {
                for (const BrepCoedge& coedge : loop.coedges) ++uses[coedge.edge.value];
            }
            for (const BrepEdgeId edge : face.embeddedEdges) isEmbedded[edge.value] = true;
        }
        for (std::uint32_t i = 0; i < uses.size(); ++i) {
            if (!model_.edges[BrepEdgeId(i)].curve || isEmbedded[i]) continue;
            if (uses[i] == 0) facts_.looseEdges.push_back(BrepEdgeId(i));
            if (uses[i] == 1) facts_.freeEdges.push_back(BrepEdgeId(i));
            if (uses[i] > 2) facts_.nonManifoldEdges.push_back(BrepEdgeId(i));
        }
    }

    const BrepModel& model_;
    std::vector<double> lengths_;
    ModelFacts facts_;
};

}  // namespace

ModelFacts inspectModel(const BrepModel& model) { return Inspection(model).run(); }

}  // namespace mesher
