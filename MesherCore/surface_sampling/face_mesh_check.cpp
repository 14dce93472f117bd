#include "surface_sampling/face_mesh_check.h"

#include "surface_sampling/facet_measures.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <string>

namespace mesher {
namespace {

std::string nameOf(EdgeLink side)
{
    return "side " + std::to_string(side.edge()) + " of triangle " + std::to_string(side.triangle().value);
}

class Checker
{
public:
    Checker(const FaceMesh& mesh, const FaceGeometry& geometry) : mesh_(mesh), geometry_(geometry) {}

    FaceMeshCheck run()
    {
        corners_.resize(mesh_.vertexSlots());
        component_.resize(mesh_.triangleSlots());
        std::iota(component_.begin(), component_.end(), 0u);
        for (std::uint32_t i = 0; i < mesh_.triangleSlots(); ++i) {
            if (mesh_.triangle(TriangleId(i)).isAlive) checkTriangle(TriangleId(i));
        }
        for (std::uint32_t i = 0; i < mesh_.triangleSlots(); ++i) {
            if (mesh_.triangle(TriangleId(i)).isAlive && component_[i] == i) ++result_.components;
        }
        // Nothing can be walked around where links are broken.
        const bool areLinksSound = result_.report.isValid();
        for (std::uint32_t i = 0; i < mesh_.vertexSlots(); ++i) {
            if (!mesh_.vertex(VertexId(i)).isAlive) continue;
            ++result_.vertices;
            if (areLinksSound) checkVertex(VertexId(i));
        }
        result_.edges = ends_.size();
        return result_;
    }

private:
    void fail(const std::string& what) { result_.report.add(what); }

    void checkTriangle(TriangleId t)
    {
        ++result_.triangles;
        const FaceTriangle& record = mesh_.triangle(t);
        for (unsigned i = 0; i < 3; ++i) {
            if (!mesh_.vertex(record.v[i]).isAlive)
                fail("triangle " + std::to_string(t.value) + " has a dead corner");
            if (record.v[i] == record.v[nextCorner(i)])
                fail("triangle " + std::to_string(t.value) + " repeats a corner");
            ++corners_[record.v[i].value];
            checkParameters(record, i);
            checkSide(EdgeLink(t, i));
        }
        const double agreement =
            normalAgreement(mesh_.vertex(record.v[0]), mesh_.vertex(record.v[1]), mesh_.vertex(record.v[2]));
        result_.leastNormalAgreement = std::min(result_.leastNormalAgreement, agreement);
    }

    void checkParameters(const FaceTriangle& record, unsigned corner)
    {
        const double distance =
            length(geometry_.surface().position(record.uv[corner]) - mesh_.position(record.v[corner]));
        result_.largestDistance = std::max(result_.largestDistance, distance);
        const unsigned next = nextCorner(corner);
        if (mesh_.vertex(record.v[corner]).isPole() || mesh_.vertex(record.v[next]).isPole()) return;
        const Vec2 spread = record.uv[next] - record.uv[corner];
        const Vec2 periods = geometry_.periods();
        if ((periods.x > 0.0 && 2.0 * std::abs(spread.x) > periods.x) ||
            (periods.y > 0.0 && 2.0 * std::abs(spread.y) > periods.y)) {
            fail("vertices " + std::to_string(record.v[corner].value) + " and " +
                 std::to_string(record.v[next].value) + " have parameters in different images of the face");
        }
    }

    void checkSide(EdgeLink side)
    {
        const VertexId a = mesh_.from(side), b = mesh_.to(side);
        const auto [uses, isNew] = ends_.insert(a < b ? std::pair(a, b) : std::pair(b, a), 0);
        if (++*uses > 2) fail(nameOf(side) + " is an edge of three triangles");
        const EdgeLink other = mesh_.across(side);
        if (!other.isValid()) {
            if (!mesh_.segment(side).isValid()) fail(nameOf(side) + " is at the border and no segment");
            return;
        }
        if (!mesh_.triangle(other.triangle()).isAlive || mesh_.across(other) != side) {
            fail(nameOf(side) + " is not linked both ways");
            return;
        }
        if (mesh_.from(other) != b || mesh_.to(other) != a) fail(nameOf(side) + " is linked to another edge");
        if (mesh_.segment(other) != mesh_.segment(side))
            fail(nameOf(side) + " is a segment on one side only");
        join(side.triangle(), other.triangle());
        if (side.triangle() < other.triangle() && !mesh_.segment(side).isValid() &&
            oppositeAngleExcess(mesh_.position(a), mesh_.position(b), mesh_.position(mesh_.apex(side)),
                                mesh_.position(mesh_.apex(other))) > 1e-6) {
            ++result_.nonDelaunayEdges;
        }
    }

    void checkVertex(VertexId v)
    {
        const TriangleId t = mesh_.vertex(v).triangle;
        if (!t.isValid() || !mesh_.triangle(t).isAlive ||
            mesh_.triangle(t).v[mesh_.triangle(t).cornerOf(v)] != v) {
            fail("vertex " + std::to_string(v.value) + " names no triangle of its own");
            return;
        }
        std::size_t around = 0;
        mesh_.forEachTriangleAround(v, [&](EdgeLink) { ++around; });
        if (around != corners_[v.value])
            fail("the triangles around vertex " + std::to_string(v.value) + " are no disk");
    }

    std::uint32_t rootOf(std::uint32_t i)
    {
        while (component_[i] != i) i = component_[i] = component_[component_[i]];
        return i;
    }
    void join(TriangleId a, TriangleId b)
    {
        const std::uint32_t ra = rootOf(a.value), rb = rootOf(b.value);
        component_[std::max(ra, rb)] = std::min(ra, rb);
    }

    const FaceMesh& mesh_;
    const FaceGeometry& geometry_;
    FaceMeshCheck result_;
    std::vector<std::size_t> corners_;
    std::vector<std::uint32_t> component_;
    IndexedMap<std::pair<VertexId, VertexId>, int> ends_;
};

}  // namespace

FaceMeshCheck checkFaceMesh(const FaceMesh& mesh, const FaceGeometry& geometry)
{
    return Checker(mesh, geometry).run();
}

}  // namespace mesher
