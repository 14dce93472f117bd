#include "pipeline/classify_planar.h"

#include "pipeline/curve_quadrature.h"

#include <algorithm>
#include <utility>

namespace mesher {

namespace {

class PlanarClassifier
{
public:
    PlanarClassifier(const PlanarCurveComplex& complex, const PlanarTriangulation& triangulation)
        : complex_(complex), triangulation_(triangulation), nodeOf_(triangulation.mesh().vertexSlots())
    {
        for (const std::string& name : complex.regionNames) {
            faces_.push_back(entityNamed(name).value_or(EntityRef{2, EntityRef::kNone}));
        }
    }

    PlanarMesh classify(int boundaryOrder)
    {
        makeNodes();
        makeTriangles();
        makeLines(boundaryOrder);
        return std::move(result_);
    }

private:
    [[nodiscard]] EntityRef faceOf(RegionId region) const
    {
        return region.value == 0 ? EntityRef{2, EntityRef::kNone} : faces_[region.value - 1];
    }

    template <class Visit>
    void forMeshedTriangles(Visit visit) const
    {
        const Triangulation2d& mesh = triangulation_.mesh();
        for (std::uint32_t i = 0; i < mesh.triangleSlots(); ++i) {
            const TriangleId id(i);
            if (mesh.isAlive(id) && triangulation_.isMeshed(id)) visit(mesh.triangle(id));
        }
    }

    /// A node for each vertex of a meshed triangle; the face of a vertex inside of one is that of its triangles.
    void makeNodes()
    {
        const Triangulation2d& mesh = triangulation_.mesh();
        IdVector<VertexId, RegionId> regionAt(mesh.vertexSlots());
        forMeshedTriangles([&](const Triangle2d& triangle) {
            for (const VertexId v : triangle.v) regionAt[v] = triangle.region;
        });
        for (std::uint32_t i = 0; i < mesh.vertexSlots(); ++i) {
            const VertexId v(i);
            if (!mesh.isAlive(v) || !regionAt[v].isValid()) continue;
            nodeOf_[v] = result_.mesh.nodes.push_back(nodeAt(v, regionAt[v]));
            const EntityRef entity = result_.mesh.nodes[nodeOf_[v]].entity;
            if (entity.dimension == 0) result_.mesh.points.push_back({{nodeOf_[v]}, entity});
        }
    }

    [[nodiscard]] MeshNode nodeAt(VertexId v, RegionId region) const
    {
        const BoundaryVertexId boundary = triangulation_.boundaryVertexOf(v);
        if (!boundary.isValid()) {
            const Vec2 place = (1.0 / triangulation_.scale) * triangulation_.mesh().position(v);
            return {complex_.frame.toSpace(place), faceOf(region), place};
        }
        const BoundaryVertex& vertex = triangulation_.boundary.vertices[boundary];
        if (vertex.point.isValid()) {
            return {vertex.space, {0, complex_.points[vertex.point.value].vertex.value}, {}};
        }
        return {vertex.space, {1, complex_.curves[vertex.curve.value].edge.value}, {vertex.parameter, 0.0}};
    }

    void makeTriangles()
    {
        forMeshedTriangles([&](const Triangle2d& triangle) {
            result_.mesh.triangles.push_back(
                {{nodeOf_[triangle.v[0]], nodeOf_[triangle.v[1]], nodeOf_[triangle.v[2]]},
                 faceOf(triangle.region)});
        });
    }

    void makeLines(int boundaryOrder)
    {
        const Boundary& boundary = triangulation_.boundary;
        std::vector<SubcurveId> subcurves;
        for (std::uint32_t i = 0; i < boundary.subcurves.size(); ++i) {
            const Subcurve& subcurve = boundary.subcurves[SubcurveId(i)];
            const PccCurve& curve = complex_.curves[subcurve.curve.value];
            const bool isMeshed = curve.left.value != 0 || curve.right.value != 0;
            if (subcurve.isAlive && isMeshed) subcurves.push_back(SubcurveId(i));
        }
        std::sort(subcurves.begin(), subcurves.end(), [&](SubcurveId a, SubcurveId b) {
            const Subcurve& left = boundary.subcurves[a];
            const Subcurve& right = boundary.subcurves[b];
            return std::pair(left.curve, left.part.first) < std::pair(right.curve, right.part.first);
        });
        result_.boundary.order = boundaryOrder;
        for (const SubcurveId id : subcurves) addLine(id, boundaryOrder);
    }

    void addLine(SubcurveId id, int boundaryOrder)
    {
        const Subcurve& subcurve = triangulation_.boundary.subcurves[id];
        const PccCurve& curve = complex_.curves[subcurve.curve.value];
        CurvedBoundaryEdge edge;
        edge.curve = {1, curve.edge.value};
        edge.node = {nodeOf_[triangulation_.firstVertex(id)], nodeOf_[triangulation_.lastVertex(id)]};
        edge.parameter = {subcurve.part.first, subcurve.part.last};
        edge.left = faceOf(curve.left);
        edge.right = faceOf(curve.right);
        placeGaussPoints(*curve.curve, complex_.frame.normal, boundaryOrder, edge);
        result_.mesh.lines.push_back({edge.node, edge.curve});
        result_.boundary.edges.push_back(std::move(edge));
    }

    const PlanarCurveComplex& complex_;
    const PlanarTriangulation& triangulation_;
    std::vector<EntityRef> faces_;
    IdVector<VertexId, NodeId> nodeOf_;
    PlanarMesh result_;
};

}  // namespace

PlanarMesh classifyPlanar(const PlanarCurveComplex& complex, const PlanarTriangulation& triangulation,
                          int boundaryOrder)
{
    return PlanarClassifier(complex, triangulation).classify(boundaryOrder);
}

}  // namespace mesher
