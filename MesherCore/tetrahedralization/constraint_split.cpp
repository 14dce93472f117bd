#include "tetrahedralization/constraint_split.h"

#include "predicates/orient3d.h"
#include "tetrahedralization/facet_recovery.h"
#include "tetrahedralization/node_insertion.h"

#include <algorithm>
#include <cmath>

namespace mesher {

namespace {

/// How often an encroached segment may send on to another.
constexpr int kMaxReferrals = 16;

double fractionAlong(const Vec3& a, const Vec3& b, const Vec3& p)
{
    const Vec3 edge = b - a;
    return std::clamp(dot(p - a, edge) / squaredLength(edge), 0.0, 1.0);
}

/// Barycentric coordinates of a point of the plane of a triangle.
std::array<double, 3> weightsIn(const std::array<Vec3, 3>& corner, const Vec3& p)
{
    const Vec3 normal = cross(corner[1] - corner[0], corner[2] - corner[0]);
    const double area = squaredLength(normal);
    std::array<double, 3> weight{};
    for (unsigned k = 0; k < 3; ++k) {
        weight[k] = dot(cross(corner[(k + 1) % 3] - p, corner[(k + 2) % 3] - p), normal) / area;
    }
    return weight;
}

}  // namespace

SurfaceSplit ConstraintSplit::describeEdgeSplit(VertexId a, VertexId b, const Vec3& kernelPoint)
{
    const SurfaceMesh& surface = constraints_.surface();
    const auto& nodeOf = constraints_.tets().nodeOf;
    SurfaceSplit split;
    split.status = SurfaceSplitStatus::Ready;
    split.node.position = constraints_.modelPosition(kernelPoint);
    split.segment = constraints_.segmentAt(a, b);
    split.removed = constraints_.facetsAt(a, b);
    for (const FacetId id : split.removed) {
        const SurfaceFacet& facet = surface.facets[id];
        unsigned first = 0;
        while (facet.node[first] == nodeOf[a] || facet.node[first] == nodeOf[b]) ++first;
        const unsigned from = (first + 1) % 3;
        const unsigned to = (first + 2) % 3;
        const double t = fractionAlong(surface.nodes[facet.node[from]].position,
                                       surface.nodes[facet.node[to]].position, split.node.position);
        const Vec2 middle = (1.0 - t) * facet.parameters[from] + t * facet.parameters[to];
        for (const unsigned replaced : {from, to}) {
            SurfaceFacet part = facet;
            part.node[replaced] = NodeId();
            part.parameters[replaced] = middle;
            split.added.push_back(part);
        }
        split.node.entity = {2, facet.face.value};
        split.node.parameters = middle;
    }
    if (!split.segment.isValid()) return split;
    const SurfaceSegment& segment = surface.segments[split.segment];
    const double t = fractionAlong(surface.nodes[segment.node[0]].position,
                                   surface.nodes[segment.node[1]].position, split.node.position);
    const double parameter = (1.0 - t) * segment.parameter[0] + t * segment.parameter[1];
    split.node.entity = {1, segment.edge.value};
    split.node.parameters = {parameter, 0.0};
    split.halves = {segment, segment};
    split.halves[0].node[1] = NodeId();
    split.halves[0].parameter[1] = parameter;
    split.halves[1].node[0] = NodeId();
    split.halves[1].parameter[0] = parameter;
    return split;
}

SurfaceSplit ConstraintSplit::describeFacetSplit(FacetId id, const Vec3& kernelPoint) const
{
    const SurfaceMesh& surface = constraints_.surface();
    const SurfaceFacet& facet = surface.facets[id];
    SurfaceSplit split;
    split.status = SurfaceSplitStatus::Ready;
    split.node.position = constraints_.modelPosition(kernelPoint);
    split.node.entity = {2, facet.face.value};
    split.removed = {id};
    std::array<Vec3, 3> corner;
    for (unsigned k = 0; k < 3; ++k) corner[k] = surface.nodes[facet.node[k]].position;
    const auto weight = weightsIn(corner, split.node.position);
    for (unsigned k = 0; k < 3; ++k)
        split.node.parameters = split.node.parameters + weight[k] * facet.parameters[k];
    for (unsigned k = 0; k < 3; ++k) {
        SurfaceFacet part = facet;
        part.node[k] = NodeId();
        part.parameters[k] = split.node.parameters;
        split.added.push_back(part);
    }
    return split;
}

/// Replaces tets_ by the star of a new vertex; invalid if it does not see all of their surface.
VertexId ConstraintSplit::insertStar(const Vec3& point)
{
    Triangulation3d& mesh = constraints_.mesh();
    star_.clear();
    for (const TetId tet : tets_) {
        if (mesh.isGhostTet(tet)) return {};
        for (int face = 0; face < 4; ++face) {
            if (std::find(tets_.begin(), tets_.end(), mesh.neighbour(tet, face).tet()) != tets_.end())
                continue;
            const auto [a, b, c] = mesh.faceVertices({tet, face});
            if (orient3d(mesh.position(a), mesh.position(b), mesh.position(c), point) != Sign::Positive)
                return {};
            star_.push_back({a, b, c, kGhostVertex});
        }
    }
    constraints_.tets().delaunay->expectPointsIn({point, point});
    const VertexId vertex = mesh.addVertex(point);
    constraints_.tets().nodeOf.resize(
        std::max<std::size_t>(constraints_.tets().nodeOf.size(), mesh.vertexLimit()));
    for (TetCorners& corners : star_) corners[3] = vertex;
    replacement_.replace(tets_, star_);
    return vertex;
}

bool ConstraintSplit::insertAndMake(const SurfaceSplit& split)
{
    ConstrainedTetrahedralization& tets = constraints_.tets();
    const Vec3 point = tets.scale * split.node.position;
    constraints_.release(split);
    const Result<Insertion3d> inserted = tets.delaunay->insert(point);
    VertexId vertex;
    if (inserted && inserted->status == InsertionStatus::Inserted) {
        vertex = inserted->vertex;
    } else if (inserted && (inserted->status == InsertionStatus::Blocked ||
                            inserted->status == InsertionStatus::NotStarShaped)) {
        const Location3d& at = inserted->location;
        tets_.assign(1, at.tet);
        if (at.kind == Location3d::Kind::Face)
            tets_.push_back(tets.mesh().neighbour({at.tet, at.index}).tet());
        if (at.kind == Location3d::Kind::Edge) {
            tets.mesh().collectEdgeRing(at.tet, tets.mesh().vertex(at.tet, kEdgeSlots[at.index][0]),
                                        tets.mesh().vertex(at.tet, kEdgeSlots[at.index][1]), tets_);
        }
        vertex = insertStar(point);
    }
    if (!vertex.isValid()) {
        constraints_.restore(split);
        return false;
    }
    tets.mesh().setClassification(vertex, vertexClassOf(split.node));
    constraints_.make(split, vertex);
    return true;
}

/// Follows the splitter's references to segments that are to be split first.
bool ConstraintSplit::makeReady(SurfaceSplit& split)
{
    for (int i = 0; i < kMaxReferrals && split.status == SurfaceSplitStatus::Encroaches; ++i) {
        const SegmentId segment = split.segment;
        constraints_.splitter().evaluateSegment(segment, SurfaceSplitExtent::Delaunay, split);
    }
    return split.status == SurfaceSplitStatus::Ready;
}

bool ConstraintSplit::splitEdgeExactly(VertexId a, VertexId b)
{
    const SegmentId segment = constraints_.segmentAt(a, b);
    if (segment.isValid()) {
        constraints_.splitter().evaluateSegment(segment, SurfaceSplitExtent::Delaunay, split_);
        return makeReady(split_) && insertAndMake(split_);
    }
    for (const FacetId facet : constraints_.facetsAt(a, b)) {
        if (splitFacetExactly(facet)) return true;
    }
    return false;
}

bool ConstraintSplit::splitFacetExactly(FacetId facet)
{
    constraints_.splitter().evaluateFacet(facet, SurfaceSplitExtent::Delaunay, split_);
    return makeReady(split_) && insertAndMake(split_);
}

bool ConstraintSplit::splitEdgeAtCrossing(VertexId a, VertexId b, const std::vector<EdgeCrossing>& crossings)
{
    Triangulation3d& mesh = constraints_.mesh();
    const SurfaceSplit halved = describeEdgeSplit(a, b, 0.5 * (mesh.position(a) + mesh.position(b)));
    const std::size_t middle = crossings.size() / 2;
    for (std::size_t i = 0; i < crossings.size(); ++i) {
        const std::size_t offset = (i + 1) / 2;
        const EdgeCrossing& crossing =
            crossings[i % 2 == 0 ? (middle + offset) % crossings.size()
                                 : (middle + crossings.size() - offset) % crossings.size()];
        if (crossing.kind == EdgeCrossing::Kind::Vertex) continue;
        const Vec3 point = crossingPoint(mesh, a, b, crossing);
        if (crossing.kind == EdgeCrossing::Kind::Face) {
            tets_ = {crossing.face.tet(), mesh.neighbour(crossing.face).tet()};
        } else {
            mesh.collectEdgeRing(crossing.face.tet(), crossing.vertex[0], crossing.vertex[1], tets_);
        }
        const VertexId vertex = insertStar(point);
        if (!vertex.isValid()) continue;
        splitEdgeAt(a, b, vertex);
        return true;
    }
    return insertAndMake(halved);
}

bool ConstraintSplit::splitFacetAtCrossing(FacetId facet, const FacetCrossing& crossing)
{
    Triangulation3d& mesh = constraints_.mesh();
    const auto corner = constraints_.cornersOf(facet);
    const Vec3 centre =
        (1.0 / 3.0) * (mesh.position(corner[0]) + mesh.position(corner[1]) + mesh.position(corner[2]));
    const SurfaceSplit central = describeFacetSplit(facet, centre);
    std::vector<std::pair<double, Vec3>> points;
    std::vector<std::size_t> order;
    for (const auto& edge : crossing.edges) {
        const Vec3 point = facetCrossingPoint(mesh, corner, edge);
        order.push_back(points.size());
        points.emplace_back(squaredLength(point - centre), point);
    }
    std::stable_sort(order.begin(), order.end(),
                     [&](std::size_t i, std::size_t j) { return points[i].first < points[j].first; });
    for (const std::size_t i : order) {
        const auto [low, high] = crossing.edges[i];
        mesh.collectEdgeRing(mesh.findEdge(low, high), low, high, tets_);
        const VertexId vertex = insertStar(points[i].second);
        if (!vertex.isValid()) continue;
        splitFacetAt(facet, vertex);
        return true;
    }
    return insertAndMake(central);
}

void ConstraintSplit::splitEdgeAt(VertexId a, VertexId b, VertexId vertex)
{
    const SurfaceSplit split = describeEdgeSplit(a, b, constraints_.mesh().position(vertex));
    constraints_.release(split);
    constraints_.mesh().setClassification(vertex, vertexClassOf(split.node));
    constraints_.make(split, vertex);
}

void ConstraintSplit::splitFacetAt(FacetId facet, VertexId vertex)
{
    const SurfaceSplit split = describeFacetSplit(facet, constraints_.mesh().position(vertex));
    constraints_.release(split);
    constraints_.mesh().setClassification(vertex, vertexClassOf(split.node));
    constraints_.make(split, vertex);
}

}  // namespace mesher
