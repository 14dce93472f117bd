#include "brep/occt/model_builder.h"

#include "brep/analytic/parameter_curves.h"
#include "brep/edge_fitting.h"
#include "brep/model_box.h"
#include "brep/name_list.h"
#include "brep/occt/occt_convert.h"
#include "brep/occt/occt_curve.h"
#include "brep/occt/occt_error.h"
#include "brep/occt/occt_surface.h"
#include "brep/occt/occt_trim.h"
#include "brep/occt/wire_order.h"

#include <BRepTools.hxx>
#include <BRep_Tool.hxx>
#include <Precision.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_IndexedDataMapOfShapeListOfShape.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>
#include <TopoDS_Iterator.hxx>
#include <TopoDS_Vertex.hxx>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

namespace mesher {

namespace {

constexpr const char* kRepairRemedy = "repair the shape in the CAD program or read it with healing";

Error broken(std::string entity, std::string message)
{
    return Error{ErrorCode::DegenerateInput, std::move(message), std::move(entity), {}, kRepairRemedy};
}

template <class IdType>
IdType idIn(const TopTools_IndexedMapOfShape& map, const TopoDS_Shape& shape)
{
    const int index = map.FindIndex(shape);
    return index > 0 ? IdType(static_cast<std::uint32_t>(index - 1)) : IdType{};
}

class ModelBuilder
{
public:
    explicit ModelBuilder(const TopoDS_Shape& shape) : shape_(shape)
    {
        TopExp::MapShapes(shape, TopAbs_VERTEX, vertices_);
        TopExp::MapShapes(shape, TopAbs_EDGE, edges_);
        TopExp::MapShapes(shape, TopAbs_FACE, faces_);
        TopExp::MapShapes(shape, TopAbs_SOLID, solids_);
    }

    Result<BrepModel> build()
    {
        if (faces_.IsEmpty() && !solids_.IsEmpty())
            return broken(nameOf(BrepSolidId(0u)), "the solid is empty, the model has no face");
        if (faces_.IsEmpty()) {
            return Error{ErrorCode::DegenerateInput,
                         "the model has no face",
                         "",
                         {},
                         "export solids, shells or faces"};
        }
        if (auto added = addVertices(); !added) return added.error();
        for (int i = 1; i <= edges_.Extent(); ++i) {
            const std::string name = nameOf(BrepEdgeId(static_cast<std::uint32_t>(i - 1)));
            auto added = guarded(name, kRepairRemedy, [&] { return addEdge(TopoDS::Edge(edges_(i)), name); });
            if (!added) return added.error();
        }
        for (int i = 1; i <= faces_.Extent(); ++i) {
            const std::string name = nameOf(BrepFaceId(static_cast<std::uint32_t>(i - 1)));
            auto added = guarded(name, kRepairRemedy, [&] { return addFace(TopoDS::Face(faces_(i)), name); });
            if (!added) return added.error();
        }
        noteGaps();
        addSolids();
        noteStrayEntities();
        model_.box = boxOf(model_);
        return std::move(model_);
    }

private:
    void note(const std::string& entity, const std::string& text)
    {
        model_.notes.push_back(entity + " " + text);
    }

    Result<void> addVertices()
    {
        for (int i = 1; i <= vertices_.Extent(); ++i) {
            const TopoDS_Vertex& vertex = TopoDS::Vertex(vertices_(i));
            const BrepVertex added = {toVec(BRep_Tool::Pnt(vertex)), BRep_Tool::Tolerance(vertex)};
            if (!isFinite(added.position)) {
                return broken(nameOf(BrepVertexId(static_cast<std::uint32_t>(i - 1))),
                              "the vertex is at no finite place");
            }
            model_.vertices.push_back(added);
        }
        return {};
    }

    Result<void> addEdge(const TopoDS_Edge& found, const std::string& name)
    {
        const TopoDS_Edge edge = TopoDS::Edge(found.Oriented(TopAbs_FORWARD));
        BrepEdge result;
        result.first = idIn<BrepVertexId>(vertices_, TopExp::FirstVertex(edge));
        result.last = idIn<BrepVertexId>(vertices_, TopExp::LastVertex(edge));
        if (!result.first.isValid() || !result.last.isValid())
            return broken(name, "the edge has no vertex at an end");
        result.tolerance = BRep_Tool::Tolerance(edge);
        result.isDegenerate = BRep_Tool::Degenerated(edge);
        double first = 0.0, last = 0.0;
        Handle(Geom_Curve) geometry = BRep_Tool::Curve(edge, first, last);
        if (!result.isDegenerate && geometry.IsNull()) {
            return broken(name, "the edge has no curve in space");
        }
        if (result.isDegenerate) {
            BRep_Tool::Range(edge, first, last);
        }
        result.part = {first, last};
        if (!(first < last) || Precision::IsInfinite(first) || Precision::IsInfinite(last)) {
            return broken(name, "the edge's range is empty or has no end");
        }
        if (!result.isDegenerate) {
            result.curve = makeCurve(name, geometry, result.part);
            for (const double share : {0.0, 0.5, 1.0}) {
                if (!isFinite(result.curve->position(result.part.at(share))))
                    return broken(name, "the edge's curve has places that are not finite");
            }
            noteEnds(result, name);
        }
        if (!BRep_Tool::SameParameter(edge) && !result.isDegenerate)
            note(name, "is not parametrised alike on its faces");
        model_.edges.push_back(std::move(result));
        return {};
    }

    void noteEnds(const BrepEdge& edge, const std::string& name)
    {
        const std::pair<double, BrepVertexId> ends[] = {{edge.part.first, edge.first},
                                                        {edge.part.last, edge.last}};
        for (const auto& [t, id] : ends) {
            const BrepVertex& vertex = model_.vertices[id];
            const double gap = length(edge.curve->position(t) - vertex.position);
            if (gap > std::max(vertex.tolerance, edge.tolerance)) {
                note(name, "ends " + roughNumber(gap) + " away from " + nameOf(id));
            }
        }
    }

    Result<void> addFace(const TopoDS_Face& found, const std::string& name)
    {
        const TopoDS_Face face = TopoDS::Face(found.Oriented(TopAbs_FORWARD));
        const Handle(Geom_Surface) geometry = BRep_Tool::Surface(face);
        if (geometry.IsNull()) return broken(name, "the face has no surface");
        BrepFace result;
        double u0 = 0.0, u1 = 0.0, v0 = 0.0, v1 = 0.0;
        BRepTools::UVBounds(face, u0, u1, v0, v1);
        result.boundsU = {u0, u1};
        result.boundsV = {v0, v1};
        const bool isEndless = Precision::IsInfinite(u0) || Precision::IsInfinite(u1) ||
                               Precision::IsInfinite(v0) || Precision::IsInfinite(v1);
        if (isEndless || !(u0 < u1) || !(v0 < v1)) return broken(name, "the face has no area or no end");
        result.surface = makeSurface(name, geometry, result.boundsU, result.boundsV);
        result.isReversed = found.Orientation() == TopAbs_REVERSED;
        result.tolerance = BRep_Tool::Tolerance(face);
        auto loops = addLoops(face, result, name);
        if (!loops) return loops.error();
        result.trim = makeTrim(name, face, result);
        model_.faces.push_back(std::move(result));
        return {};
    }

    Result<void> addLoops(const TopoDS_Face& face, BrepFace& result, const std::string& name)
    {
        for (TopoDS_Iterator part(face); part.More(); part.Next()) {
            if (part.Value().ShapeType() == TopAbs_VERTEX) {
                result.embeddedVertices.push_back(idIn<BrepVertexId>(vertices_, part.Value()));
            }
            if (part.Value().ShapeType() != TopAbs_WIRE) continue;
            auto coedges = coedgesOf(part.Value(), face, result, name);
            if (!coedges) return coedges.error();
            leaveOutFalsePoles(*coedges, result, name);
            if (coedges->empty()) continue;
            OrderedWire wire = orderWire(model_, *std::move(coedges));
            for (const BrepVertexId open : wire.openVertices)
                note(name, "has a wire that is open at " + nameOf(open));
            for (BrepLoop& loop : wire.loops) result.loops.push_back(std::move(loop));
        }
        if (result.loops.empty()) return broken(name, "the face has no wire");
        return {};
    }

    Result<std::vector<BrepCoedge>> coedgesOf(const TopoDS_Shape& wire, const TopoDS_Face& face,
                                              BrepFace& result, const std::string& name)
    {
        std::vector<BrepCoedge> coedges;
        for (TopoDS_Iterator part(wire); part.More(); part.Next()) {
            if (part.Value().ShapeType() != TopAbs_EDGE) continue;
            const TopoDS_Edge& edge = TopoDS::Edge(part.Value());
            const BrepEdgeId id = idIn<BrepEdgeId>(edges_, edge);
            if (edge.Orientation() != TopAbs_FORWARD && edge.Orientation() != TopAbs_REVERSED) {
                result.embeddedEdges.push_back(id);
                continue;
            }
            BrepCoedge coedge{id, edge.Orientation() == TopAbs_REVERSED,
                              parameterCurve(edge, face, id, result, name), 0.0};
            if (!coedge.parameterCurve) return broken(name, nameOf(id) + " has no parameter curve on it");
            fitting_.fit(coedge, result);
            coedges.push_back(std::move(coedge));
        }
        return coedges;
    }

    /// Vertices of a wide tolerance make readers mark a whole closed edge as a pole, and add that beside the edge.
    void leaveOutFalsePoles(std::vector<BrepCoedge>& coedges, const BrepFace& face, const std::string& name)
    {
        const auto isFalse = [&](const BrepCoedge& pole) {
            return model_.edges[pole.edge].isDegenerate &&
                   std::any_of(coedges.begin(), coedges.end(), [&](const BrepCoedge& other) {
                       return runsAlong(pole, model_.edges[other.edge], face);
                   });
        };
        std::vector<BrepEdgeId> found;
        for (const BrepCoedge& coedge : coedges) {
            if (isFalse(coedge)) found.push_back(coedge.edge);
        }
        for (const BrepEdgeId id : found) {
            note(nameOf(id), "is marked as a pole of " + name + " and runs along another edge, left out");
            std::erase_if(coedges, [&](const BrepCoedge& coedge) { return coedge.edge == id; });
        }
    }

    /// Does the pole have an extent, which is that of a closed edge at its vertex?
    [[nodiscard]] bool runsAlong(const BrepCoedge& pole, const BrepEdge& edge, const BrepFace& face) const
    {
        constexpr int kSamples = 16;
        const BrepEdge& own = model_.edges[pole.edge];
        const double close = std::max({Precision::Confusion(), edge.tolerance, face.tolerance});
        if (edge.isDegenerate || edge.first != own.first || edge.last != own.first ||
            pole.gap <= 10.0 * close)
            return false;
        for (int i = 0; i <= kSamples; ++i) {
            const Vec2 uv = pole.parameterCurve->position(own.part.at(static_cast<double>(i) / kSamples));
            if (edge.curve->project(face.surface->position(uv), edge.part).distance > close) return false;
        }
        return true;
    }

    std::shared_ptr<const ParameterCurve> parameterCurve(const TopoDS_Edge& edge, const TopoDS_Face& face,
                                                         BrepEdgeId id, const BrepFace& result,
                                                         const std::string& name) const
    {
        double first = 0.0, last = 0.0;
        bool isStored = false;
        const Handle(Geom2d_Curve) geometry = BRep_Tool::CurveOnSurface(edge, face, first, last, &isStored);
        const BrepEdge& own = model_.edges[id];
        const std::optional<PlaneFrame> frame = result.surface->planeFrame();
        if (frame && own.curve && (geometry.IsNull() || !isStored)) {
            return std::make_shared<PlanarParameterCurve>(own.curve->clone(), *frame);
        }
        if (geometry.IsNull()) return nullptr;
        return makeParameterCurve(nameOf(id) + " on " + name, geometry, {first, last}, own.part);
    }

    void noteGaps()
    {
        for (std::uint32_t f = 0; f < model_.faces.size(); ++f) {
            for (const BrepLoop& loop : model_.faces[BrepFaceId(f)].loops) {
                for (const BrepCoedge& coedge : loop.coedges) fitting_.noteGaps(coedge, BrepFaceId(f));
            }
        }
    }

    /// Lies in a solid and bounds nothing of it.
    static bool isInner(const TopoDS_Shape& face)
    {
        return face.Orientation() == TopAbs_INTERNAL || face.Orientation() == TopAbs_EXTERNAL;
    }

    /// Of the faces that bound what the shell is of, or of the others.
    BrepShell makeShell(const TopoDS_Shape& shell, bool takesInner = false) const
    {
        BrepShell result;
        for (TopExp_Explorer face(shell, TopAbs_FACE); face.More(); face.Next()) {
            if (isInner(face.Current()) != takesInner) continue;
            const bool isReversed = face.Current().Orientation() == TopAbs_REVERSED;
            result.faces.push_back({idIn<BrepFaceId>(faces_, face.Current()), isReversed});
        }
        result.isClosed = BRep_Tool::IsClosed(shell);
        return result;
    }

    void addSolids()
    {
        for (int i = 1; i <= solids_.Extent(); ++i) {
            BrepSolid solid;
            for (TopExp_Explorer shell(solids_(i), TopAbs_SHELL); shell.More(); shell.Next()) {
                if (BrepShell bounds = makeShell(shell.Current()); !bounds.faces.empty())
                    solid.shells.push_back(std::move(bounds));
                if (BrepShell inner = makeShell(shell.Current(), true); !inner.faces.empty())
                    model_.looseShells.push_back(std::move(inner));
            }
            model_.solids.push_back(std::move(solid));
        }
        TopTools_IndexedMapOfShape seen;
        for (TopExp_Explorer shell(shape_, TopAbs_SHELL, TopAbs_SOLID); shell.More(); shell.Next()) {
            if (!seen.Contains(shell.Current())) {
                for (const bool takesInner : {false, true}) {
                    if (BrepShell loose = makeShell(shell.Current(), takesInner); !loose.faces.empty())
                        model_.looseShells.push_back(std::move(loose));
                }
            }
            seen.Add(shell.Current());
        }
        for (TopExp_Explorer face(shape_, TopAbs_FACE, TopAbs_SHELL); face.More(); face.Next()) {
            if (!seen.Contains(face.Current()))
                model_.looseShells.push_back(makeShell(face.Current(), isInner(face.Current())));
            seen.Add(face.Current());
        }
    }

    /// Edges and vertices that bound nothing are no part of any mesh.
    void noteStrayEntities()
    {
        std::vector<std::string> stray;
        TopTools_IndexedDataMapOfShapeListOfShape facesOfEdge, edgesOfVertex, facesOfVertex;
        TopExp::MapShapesAndAncestors(shape_, TopAbs_EDGE, TopAbs_FACE, facesOfEdge);
        TopExp::MapShapesAndAncestors(shape_, TopAbs_VERTEX, TopAbs_EDGE, edgesOfVertex);
        TopExp::MapShapesAndAncestors(shape_, TopAbs_VERTEX, TopAbs_FACE, facesOfVertex);
        const auto boundsNothing = [](const TopTools_IndexedDataMapOfShapeListOfShape& map,
                                      const TopoDS_Shape& shape) {
            const int i = map.FindIndex(shape);
            return i == 0 || map(i).IsEmpty();
        };
        for (int i = 1; i <= edges_.Extent(); ++i) {
            if (boundsNothing(facesOfEdge, edges_(i)))
                stray.push_back(nameOf(BrepEdgeId(static_cast<std::uint32_t>(i - 1))));
        }
        for (int i = 1; i <= vertices_.Extent(); ++i) {
            if (boundsNothing(edgesOfVertex, vertices_(i)) && boundsNothing(facesOfVertex, vertices_(i)))
                stray.push_back(nameOf(BrepVertexId(static_cast<std::uint32_t>(i - 1))));
        }
        if (!stray.empty())
            note(listOf(stray),
                 stray.size() == 1 ? "bounds no face and is not meshed" : "bound no face and are not meshed");
    }

    TopoDS_Shape shape_;
    TopTools_IndexedMapOfShape vertices_;
    TopTools_IndexedMapOfShape edges_;
    TopTools_IndexedMapOfShape faces_;
    TopTools_IndexedMapOfShape solids_;
    BrepModel model_;
    EdgeFitting fitting_{model_};
};

}  // namespace

Result<BrepModel> buildModel(const TopoDS_Shape& shape)
{
    if (shape.IsNull()) {
        return Error{ErrorCode::DegenerateInput, "the shape is null", "", {}, "export the model again"};
    }
    return guarded("the model", kRepairRemedy, [&] { return ModelBuilder(shape).build(); });
}

}  // namespace mesher
