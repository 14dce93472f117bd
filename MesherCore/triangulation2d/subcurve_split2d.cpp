#include "triangulation2d/subcurve_split2d.h"

#include "delaunay/id_set.h"
#include "predicates/coordinate_range.h"
#include "predicates/orient2d.h"
#include "triangulation2d/boundary_intersection.h"
#include "triangulation2d/encroachment2d.h"

#include <algorithm>

namespace mesher {
namespace {

bool isStrictlyInside(Vec2 a, Vec2 b, Vec2 c, Vec2 p)
{
    const Sign turn = orient2d(a, b, c);
    return orient2d(a, b, p) == turn && orient2d(b, c, p) == turn && orient2d(c, a, p) == turn;
}

/// Whether an edge reaches into the triangle of a, p and b other than along its sides, or goes through p.
bool reachesInto(Vec2 a, Vec2 p, Vec2 b, Vec2 from, Vec2 to)
{
    return doSegmentsMeet(a, p, from, to) || doSegmentsMeet(p, b, from, to) ||
           isStrictlyInside(a, p, b, from) || isStrictlyInside(a, p, b, to);
}

double distanceToSegment(Vec2 p, Vec2 a, Vec2 b)
{
    const Vec2 edge = b - a;
    const double along = std::clamp(dot(p - a, edge) / squaredLength(edge), 0.0, 1.0);
    return length(p - (a + along * edge));
}

}  // namespace

SubcurveSplit2d SubcurveSplitter2d::split(SubcurveId s)
{
    SubcurveSplit2d result;
    touched_.clear();
    const auto place = splitPlace(domain_, t_.boundary, s);
    if (!place || !isInExactRange(place->place.position)) return result;
    const Vec2 point = place->place.position;
    const VertexId from = t_.firstVertex(s);
    const VertexId to = t_.lastVertex(s);
    const EdgeLink edge = t_.mesh().findEdge(from, to);
    if (const EdgeLink blocker = findBlocker(edge, point); blocker.isValid()) {
        ++counters_.blocked;
        if (!t_.isMeshed(blocker.triangle())) ++counters_.blockedAcrossUnmeshed;
        result.outcome = SplitOutcome2d::Blocked;
        result.blocker = t_.subcurveOf(blocker);
        return result;
    }
    result.removedVertices = removeFreeVertices(edge, point);
    // The removal has renamed triangles.
    const EdgeLink present = t_.mesh().findEdge(from, to);
    bool wasFlipped = false;
    const std::size_t flipsBefore = t_.delaunay.counters().flips;
    t_.delaunay.unconstrainEdge(present);
    wasFlipped = t_.delaunay.counters().flips != flipsBefore;
    const VertexId middle = insertPoint(point, present.triangle());
    if (!middle.isValid()) {
        // The point coincides with a vertex: the edge is put back.
        const bool isRecovered = t_.delaunay.recoverSegment(from, to).hasValue();
        MESHER_INVARIANT(isRecovered);
        static_cast<void>(isRecovered);
        return result;
    }
    connectHalf(from, middle, wasFlipped);
    connectHalf(middle, to, wasFlipped);
    t_.subcurveOfEdge.erase(unorderedPair(from, to));
    result.halves = t_.boundary.split(s, *place);
    t_.boundary.vertices[result.halves.vertex].vertex = middle;
    t_.delaunay.setOrigin(middle, VertexOrigin::Curve, result.halves.vertex.value);
    t_.subcurveOfEdge.insert(unorderedPair(from, middle), result.halves.first);
    t_.subcurveOfEdge.insert(unorderedPair(middle, to), result.halves.last);
    restoreRegions(result.halves.first, middle, wasFlipped);
    restoreRegions(result.halves.last, middle, wasFlipped);
    result.outcome = SplitOutcome2d::Split;
    ++counters_.splits;
    return result;
}

EdgeLink SubcurveSplitter2d::findBlocker(EdgeLink edge, Vec2 point)
{
    const Triangulation2d& mesh = t_.mesh();
    const Vec2 a = mesh.position(mesh.edgeFrom(edge));
    const Vec2 b = mesh.position(mesh.edgeTo(edge));
    const Sign side = orient2d(a, b, point);
    if (side == Sign::Zero) return {};
    stack_.assign(1, side == Sign::Positive ? edge : mesh.across(edge));
    IdSet visited;
    while (!stack_.empty()) {
        const EdgeLink entry = stack_.back();
        stack_.pop_back();
        const Triangle2d& record = mesh.triangle(entry.triangle());
        if (record.isGhost() || !visited.insert(entry.triangle().value)) continue;
        for (const unsigned other : {nextCorner(entry.edge()), previousCorner(entry.edge())}) {
            const EdgeLink exit(entry.triangle(), other);
            if (!reachesInto(a, point, b, mesh.position(mesh.edgeFrom(exit)),
                             mesh.position(mesh.edgeTo(exit)))) {
                continue;
            }
            if (record.isConstrained(other)) return exit;
            stack_.push_back(record.n[other]);
        }
    }
    return {};
}

std::size_t SubcurveSplitter2d::removeFreeVertices(EdgeLink edge, Vec2 point)
{
    doomed_.clear();
    const EdgeLink other = t_.mesh().across(edge);
    collectFreeVertices(edge, point);
    collectFreeVertices(other, point);
    for (const VertexId v : doomed_) {
        t_.mesh().forEachTriangleAround(v, [&](EdgeLink opposite) {
            touched_.push_back(t_.mesh().edgeFrom(opposite));
            return true;
        });
        const RemovalOutcome outcome = t_.delaunay.remove(v);
        MESHER_INVARIANT(outcome == RemovalOutcome::Removed);
        static_cast<void>(outcome);
    }
    counters_.removedVertices += doomed_.size();
    return doomed_.size();
}

void SubcurveSplitter2d::collectFreeVertices(EdgeLink side, Vec2 point)
{
    const Triangulation2d& mesh = t_.mesh();
    if (!t_.isMeshed(side.triangle())) return;
    const Vec2 a = mesh.position(mesh.edgeFrom(side));
    const Vec2 b = mesh.position(mesh.edgeTo(side));
    const Vec2 centre = 0.5 * (a + b);
    // The lens of a half can reach out of the circle by less than this.
    const double reach = 0.75 * length(b - a);
    stack_.assign(1, side);
    IdSet visited;
    while (!stack_.empty()) {
        const EdgeLink entry = stack_.back();
        stack_.pop_back();
        if (!visited.insert(entry.triangle().value)) continue;
        const Triangle2d& record = mesh.triangle(entry.triangle());
        const VertexId apex = record.v[entry.edge()];
        const Vec2 p = mesh.position(apex);
        if (mesh.origin(apex) == VertexOrigin::Face &&
            (isInDiametralCircle(a, b, p) || isInDiametralLens(a, point, p) ||
             isInDiametralLens(point, b, p)) &&
            std::find(doomed_.begin(), doomed_.end(), apex) == doomed_.end()) {
            doomed_.push_back(apex);
        }
        for (const unsigned other : {nextCorner(entry.edge()), previousCorner(entry.edge())}) {
            if (record.isConstrained(other)) continue;
            const Vec2 from = mesh.position(record.v[nextCorner(other)]);
            const Vec2 to = mesh.position(record.v[previousCorner(other)]);
            if (distanceToSegment(centre, from, to) < reach) stack_.push_back(record.n[other]);
        }
    }
}

VertexId SubcurveSplitter2d::insertPoint(Vec2 point, TriangleId hint)
{
    const Location2d location = t_.delaunay.locate(point, hint);
    if (location.kind == Location2d::Kind::OnVertex) return {};
    if (location.kind == Location2d::Kind::OnEdge && t_.mesh().isConstrained(location.edge)) return {};
    t_.delaunay.findCavity(point, location, cavity_);
    const bool isOutside = std::none_of(cavity_.triangles.begin(), cavity_.triangles.end(),
                                        [&](TriangleId t) { return t_.isMeshed(t); });
    if (isOutside) ++counters_.outsideCircles;
    return t_.delaunay.commit(cavity_);
}

void SubcurveSplitter2d::connectHalf(VertexId from, VertexId to, bool& wasFlipped)
{
    const EdgeLink edge = t_.mesh().findEdge(from, to);
    if (edge.isValid()) {
        t_.delaunay.constrainEdge(edge);
        return;
    }
    ++counters_.recoveredEdges;
    wasFlipped = true;
    const bool isRecovered = t_.delaunay.recoverSegment(from, to).hasValue();
    MESHER_INVARIANT(isRecovered);
    static_cast<void>(isRecovered);
}

void SubcurveSplitter2d::restoreRegions(SubcurveId s, VertexId middle, bool isWide)
{
    const Triangulation2d& mesh = t_.mesh();
    const PccCurve& curve = domain_.curve(t_.boundary.subcurves[s].curve);
    const EdgeLink left = mesh.findEdge(t_.firstVertex(s), t_.lastVertex(s));
    IdSet visited;
    for (const auto& [side, region] :
         {std::pair(left, curve.left), std::pair(mesh.across(left), curve.right)}) {
        stack_.assign(1, side);
        while (!stack_.empty()) {
            const EdgeLink entry = stack_.back();
            stack_.pop_back();
            const Triangle2d& record = mesh.triangle(entry.triangle());
            const bool isWrong = record.region != region;
            // After flips a wrong triangle may hide behind a right one.
            if (!isWrong && !(isWide && visited.insert(entry.triangle().value))) continue;
            if (isWrong) {
                t_.delaunay.setRegion(entry.triangle(), region);
                for (const VertexId v : record.v) {
                    if (v != kGhostVertex && v != middle) touched_.push_back(v);
                }
            }
            for (unsigned edge = 0; edge < 3; ++edge) {
                if (!record.isConstrained(edge)) stack_.push_back(record.n[edge]);
            }
        }
    }
}

}  // namespace mesher
