#include "delaunay/delaunay_check2d.h"

#include "delaunay/flips2d.h"
#include "predicates/incircle.h"
#include "predicates/orient2d.h"

#include <vector>

namespace mesher {
namespace {

std::string describe(TriangleId t) { return "triangle " + std::to_string(t.value); }

std::string describe(VertexId v) { return "vertex " + std::to_string(v.value); }

/// Goes through the triangulation until the first violation.
class TopologyCheck
{
public:
    explicit TopologyCheck(const Triangulation2d& mesh) : mesh_(mesh) {}

    CheckReport run()
    {
        for (std::uint32_t i = 0; i < mesh_.triangleSlots() && report_.isValid(); ++i) {
            if (mesh_.isAlive(TriangleId(i))) visit(TriangleId(i));
        }
        if (report_.isValid()) visitVertices();
        if (report_.isValid()) checkCounts();
        return report_;
    }

private:
    void visit(TriangleId t)
    {
        const Triangle2d& record = mesh_.triangle(t);
        if (record.v[0] == kGhostVertex || record.v[1] == kGhostVertex) {
            return fail(describe(t) + " has the ghost vertex in slot 0 or 1");
        }
        for (const VertexId v : record.v) {
            if (v != kGhostVertex && !mesh_.isAlive(v)) return fail(describe(t) + " has dead " + describe(v));
        }
        if (record.v[0] == record.v[1] || record.v[1] == record.v[2] || record.v[2] == record.v[0]) {
            return fail(describe(t) + " has a corner twice");
        }
        for (unsigned edge = 0; edge < 3 && report_.isValid(); ++edge) visitEdge(EdgeLink(t, edge));
        if (!report_.isValid()) return;
        if (record.isGhost()) {
            ++hullEdges_;
            checkHullCorner(t);
        } else {
            ++finiteTriangles_;
            checkOrientation(t);
        }
    }

    void visitEdge(EdgeLink e)
    {
        const EdgeLink other = mesh_.across(e);
        const std::string name = describe(e.triangle()) + " edge " + std::to_string(e.edge());
        if (other.edge() > 2 || !mesh_.isAlive(other.triangle()))
            return fail(name + " links to nothing alive");
        if (mesh_.across(other) != e) return fail(name + " is not linked back");
        if (mesh_.edgeFrom(e) != mesh_.edgeTo(other) || mesh_.edgeTo(e) != mesh_.edgeFrom(other)) {
            return fail(name + " has other ends on its other side");
        }
        if (mesh_.isConstrained(e) != mesh_.isConstrained(other))
            return fail(name + " is constrained on one side only");
        if (!mesh_.isConstrained(e)) return;
        if (mesh_.edgeFrom(e) == kGhostVertex || mesh_.edgeTo(e) == kGhostVertex) {
            return fail(name + " is constrained and leads to the ghost vertex");
        }
    }

    void checkOrientation(TriangleId t)
    {
        const Triangle2d& record = mesh_.triangle(t);
        const Sign sign =
            orient2d(mesh_.position(record.v[0]), mesh_.position(record.v[1]), mesh_.position(record.v[2]));
        if (sign != Sign::Positive) fail(describe(t) + " is not positively oriented");
    }

    /// The hull must not turn inwards where the hull edges of t and of the next ghost meet.
    void checkHullCorner(TriangleId t)
    {
        const Triangle2d& record = mesh_.triangle(t);
        const Triangle2d& next = mesh_.triangle(record.n[1].triangle());
        if (!next.isGhost()) return fail(describe(t) + ": a ghost edge leads to a finite triangle");
        const Sign sign =
            orient2d(mesh_.position(next.v[0]), mesh_.position(next.v[1]), mesh_.position(record.v[1]));
        if (sign == Sign::Positive) fail(describe(t) + ": the hull is not convex here");
    }

    void visitVertices()
    {
        for (std::uint32_t i = 0; i < mesh_.vertexSlots() && report_.isValid(); ++i) {
            const VertexId v(i);
            if (!mesh_.isAlive(v)) continue;
            const TriangleId t = mesh_.triangleAt(v);
            if (mesh_.triangleCount() == 0) {
                if (t.isValid()) fail(describe(v) + " names a triangle, and there are none");
                continue;
            }
            if (!mesh_.isAlive(t)) return fail(describe(v) + " names a dead triangle");
            const Triangle2d& record = mesh_.triangle(t);
            if (record.v[record.cornerOf(v)] != v)
                return fail(describe(v) + " names a triangle it is not in");
        }
    }

    /// A triangulated sphere, the ghost being a vertex of it.
    void checkCounts()
    {
        if (mesh_.triangleCount() == 0) return;
        const std::size_t total = finiteTriangles_ + hullEdges_;
        if (total != mesh_.triangleCount()) return fail("the count of alive triangles is wrong");
        if (total != 2 * (mesh_.vertexCount() + 1) - 4) fail("the counts break Euler's relation");
    }

    void fail(const std::string& violation) { report_.add(violation); }

    const Triangulation2d& mesh_;
    CheckReport report_;
    std::size_t finiteTriangles_ = 0;
    std::size_t hullEdges_ = 0;
};

}  // namespace

CheckReport checkTopology2d(const Triangulation2d& mesh) { return TopologyCheck(mesh).run(); }

CheckReport checkDelaunay2d(const Triangulation2d& mesh)
{
    CheckReport report = checkTopology2d(mesh);
    // A default-made filter leaves every decision to the exact tiers: slow, and independent of the kernel's boxes.
    const StaticFilter2d filter;
    for (std::uint32_t i = 0; i < mesh.triangleSlots() && report.isValid(); ++i) {
        if (!mesh.isAlive(TriangleId(i))) continue;
        for (unsigned edge = 0; edge < 3; ++edge) {
            if (isLocallyDelaunay(mesh, filter, EdgeLink(TriangleId(i), edge))) continue;
            report.add(describe(TriangleId(i)) + " edge " + std::to_string(edge) +
                       " is not locally Delaunay");
            break;
        }
    }
    return report;
}

CheckReport checkEmptyCircles2d(const Triangulation2d& mesh)
{
    CheckReport report = checkTopology2d(mesh);
    for (std::uint32_t i = 0; i < mesh.triangleSlots() && report.isValid(); ++i) {
        const Triangle2d& record = mesh.triangle(TriangleId(i));
        if (!record.isAlive() || record.isGhost()) continue;
        for (std::uint32_t k = 0; k < mesh.vertexSlots(); ++k) {
            const VertexId v(k);
            if (!mesh.isAlive(v) || record.v[record.cornerOf(v)] == v) continue;
            if (incircle(mesh.position(record.v[0]), mesh.position(record.v[1]), mesh.position(record.v[2]),
                         mesh.position(v)) != Sign::Positive) {
                continue;
            }
            report.add(describe(v) + " lies inside the circle of " + describe(TriangleId(i)));
            break;
        }
    }
    return report;
}

}  // namespace mesher
