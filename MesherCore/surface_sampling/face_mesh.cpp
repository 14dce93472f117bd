#include "surface_sampling/face_mesh.h"

#include <algorithm>
#include <array>
#include <string>
#include <vector>

namespace mesher {
namespace {

Error refuse(BrepFaceId face, const std::string& message, const Vec3& point)
{
    return {ErrorCode::IntersectingConstraints, message, nameOf(face), point,
            "repair the face's edges or sample them more finely"};
}

using SidesByEnds = IndexedMap<std::pair<VertexId, VertexId>, EdgeLink>;

/// Adds what the corners of facets say about vertices that several of them share.
class MeshBuilder
{
public:
    MeshBuilder(FaceMesh& mesh, const FaceGeometry& geometry, const IdVector<NodeId, MeshNode>& nodes,
                const SegmentsByEnds& segments, std::span<const NodeId> ringNodes)
        : mesh_(mesh), geometry_(geometry), nodes_(nodes), segments_(segments), ringNodes_(ringNodes)
    {
    }

    void addFacet(const SurfaceFacet& facet)
    {
        std::array<VertexId, 3> corners;
        for (std::size_t i = 0; i < 3; ++i) corners[i] = vertexOf(facet.node[i], facet.parameters[i]);
        const TriangleId t = mesh_.allocateTriangle();
        mesh_.writeTriangle(t, corners, facet.parameters);
        for (const VertexId corner : corners) mesh_.vertex(corner).triangle = t;
    }

    Result<void> linkAll(BrepFaceId face)
    {
        SidesByEnds sides;
        for (std::uint32_t i = 0; i < mesh_.triangleSlots(); ++i) {
            for (unsigned k = 0; k < 3; ++k) {
                const EdgeLink side(TriangleId(i), k);
                if (!sides.insert(std::pair(mesh_.from(side), mesh_.to(side)), side).second) {
                    return refuse(face, "two facets use one side in the same direction",
                                  mesh_.position(mesh_.from(side)));
                }
            }
        }
        for (const auto& [ends, side] : sides) {
            const NodeId a = mesh_.vertex(ends.first).node, b = mesh_.vertex(ends.second).node;
            const SegmentId* segment = segments_.find(a < b ? std::pair(a, b) : std::pair(b, a));
            if (segment != nullptr) mesh_.triangle(side.triangle()).s[side.edge()] = *segment;
            if (const EdgeLink* other = sides.find(std::pair(ends.second, ends.first))) {
                mesh_.link(side, *other);
            } else if (segment == nullptr) {
                return refuse(face, "a side of a facet at the border of the face is no piece of an edge",
                              mesh_.position(ends.first));
            }
        }
        return {};
    }

    /// Where the face touches itself in a node, each of the fans that meet there gets a vertex of its own.
    void separateFans()
    {
        IdVector<TriangleId, std::array<bool, 3>> isReached(mesh_.triangleSlots());
        const auto fanOf = [&](VertexId v, TriangleId start) {
            std::vector<EdgeLink> fan;
            mesh_.vertex(v).triangle = start;
            mesh_.forEachTriangleAround(v, [&](EdgeLink opposite) { fan.push_back(opposite); });
            for (const EdgeLink corner : fan) isReached[corner.triangle()][corner.edge()] = true;
            return fan;
        };
        const auto count = static_cast<std::uint32_t>(mesh_.vertexSlots());
        for (std::uint32_t v = 0; v < count; ++v) fanOf(VertexId(v), mesh_.vertex(VertexId(v)).triangle);
        for (std::uint32_t i = 0; i < mesh_.triangleSlots(); ++i) {
            for (unsigned k = 0; k < 3; ++k) {
                const TriangleId t(i);
                if (isReached[t][k]) continue;
                const VertexId whole = mesh_.triangle(t).v[k];
                const TriangleId kept = mesh_.vertex(whole).triangle;
                const std::vector<EdgeLink> fan = fanOf(whole, t);
                const VertexId own = mesh_.addVertex(mesh_.vertex(whole));
                mesh_.vertex(whole).triangle = kept;
                for (const EdgeLink corner : fan) mesh_.triangle(corner.triangle()).v[corner.edge()] = own;
            }
        }
    }

private:
    VertexId vertexOf(NodeId node, Vec2 uv)
    {
        const SurfaceFacts facts = geometry_.at(uv);
        if (const VertexId* known = vertexOf_.find(node)) {
            FaceVertex& vertex = mesh_.vertex(*known);
            vertex.keepNormal(facts.normal);
            vertex.curvatureRadius = std::min(vertex.curvatureRadius, facts.curvatureRadius);
            return *known;
        }
        FaceVertex vertex = FaceVertex::of(facts);
        vertex.position = nodes_[node].position;
        // Nodes inside of the face are the face's own until the faces are put together.
        vertex.isFree = nodes_[node].entity.dimension == 2;
        if (!vertex.isFree) vertex.node = node;
        vertex.isOnRing = std::binary_search(ringNodes_.begin(), ringNodes_.end(), node);
        if (vertex.isOnRing) mesh_.noteRing();
        const VertexId v = mesh_.addVertex(vertex);
        vertexOf_.insert(node, v);
        return v;
    }

    FaceMesh& mesh_;
    const FaceGeometry& geometry_;
    const IdVector<NodeId, MeshNode>& nodes_;
    const SegmentsByEnds& segments_;
    std::span<const NodeId> ringNodes_;
    IndexedMap<NodeId, VertexId> vertexOf_;
};

}  // namespace

FaceVertex FaceVertex::of(const SurfaceFacts& facts)
{
    FaceVertex vertex;
    vertex.position = facts.position;
    vertex.normal = facts.normal;
    vertex.curvatureRadius = facts.curvatureRadius;
    vertex.isSingularU = facts.isSingularU;
    vertex.isSingularV = facts.isSingularV;
    return vertex;
}

void FaceVertex::keepNormal(const Vec3& other)
{
    constexpr double kSame = 0.99;
    if (dot(normal, other) < kSame) normal = {};
}

Result<FaceMesh> FaceMesh::make(BrepFaceId face, const FaceGeometry& geometry,
                                std::span<const SurfaceFacet> facets, const IdVector<NodeId, MeshNode>& nodes,
                                const SegmentsByEnds& segments, std::span<const NodeId> ringNodes)
{
    FaceMesh mesh;
    mesh.face_ = face;
    MeshBuilder builder(mesh, geometry, nodes, segments, ringNodes);
    for (const SurfaceFacet& facet : facets) builder.addFacet(facet);
    if (Result<void> linked = builder.linkAll(face); !linked) return linked.error();
    builder.separateFans();
    return mesh;
}

bool FaceMesh::isOfFan(TriangleId t) const
{
    if (!hasRings_) return false;
    const auto& v = triangles_[t].v;
    for (unsigned i = 0; i < 3; ++i) {
        if (vertices_[v[i]].isPole()) return isOnRing(v[(i + 1) % 3], v[(i + 2) % 3]);
    }
    return false;
}

void FaceMesh::releaseFan(TriangleId t)
{
    for (const VertexId v : triangles_[t].v) vertices_[v].isOnRing = false;
}

void FaceMesh::removeVertex(VertexId v)
{
    vertices_[v].isAlive = false;
    ++deadVertices_;
}

TriangleId FaceMesh::allocateTriangle()
{
    if (freeTriangles_.empty()) return triangles_.push_back({});
    const TriangleId t = freeTriangles_.back();
    freeTriangles_.pop_back();
    return t;
}

void FaceMesh::freeTriangle(TriangleId t)
{
    triangles_[t].isAlive = false;
    ++triangles_[t].generation;
    freeTriangles_.push_back(t);
}

void FaceMesh::writeTriangle(TriangleId t, const std::array<VertexId, 3>& v, const std::array<Vec2, 3>& uv)
{
    FaceTriangle& record = triangles_[t];
    record.v = v;
    record.n = {};
    record.s = {};
    record.uv = uv;
    ++record.generation;
    record.isAlive = true;
    record.left = FacetLeft::No;
    record.isForced = false;
    for (unsigned i = 0; i < 3; ++i) {
        const FaceVertex& corner = vertices_[v[i]];
        const Vec2 a = uv[nextCorner(i)], b = uv[previousCorner(i)];
        if (corner.isSingularU) record.uv[i].x = 0.5 * (a.x + b.x);
        if (corner.isSingularV) record.uv[i].y = 0.5 * (a.y + b.y);
    }
}

void FaceMesh::link(EdgeLink a, EdgeLink b)
{
    triangles_[a.triangle()].n[a.edge()] = b;
    if (b.isValid()) triangles_[b.triangle()].n[b.edge()] = a;
}

Vec2 FaceMesh::shiftAcross(const FaceGeometry& geometry, EdgeLink side) const
{
    const Vec2 periods = geometry.periods();
    if (periods.x == 0.0 && periods.y == 0.0) return {};
    const EdgeLink other = across(side);
    const FaceTriangle& here = triangles_[side.triangle()];
    const FaceTriangle& there = triangles_[other.triangle()];
    unsigned mine = nextCorner(side.edge()), its = previousCorner(other.edge());
    if (vertices_[here.v[mine]].isPole()) {
        mine = previousCorner(side.edge());
        its = nextCorner(other.edge());
    }
    return geometry.shiftBetween(there.uv[its], here.uv[mine]);
}

EdgeLink FaceMesh::findSide(VertexId a, VertexId b) const
{
    EdgeLink found;
    forEachTriangleAround(a, [&](EdgeLink opposite) {
        if (from(opposite) == b) found = EdgeLink(opposite.triangle(), previousCorner(opposite.edge()));
    });
    return found;
}

}  // namespace mesher
