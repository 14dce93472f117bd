#include "delaunay/triangulation2d.h"

#include <utility>

namespace mesher {

VertexId Triangulation2d::addVertex(Vec2 position)
{
    if (firstFreeVertex_ == VertexId::kInvalid) {
        MESHER_PRECONDITION(vertices_.size() < kMaxVertices);
        origins_.push_back(static_cast<std::uint8_t>(VertexOrigin::Unset));
        return vertices_.push_back({position, 0.0, TriangleId(), 0});
    }
    const VertexId vertex(firstFreeVertex_);
    firstFreeVertex_ = vertices_[vertex].triangle.value;
    --freeVertices_;
    vertices_[vertex] = {position, 0.0, TriangleId(), 0};
    origins_[vertex] = static_cast<std::uint8_t>(VertexOrigin::Unset);
    return vertex;
}

void Triangulation2d::removeVertex(VertexId vertex)
{
    MESHER_PRECONDITION(isAlive(vertex));
    vertices_[vertex].triangle = TriangleId(firstFreeVertex_);
    origins_[vertex] = kFreeVertex;
    firstFreeVertex_ = vertex.value;
    ++freeVertices_;
}

void Triangulation2d::setOrigin(VertexId vertex, VertexOrigin origin, std::uint32_t entity)
{
    origins_[vertex] = static_cast<std::uint8_t>(origin);
    vertices_[vertex].entity = entity;
}

void Triangulation2d::freeTriangle(TriangleId t)
{
    Triangle2d& record = triangles_[t];
    MESHER_PRECONDITION(record.isAlive());
    record.flags = Triangle2d::kDead;
    ++record.generation;
    record.v[0] = VertexId(firstFreeTriangle_);
    firstFreeTriangle_ = t.value;
    ++freeTriangles_;
}

void Triangulation2d::freeAllTriangles()
{
    for (std::uint32_t i = static_cast<std::uint32_t>(triangles_.size()); i-- > 0;) {
        if (triangles_[TriangleId(i)].isAlive()) freeTriangle(TriangleId(i));
    }
    for (std::uint32_t i = 0; i < vertices_.size(); ++i) {
        if (isAlive(VertexId(i))) vertices_[VertexId(i)].triangle = TriangleId();
    }
}

void Triangulation2d::setConstrained(EdgeLink e, bool isConstrained)
{
    for (const EdgeLink side : {e, across(e)}) {
        Triangle2d& record = triangles_[side.triangle()];
        const auto bit = static_cast<std::uint16_t>(1u << side.edge());
        record.flags = static_cast<std::uint16_t>(isConstrained ? record.flags | bit : record.flags & ~bit);
    }
}

void Triangulation2d::link(EdgeLink a, EdgeLink b)
{
    triangles_[a.triangle()].n[a.edge()] = b;
    triangles_[b.triangle()].n[b.edge()] = a;
}

EdgeLink Triangulation2d::findEdge(VertexId a, VertexId b) const
{
    EdgeLink found;
    if (!triangleAt(a).isValid()) return found;
    forEachTriangleAround(a, [&](EdgeLink opposite) {
        const unsigned corner = opposite.edge();
        if (triangles_[opposite.triangle()].v[nextCorner(corner)] != b) return true;
        found = EdgeLink(opposite.triangle(), previousCorner(corner));
        return false;
    });
    return found;
}

void Triangulation2d::reserve(std::size_t vertexCount)
{
    vertices_.reserve(vertexCount);
    origins_.reserve(vertexCount);
    triangles_.reserve(2 * vertexCount + 4);
}

Triangulation2d::Renumbering Triangulation2d::compact()
{
    Renumbering map{IdVector<VertexId, VertexId>(vertices_.size()),
                    IdVector<TriangleId, TriangleId>(triangles_.size())};
    std::uint32_t vertexCount = 0;
    for (std::uint32_t i = 0; i < vertices_.size(); ++i) {
        if (isAlive(VertexId(i))) map.vertices[VertexId(i)] = VertexId(vertexCount++);
    }
    std::uint32_t triangleCount = 0;
    for (std::uint32_t i = 0; i < triangles_.size(); ++i) {
        if (triangles_[TriangleId(i)].isAlive()) map.triangles[TriangleId(i)] = TriangleId(triangleCount++);
    }
    IdVector<TriangleId, Triangle2d> triangles;
    triangles.reserve(triangleCount);
    for (Triangle2d record : triangles_) {
        if (!record.isAlive()) continue;
        for (VertexId& v : record.v) v = v == kGhostVertex ? v : map.vertices[v];
        for (EdgeLink& n : record.n) n = EdgeLink(map.triangles[n.triangle()], n.edge());
        triangles.push_back(record);
    }
    IdVector<VertexId, Vertex> vertices;
    IdVector<VertexId, std::uint8_t> origins;
    vertices.reserve(vertexCount);
    origins.reserve(vertexCount);
    for (std::uint32_t i = 0; i < vertices_.size(); ++i) {
        if (!isAlive(VertexId(i))) continue;
        Vertex record = vertices_[VertexId(i)];
        if (record.triangle.isValid()) record.triangle = map.triangles[record.triangle];
        vertices.push_back(record);
        origins.push_back(origins_[VertexId(i)]);
    }
    triangles_ = std::move(triangles);
    vertices_ = std::move(vertices);
    origins_ = std::move(origins);
    firstFreeTriangle_ = TriangleId::kInvalid;
    firstFreeVertex_ = VertexId::kInvalid;
    freeTriangles_ = 0;
    freeVertices_ = 0;
    return map;
}

std::size_t Triangulation2d::bytes() const
{
    return triangles_.capacity() * sizeof(Triangle2d) + vertices_.capacity() * sizeof(Vertex) +
           origins_.capacity() * sizeof(std::uint8_t);
}

}  // namespace mesher
