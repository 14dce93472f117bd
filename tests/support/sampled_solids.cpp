#include "support/sampled_solids.h"

#include "base/run_context.h"
#include "predicates/circumcenter.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>
#include <stdexcept>

namespace mesher::test {

namespace {

constexpr double kPi = std::numbers::pi;

std::vector<std::uint32_t> commonOf(const std::vector<std::uint32_t>& a, const std::vector<std::uint32_t>& b)
{
    std::vector<std::uint32_t> common;
    std::set_intersection(a.begin(), a.end(), b.begin(), b.end(), std::back_inserter(common));
    return common;
}

}  // namespace

// --- the splitter

SampledSplitter::SampledSplitter(SurfaceMesh mesh, std::shared_ptr<const SolidGeometry> geometry,
                                 double floor)
    : mesh_(std::move(mesh)), geometry_(std::move(geometry)), floor_(floor)
{
    for (std::uint32_t i = 0; i < mesh_.facets.size(); ++i) attach(FacetId(i), true);
    for (std::uint32_t i = 0; i < mesh_.segments.size(); ++i) {
        const auto& node = mesh_.segments[SegmentId(i)].node;
        segmentsAt_[unorderedPair(node[0], node[1])] = SegmentId(i);
    }
}

void SampledSplitter::attach(FacetId facet, bool isAttached)
{
    const auto& node = mesh_.facets[facet].node;
    for (unsigned k = 0; k < 3; ++k) {
        const Side side = unorderedPair(node[k], node[(k + 1) % 3]);
        std::vector<FacetId>& facets = facetsAt_[side];
        if (isAttached) {
            facets.push_back(facet);
        } else {
            std::erase(facets, facet);
            if (facets.empty()) facetsAt_.erase(side);
        }
    }
}

Vec3 SampledSplitter::normalOf(const SurfaceFacet& facet) const
{
    const Vec3 a = position(facet.node[0]);
    return cross(position(facet.node[1]) - a, position(facet.node[2]) - a);
}

bool SampledSplitter::isInBall(const SurfaceFacet& facet, const Vec3& point) const
{
    const Vec3 a = position(facet.node[0]);
    const auto centre = approximateCircumcenter(a, position(facet.node[1]), position(facet.node[2]));
    return centre && squaredLength(point - *centre) < (1.0 - 1e-9) * squaredLength(a - *centre);
}

SegmentId SampledSplitter::segmentAt(NodeId a, NodeId b) const
{
    const auto found = segmentsAt_.find(unorderedPair(a, b));
    return found == segmentsAt_.end() ? SegmentId() : found->second;
}

FacetId SampledSplitter::behind(FacetId facet, NodeId a, NodeId b) const
{
    for (const FacetId other : facetsAt_.at(unorderedPair(a, b))) {
        if (other != facet && mesh_.facets[other].face == mesh_.facets[facet].face) return other;
    }
    return {};
}

/// The facet that the point lies over; none if a segment is in the way, which the split then names.
FacetId SampledSplitter::walk(FacetId from, const Vec3& point, SurfaceSplit& split) const
{
    FacetId facet = from;
    for (int step = 0; step < 1000; ++step) {
        const SurfaceFacet& record = mesh_.facets[facet];
        const Vec3 normal = normalOf(record);
        double deepest = 1e-9 * squaredLength(normal);
        int exit = -1;
        for (int k = 0; k < 3; ++k) {
            const Vec3 a = position(record.node[static_cast<unsigned>(k)]);
            const Vec3 b = position(record.node[static_cast<unsigned>(k + 1) % 3]);
            const double side = dot(cross(b - a, point - a), normal);
            if (side >= deepest) continue;
            deepest = side;
            exit = k;
        }
        if (exit < 0) return facet;
        const NodeId a = record.node[static_cast<unsigned>(exit)];
        const NodeId b = record.node[static_cast<unsigned>(exit + 1) % 3];
        const SegmentId segment = segmentAt(a, b);
        if (segment.isValid()) {
            split.status = SurfaceSplitStatus::Encroaches;
            split.segment = segment;
            return {};
        }
        // On the side itself either facet will do; the patch takes both.
        if (deepest > -1e-9 * squaredLength(normal)) return facet;
        facet = behind(facet, a, b);
        if (!facet.isValid()) break;
    }
    split.status = SurfaceSplitStatus::NotFound;
    return {};
}

/// The facets of one face around the seed whose equatorial ball has the point, as far as their perimeter sees it.
void SampledSplitter::growPatch(FacetId seed, const Vec3& point, SegmentId across, SurfaceSplitExtent extent,
                                std::vector<FacetId>& patch) const
{
    std::set<FacetId> banned;
    for (bool isStarShaped = false; !isStarShaped;) {
        patch.assign(1, seed);
        isStarShaped = true;
        for (std::size_t next = 0; next < patch.size(); ++next) {
            const SurfaceFacet& facet = mesh_.facets[patch[next]];
            const Vec3 normal = normalOf(facet);
            for (unsigned k = 0; k < 3; ++k) {
                const NodeId a = facet.node[k];
                const NodeId b = facet.node[(k + 1) % 3];
                const double seen = dot(cross(position(b) - position(a), point - position(a)), normal);
                const bool isVisible = seen > 1e-9 * squaredLength(normal);
                const SegmentId segment = segmentAt(a, b);
                FacetId other = segment.isValid() ? FacetId() : behind(patch[next], a, b);
                if (other.isValid() && std::find(patch.begin(), patch.end(), other) != patch.end()) continue;
                const bool isTaken = other.isValid() && banned.count(other) == 0 &&
                                     (!isVisible || (extent == SurfaceSplitExtent::Delaunay &&
                                                     isInBall(mesh_.facets[other], point)));
                if (isTaken) {
                    patch.push_back(other);
                } else if (!isVisible && !(segment.isValid() && segment == across) && patch[next] != seed) {
                    banned.insert(patch[next]);
                    isStarShaped = false;
                }
            }
        }
    }
}

/// Adds the star of the new node over the perimeter of the patch; false if a segment of it is encroached.
bool SampledSplitter::addStar(const std::vector<FacetId>& patch, SegmentId across, SurfaceSplit& split) const
{
    for (const FacetId id : patch) {
        const SurfaceFacet& facet = mesh_.facets[id];
        for (unsigned k = 0; k < 3; ++k) {
            const NodeId a = facet.node[k];
            const NodeId b = facet.node[(k + 1) % 3];
            const SegmentId segment = segmentAt(a, b);
            if (segment.isValid() && segment == across) continue;
            const FacetId other = segment.isValid() ? FacetId() : behind(id, a, b);
            if (other.isValid() && std::find(patch.begin(), patch.end(), other) != patch.end()) continue;
            const bool isEncroached = segment.isValid() && dot(position(a) - split.node.position,
                                                               position(b) - split.node.position) < 0.0;
            if (isEncroached && !across.isValid()) {
                split.status = SurfaceSplitStatus::Encroaches;
                split.segment = segment;
                return false;
            }
            split.added.push_back({{NodeId(), a, b}, facet.face, {}});
            if (length(position(a) - split.node.position) < floor_)
                split.status = SurfaceSplitStatus::TooSmall;
        }
        split.removed.push_back(id);
    }
    return true;
}

void SampledSplitter::evaluateFacet(FacetId facet, SurfaceSplitExtent extent, SurfaceSplit& split)
{
    split = {};
    split.status = SurfaceSplitStatus::NotFound;
    const SurfaceFacet& record = mesh_.facets[facet];
    const auto centre =
        approximateCircumcenter(position(record.node[0]), position(record.node[1]), position(record.node[2]));
    if (!centre) return;
    split.node.position = geometry_->faces[record.face.value](*centre);
    split.node.entity = {2, record.face.value};
    const FacetId over = walk(facet, split.node.position, split);
    if (!over.isValid()) return;
    std::vector<FacetId> patch;
    growPatch(over, split.node.position, SegmentId(), extent, patch);
    split.status = SurfaceSplitStatus::Ready;
    addStar(patch, SegmentId(), split);
}

void SampledSplitter::evaluateSegment(SegmentId segment, SurfaceSplitExtent extent, SurfaceSplit& split)
{
    split = {};
    const SurfaceSegment& record = mesh_.segments[segment];
    const auto [a, b] = record.node;
    split.node.position = geometry_->edges[record.edge.value](0.5 * (position(a) + position(b)));
    split.node.entity = {1, record.edge.value};
    split.status = SurfaceSplitStatus::Ready;
    for (const FacetId facet : facetsAt_.at(unorderedPair(a, b))) {
        std::vector<FacetId> patch;
        growPatch(facet, split.node.position, segment, extent, patch);
        addStar(patch, segment, split);
    }
    split.segment = segment;
    split.halves = {SurfaceSegment{{a, NodeId()}, record.edge, {}},
                    SurfaceSegment{{NodeId(), b}, record.edge, {}}};
}

namespace {

/// The corner of a facet that another one does not have.
unsigned ownCorner(const SurfaceFacet& facet, const SurfaceFacet& other)
{
    unsigned own = 0;
    while (own < 2 && std::count(other.node.begin(), other.node.end(), facet.node[own]) > 0) ++own;
    return own;
}

}  // namespace

bool SampledSplitter::maySwap(FacetId first, FacetId second) const
{
    const SurfaceFacet &one = mesh_.facets[first], &two = mesh_.facets[second];
    const unsigned own = ownCorner(one, two);
    const NodeId a = one.node[(own + 1) % 3];
    const NodeId b = one.node[(own + 2) % 3];
    const NodeId apex = two.node[ownCorner(two, one)];
    return one.face == two.face && !segmentAt(a, b).isValid() && behind(first, a, b) == second &&
           facetsAt_.find(unorderedPair(one.node[own], apex)) == facetsAt_.end();
}

std::array<FacetId, 2> SampledSplitter::swap(FacetId first, FacetId second)
{
    SurfaceFacet one = mesh_.facets[first];
    SurfaceFacet two = mesh_.facets[second];
    const unsigned own = ownCorner(one, two), other = ownCorner(two, one);
    for (const FacetId facet : {first, second}) {
        attach(facet, false);
        mesh_.facets[facet].face = BrepFaceId();
    }
    const NodeId left = one.node[own], right = two.node[other];
    one.node[(own + 2) % 3] = right;
    two.node[(other + 2) % 3] = left;
    const std::array<FacetId, 2> added{mesh_.facets.push_back(one), mesh_.facets.push_back(two)};
    for (const FacetId facet : added) attach(facet, true);
    return added;
}

SurfaceSplitResult SampledSplitter::commit(const SurfaceSplit& split)
{
    SurfaceSplitResult result;
    result.node = mesh_.nodes.push_back(split.node);
    const auto named = [&](NodeId node) { return node.isValid() ? node : result.node; };
    for (const FacetId facet : split.removed) {
        attach(facet, false);
        mesh_.facets[facet].face = BrepFaceId();
    }
    for (SurfaceFacet facet : split.added) {
        for (NodeId& node : facet.node) node = named(node);
        result.added.push_back(mesh_.facets.push_back(facet));
        attach(result.added.back(), true);
    }
    if (split.segment.isValid()) {
        SurfaceSegment& whole = mesh_.segments[split.segment];
        segmentsAt_.erase(unorderedPair(whole.node[0], whole.node[1]));
        whole.edge = BrepEdgeId();
        for (unsigned i = 0; i < 2; ++i) {
            SurfaceSegment half = split.halves[i];
            for (NodeId& node : half.node) node = named(node);
            result.halves[i] = mesh_.segments.push_back(half);
            segmentsAt_[unorderedPair(half.node[0], half.node[1])] = result.halves[i];
        }
    }
    return result;
}

// --- the solids

namespace {

EntityRef entityAt(const SolidGeometry& geometry, const std::vector<std::uint32_t>& faces,
                   std::uint32_t point)
{
    if (faces.size() == 1) return {2, faces[0]};
    if (faces.size() == 2) return {1, geometry.edgeBetween.at({faces[0], faces[1]})};
    return {0, point};
}

/// Facets looking outward, as faces between a region and the outside.
void addFacets(const SolidGeometry& geometry, SurfaceMesh& surface, ConstrainedTetrahedralization& t)
{
    Triangulation3d& mesh = t.mesh();
    std::map<std::pair<NodeId, NodeId>, std::vector<std::uint32_t>> facesAt;
    for (std::uint32_t i = 0; i < mesh.tetLimit(); ++i) {
        const TetId tet(i);
        if (!mesh.isAlive(tet) || mesh.region(tet) == kExteriorRegion) continue;
        for (int face = 0; face < 4; ++face) {
            if (mesh.region(mesh.neighbour(tet, face).tet()) != kExteriorRegion) continue;
            std::array<VertexId, 3> v = mesh.faceVertices({tet, face});
            std::swap(v[1], v[2]);
            SurfaceFacet facet;
            for (unsigned k = 0; k < 3; ++k) facet.node[k] = t.nodeOf[v[k]];
            std::vector<std::uint32_t> faces = geometry.facesAt(surface.nodes[facet.node[0]].position);
            for (unsigned k = 1; k < 3; ++k) {
                faces = commonOf(faces, geometry.facesAt(surface.nodes[facet.node[k]].position));
            }
            if (faces.empty()) throw std::logic_error("a facet of the sample is on no face");
            // Three points of a rim are on the lid, the later face.
            facet.face = BrepFaceId(faces.back());
            const FacetId id = surface.facets.push_back(facet);
            std::sort(v.begin(), v.end());
            t.facetOf.insert(v, id);
            mesh.setFaceConstrained({tet, face}, true);
            for (unsigned k = 0; k < 3; ++k) {
                facesAt[unorderedPair(facet.node[k], facet.node[(k + 1) % 3])].push_back(facet.face.value);
            }
        }
    }
    for (auto& [side, faces] : facesAt) {
        if (faces.size() != 2) throw std::logic_error("the sample's facets are no 2-manifold");
        std::sort(faces.begin(), faces.end());
        if (faces[0] == faces[1]) continue;
        const SegmentId id = surface.segments.push_back(
            {{side.first, side.second}, BrepEdgeId(geometry.edgeBetween.at({faces[0], faces[1]})), {}});
        const VertexId a = t.vertexOf[side.first];
        const VertexId b = t.vertexOf[side.second];
        t.segmentOf.insert(unorderedPair(a, b), id);
        mesh.setEdgeConstrained(mesh.findEdge(a, b), a, b, true);
    }
}

void setRegions(const SolidGeometry& geometry, ConstrainedTetrahedralization& t)
{
    Triangulation3d& mesh = t.mesh();
    for (std::uint32_t i = 0; i < mesh.tetLimit(); ++i) {
        const TetId tet(i);
        if (!mesh.isAlive(tet) || mesh.isGhostTet(tet)) continue;
        bool isInside = true;
        if (geometry.isInside) {
            const auto& v = mesh.tet(tet).vertex;
            const auto centre = approximateCircumcenter(mesh.position(v[0]), mesh.position(v[1]),
                                                        mesh.position(v[2]), mesh.position(v[3]));
            isInside = centre && geometry.isInside((1.0 / t.scale) * *centre);
        }
        if (isInside) mesh.setRegion(tet, RegionId(1u));
    }
}

}  // namespace

SampledSolid makeSampledSolid(const std::vector<Vec3>& points, SolidGeometry geometry, double volume,
                              double scale)
{
    SampledSolid solid;
    solid.volume = volume;
    ConstrainedTetrahedralization& t = solid.tetrahedralization;
    t.scale = scale;
    t.delaunay = std::make_unique<Delaunay3d>();
    std::vector<Vec3> scaled;
    for (const Vec3& p : points) scaled.push_back(scale * p);
    RunContext context;
    const auto inserted = t.delaunay->insertPoints(scaled, {}, context);
    if (!inserted || inserted->duplicates > 0) throw std::logic_error("the sample cannot be inserted");

    SurfaceMesh surface;
    t.nodeOf.resize(t.mesh().vertexLimit());
    for (std::uint32_t i = 0; i < points.size(); ++i) {
        MeshNode node;
        node.position = points[i];
        node.entity = entityAt(geometry, geometry.facesAt(points[i]), i);
        const VertexId v = inserted->vertex[i];
        t.vertexOf.push_back(v);
        t.nodeOf[v] = surface.nodes.push_back(node);
        VertexClass classification;
        classification.dimension = node.entity.dimension & 7u;
        classification.entity = node.entity.index & VertexClass::kNoEntity;
        t.mesh().setClassification(v, classification);
    }
    setRegions(geometry, t);
    addFacets(geometry, surface, t);
    solid.geometry = std::make_shared<const SolidGeometry>(std::move(geometry));
    solid.splitter = std::make_unique<SampledSplitter>(std::move(surface), solid.geometry, 0.0);
    return solid;
}

namespace {

struct Plane
{
    Vec3 normal;  ///< unit
    double offset = 0.0;
};

/// Planar faces, straight edges wherever two of them meet.
SolidGeometry polyhedron(const std::vector<Plane>& planes, double tolerance)
{
    SolidGeometry geometry;
    for (const Plane& plane : planes) {
        geometry.faces.emplace_back(
            [plane](const Vec3& p) { return p - (dot(plane.normal, p) - plane.offset) * plane.normal; });
    }
    geometry.facesAt = [planes, tolerance](const Vec3& p) {
        std::vector<std::uint32_t> faces;
        for (std::uint32_t i = 0; i < planes.size(); ++i) {
            if (std::abs(dot(planes[i].normal, p) - planes[i].offset) < tolerance) faces.push_back(i);
        }
        return faces;
    };
    for (std::uint32_t i = 0; i < planes.size(); ++i) {
        for (std::uint32_t j = i + 1; j < planes.size(); ++j) {
            geometry.edgeBetween[{i, j}] = static_cast<std::uint32_t>(geometry.edges.size());
            // The middle of a straight segment is on it.
            geometry.edges.emplace_back([](const Vec3& p) { return p; });
        }
    }
    return geometry;
}

}  // namespace

namespace {

SampledSolid sampledGrid(const Vec3& size, const std::array<std::uint32_t, 3>& cells, double scale)
{
    std::vector<Vec3> points;
    const auto [nx, ny, nz] = cells;
    for (std::uint32_t i = 0; i <= nx; ++i) {
        for (std::uint32_t j = 0; j <= ny; ++j) {
            for (std::uint32_t k = 0; k <= nz; ++k) {
                const bool isInner = i > 0 && i < nx && j > 0 && j < ny && k > 0 && k < nz;
                if (!isInner) points.push_back({size.x * i / nx, size.y * j / ny, size.z * k / nz});
            }
        }
    }
    const std::vector<Plane> planes = {{{-1, 0, 0}, 0.0},   {{1, 0, 0}, size.x}, {{0, -1, 0}, 0.0},
                                       {{0, 1, 0}, size.y}, {{0, 0, -1}, 0.0},   {{0, 0, 1}, size.z}};
    return makeSampledSolid(points, polyhedron(planes, 1e-9 * size.x), size.x * size.y * size.z, scale);
}

}  // namespace

SampledSolid sampledBox(const Vec3& size, std::uint32_t cells, double scale)
{
    return sampledGrid(size, {cells, cells, cells}, scale);
}

SampledSolid sampledPlate(double width, double thickness, std::uint32_t cells)
{
    return sampledGrid({width, width, thickness}, {cells, cells, 1}, 1.0);
}

SampledSolid sampledWedge(double width, double height, double length, std::uint32_t cells)
{
    std::vector<Vec3> points;
    for (std::uint32_t i = 0; i <= cells; ++i) {
        const double z = length * i / cells;
        points.push_back({0.0, 0.0, z});
        points.push_back({width, 0.0, z});
        points.push_back({width, height, z});
    }
    const double slope = std::hypot(width, height);
    const std::vector<Plane> planes = {{{0, -1, 0}, 0.0},
                                       {{1, 0, 0}, width},
                                       {{-height / slope, width / slope, 0}, 0.0},
                                       {{0, 0, -1}, 0.0},
                                       {{0, 0, 1}, length}};
    return makeSampledSolid(points, polyhedron(planes, 1e-9 * width), 0.5 * width * height * length);
}

SampledSolid sampledSphere(double radius, std::uint32_t count, double scale)
{
    SolidGeometry geometry;
    const auto project = [radius](const Vec3& p) { return (radius / length(p)) * p; };
    geometry.faces.emplace_back(project);
    geometry.facesAt = [](const Vec3&) { return std::vector<std::uint32_t>{0}; };
    std::vector<Vec3> points;
    for (std::uint32_t i = 0; i < count; ++i) {
        const double z = 1.0 - 2.0 * (i + 0.5) / count;
        const double turn = i * kPi * (3.0 - std::sqrt(5.0));
        const double r = std::sqrt(1.0 - z * z);
        points.push_back(project({r * std::cos(turn), r * std::sin(turn), z}));
    }
    return makeSampledSolid(points, std::move(geometry), 4.0 / 3.0 * kPi * radius * radius * radius, scale);
}

SampledSolid sampledCylinder(double radius, double height, std::uint32_t around, double scale)
{
    SolidGeometry geometry;
    const auto onRound = [radius](const Vec3& p) {
        const double r = std::hypot(p.x, p.y);
        return Vec3{radius / r * p.x, radius / r * p.y, p.z};
    };
    geometry.faces = {onRound,
                      [](const Vec3& p) {
                          return Vec3{p.x, p.y, 0.0};
                      },
                      [height](const Vec3& p) {
                          return Vec3{p.x, p.y, height};
                      }};
    geometry.edges = {onRound, onRound};
    geometry.edgeBetween = {{{0, 1}, 0}, {{0, 2}, 1}};
    geometry.facesAt = [radius, height](const Vec3& p) {
        std::vector<std::uint32_t> faces;
        if (std::hypot(p.x, p.y) > (1.0 - 1e-9) * radius) faces.push_back(0);
        if (p.z == 0.0) faces.push_back(1);
        if (p.z == height) faces.push_back(2);
        return faces;
    };
    const double spacing = 2.0 * kPi * radius / around;
    // The hull has the rulings: only rows above each other make it a Delaunay surface.
    const auto rows = static_cast<std::uint32_t>(std::max(1.0, std::round(height / spacing)));
    std::vector<Vec3> points;
    for (std::uint32_t row = 0; row <= rows; ++row) {
        const double z = row == rows ? height : height * row / rows;
        for (std::uint32_t i = 0; i < around; ++i) {
            const double turn = 2.0 * kPi * i / around;
            points.push_back(onRound({std::cos(turn), std::sin(turn), z}));
        }
    }
    // Rings on the lids.
    for (double r = radius - spacing; r > 0.3 * spacing; r -= spacing) {
        const auto count = static_cast<std::uint32_t>(std::max(3.0, std::round(2.0 * kPi * r / spacing)));
        for (std::uint32_t i = 0; i < count; ++i) {
            const double turn = 2.0 * kPi * (i + 0.3) / count;
            for (const double z : {0.0, height})
                points.push_back({r * std::cos(turn), r * std::sin(turn), z});
        }
    }
    return makeSampledSolid(points, std::move(geometry), kPi * radius * radius * height, scale);
}

SampledSolid sampledTorus(double ringRadius, double tubeRadius, std::uint32_t around, double scale)
{
    SolidGeometry geometry;
    const auto project = [ringRadius, tubeRadius](const Vec3& p) {
        const double r = std::hypot(p.x, p.y);
        const Vec3 ring{ringRadius / r * p.x, ringRadius / r * p.y, 0.0};
        return ring + (tubeRadius / length(p - ring)) * (p - ring);
    };
    geometry.faces.emplace_back(project);
    geometry.facesAt = [](const Vec3&) { return std::vector<std::uint32_t>{0}; };
    geometry.isInside = [ringRadius, tubeRadius](const Vec3& p) {
        return std::hypot(std::hypot(p.x, p.y) - ringRadius, p.z) < tubeRadius;
    };
    const double spacing = 2.0 * kPi * tubeRadius / around;
    std::vector<Vec3> points;
    for (std::uint32_t i = 0; i < around; ++i) {
        const double v = 2.0 * kPi * i / around;
        const double radius = ringRadius + tubeRadius * std::cos(v);
        const auto count = static_cast<std::uint32_t>(std::round(2.0 * kPi * radius / spacing));
        for (std::uint32_t j = 0; j < count; ++j) {
            const double u = 2.0 * kPi * (j + 0.5 * (i % 2)) / count;
            points.push_back(project({radius * std::cos(u), radius * std::sin(u), tubeRadius * std::sin(v)}));
        }
    }
    return makeSampledSolid(points, std::move(geometry),
                            2.0 * kPi * kPi * ringRadius * tubeRadius * tubeRadius, scale);
}

}  // namespace mesher::test
