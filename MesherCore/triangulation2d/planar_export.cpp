#include "triangulation2d/planar_export.h"

#include <vector>

namespace mesher {
namespace {

class Export
{
public:
    Export(const PlanarDomain& domain, const PlanarTriangulation& triangulation,
           std::span<const EntityRef> faces)
        : domain_(domain), t_(triangulation), faces_(faces), nodes_(triangulation.mesh().vertexSlots())
    {
    }

    ClassifiedMesh run()
    {
        for (std::uint32_t i = 0; i < t_.mesh().triangleSlots(); ++i) {
            const TriangleId id(i);
            if (!t_.mesh().isAlive(id) || !t_.isMeshed(id)) continue;
            const Triangle2d& record = t_.mesh().triangle(id);
            MESHER_PRECONDITION(record.region.value <= faces_.size());
            const EntityRef face = faces_[record.region.value - 1];
            mesh_.triangles.push_back(
                {{node(record.v[0], face), node(record.v[1], face), node(record.v[2], face)}, face});
        }
        addLines();
        addPoints();
        return std::move(mesh_);
    }

private:
    NodeId node(VertexId v, EntityRef face)
    {
        if (nodes_[v].isValid()) return nodes_[v];
        MeshNode result;
        const BoundaryVertexId b = t_.boundaryVertexOf(v);
        if (!b.isValid()) {
            result.position = domain_.toSpace(t_.mesh().position(v));
            result.entity = face;
            result.parameters = (1.0 / t_.scale) * t_.mesh().position(v);
        } else {
            const BoundaryVertex& vertex = t_.boundary.vertices[b];
            result.position = vertex.space;
            if (vertex.point.isValid()) {
                result.entity = {0, domain_.complex().points[vertex.point.value].vertex.value};
            } else {
                result.entity = {1, domain_.curve(vertex.curve).edge.value};
                result.parameters.x = vertex.parameter;
            }
        }
        nodes_[v] = mesh_.nodes.push_back(result);
        return nodes_[v];
    }

    /// Curves that bound no meshed region leave no lines.
    void addLines()
    {
        for (std::uint32_t i = 0; i < t_.boundary.subcurves.size(); ++i) {
            const SubcurveId s(i);
            const Subcurve& subcurve = t_.boundary.subcurves[s];
            const PccCurve& curve = domain_.curve(subcurve.curve);
            if (!subcurve.isAlive || (curve.left.value == 0 && curve.right.value == 0)) continue;
            mesh_.lines.push_back(
                {{nodes_[t_.firstVertex(s)], nodes_[t_.lastVertex(s)]}, {1, curve.edge.value}});
        }
    }

    void addPoints()
    {
        for (const BoundaryVertex& vertex : t_.boundary.vertices) {
            if (!vertex.point.isValid() || !nodes_[vertex.vertex].isValid()) continue;
            const BrepVertexId entity = domain_.complex().points[vertex.point.value].vertex;
            mesh_.points.push_back({{nodes_[vertex.vertex]}, {0, entity.value}});
        }
    }

    const PlanarDomain& domain_;
    const PlanarTriangulation& t_;
    std::span<const EntityRef> faces_;
    IdVector<VertexId, NodeId> nodes_;
    ClassifiedMesh mesh_;
};

}  // namespace

ClassifiedMesh exportPlanarMesh(const PlanarDomain& domain, const PlanarTriangulation& triangulation,
                                std::span<const EntityRef> faces)
{
    return Export(domain, triangulation, faces).run();
}

}  // namespace mesher
