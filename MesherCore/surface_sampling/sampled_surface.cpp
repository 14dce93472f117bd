#include "surface_sampling/sampled_surface.h"

#include "base/assert.h"
#include "surface_sampling/face_flips.h"
#include "surface_sampling/face_replacement.h"

#include <cmath>
#include <utility>

namespace mesher {
namespace {

StarExtent starExtentOf(SurfaceSplitExtent extent)
{
    return extent == SurfaceSplitExtent::Least ? StarExtent::Least : StarExtent::Delaunay;
}

double intoPeriod(double value, double start, double period)
{
    return period > 0.0 ? value - period * std::floor((value - start) / period) : value;
}

void reset(SurfaceSplit& split)
{
    split.status = SurfaceSplitStatus::NotFound;
    split.node = {};
    split.segment = {};
    split.halves = {};
    split.removed.clear();
    split.added.clear();
}

}  // namespace

namespace {

/// The corner of an added facet where the new node goes.
unsigned newCornerOf(const SurfaceFacet& facet)
{
    unsigned corner = 0;
    while (corner < 2 && facet.node[corner].isValid()) ++corner;
    return corner;
}

}  // namespace

SampledSurface::SampledSurface(std::unique_ptr<SampledFaces> faces) : faces_(std::move(faces)) { assemble(); }

// ---- one mesh of all faces -------------------------------------------------------------------------------------------

void SampledSurface::assemble()
{
    mesh_.nodes = faces_->nodes();
    mesh_.segments = faces_->chains().segments();
    mesh_.facets.clear();
    triangleOf_.clear();
    const std::size_t count = faces_->model().faces.size();
    facetOf_ = IdVector<BrepFaceId, std::vector<FacetId>>(count);
    for (std::uint32_t f = 0; f < count; ++f) {
        if (faces_->face(BrepFaceId(f)) == nullptr) continue;
        numberNodes(BrepFaceId(f));
        numberFacets(BrepFaceId(f));
    }
}

Vec2 SampledSurface::insideBounds(BrepFaceId f, Vec2 uv) const
{
    const BrepFace& face = faces_->model().faces[f];
    const Vec2 periods = faces_->face(f)->geometry.periods();
    return {intoPeriod(uv.x, face.boundsU.first, periods.x), intoPeriod(uv.y, face.boundsV.first, periods.y)};
}

void SampledSurface::numberNodes(BrepFaceId f)
{
    FaceMesh& mesh = faces_->face(f)->mesh;
    for (std::uint32_t i = 0; i < mesh.vertexSlots(); ++i) {
        FaceVertex& vertex = mesh.vertex(VertexId(i));
        if (!vertex.isAlive || !vertex.isFree) continue;
        const FaceTriangle& record = mesh.triangle(vertex.triangle);
        const Vec2 uv = insideBounds(f, record.uv[record.cornerOf(VertexId(i))]);
        vertex.node = mesh_.nodes.push_back({vertex.position, {2, f.value}, uv});
    }
}

void SampledSurface::numberFacets(BrepFaceId f)
{
    const FaceMesh& mesh = faces_->face(f)->mesh;
    facetOf_[f].assign(mesh.triangleSlots(), FacetId());
    for (std::uint32_t i = 0; i < mesh.triangleSlots(); ++i) {
        const FaceTriangle& record = mesh.triangle(TriangleId(i));
        if (!record.isAlive) continue;
        SurfaceFacet facet{{}, f, record.uv};
        for (std::size_t k = 0; k < 3; ++k) facet.node[k] = mesh.vertex(record.v[k]).node;
        facetOf_[f][i] = mesh_.facets.push_back(facet);
        triangleOf_.push_back(TriangleId(i));
    }
}

// ---- splits ----------------------------------------------------------------------------------------------------------

void SampledSurface::appendStar(BrepFaceId f, const FaceStar& star, SurfaceSplit& split) const
{
    const FaceMesh& mesh = faces_->face(f)->mesh;
    for (const TriangleId t : star.cavity()) split.removed.push_back(facetOf_[f][t.value]);
    for (const StarSide& side : star.sides()) {
        split.added.push_back({{NodeId(), mesh.vertex(side.a).node, mesh.vertex(side.b).node},
                               f,
                               {side.uvVertex, side.uvA, side.uvB}});
    }
}

/// From the tip of a face to the ring around it, where facets stay as they are.
bool SampledSurface::isSpoke(SegmentId segment) const
{
    const SurfaceSegment& whole = mesh_.segments[segment];
    for (const BrepFaceId f : faces_->facesOf(whole.edge)) {
        const SampledFace* face = faces_->face(f);
        if (face != nullptr && face->refiner.isSpoke(whole.node)) return true;
    }
    return false;
}

void SampledSurface::evaluateSegment(SegmentId segment, SurfaceSplitExtent extent, SurfaceSplit& split)
{
    reset(split);
    split.segment = segment;
    const CurveChains& chains = faces_->chains();
    const std::optional<SegmentPlace> place = chains.splitPlace(segment);
    if (!place || isSpoke(segment)) {
        split.status = SurfaceSplitStatus::TooSmall;
        return;
    }
    const SurfaceSegment& whole = chains.segments()[segment];
    split.status = SurfaceSplitStatus::Ready;
    split.node = {place->position, {1, whole.edge.value}, {place->parameter, 0.0}};
    split.halves[0] = {{whole.node[0], NodeId()}, whole.edge, {whole.parameter[0], place->parameter}};
    split.halves[1] = {{NodeId(), whole.node[1]}, whole.edge, {place->parameter, whole.parameter[1]}};
    const SegmentVertex vertex{segment, whole.node, NodeId(), place->position, {}};
    for (const BrepFaceId f : faces_->facesOf(whole.edge)) {
        SampledFace* face = faces_->face(f);
        if (face == nullptr || !face->refiner.evaluateOnSegment(vertex, starExtentOf(extent))) continue;
        appendStar(f, face->refiner.splitter().star(), split);
    }
}

void SampledSurface::evaluateFacet(FacetId facet, SurfaceSplitExtent extent, SurfaceSplit& split)
{
    reset(split);
    const BrepFaceId f = mesh_.facets[facet].face;
    if (isHeld(facet)) {
        split.status = SurfaceSplitStatus::TooSmall;
        return;
    }
    FacetSplitter& splitter = faces_->face(f)->refiner.splitter();
    switch (splitter.evaluate(triangleOf_[facet], starExtentOf(extent), FacetNeed::Size)) {
        case FacetSplitStatus::NotFound: return;
        case FacetSplitStatus::TooSmall: split.status = SurfaceSplitStatus::TooSmall; return;
        case FacetSplitStatus::Encroaches:
            split.status = SurfaceSplitStatus::Encroaches;
            split.segment = splitter.encroached().front();
            return;
        case FacetSplitStatus::Ready: break;
    }
    const FaceStar& star = splitter.star();
    split.status = SurfaceSplitStatus::Ready;
    split.node = {star.vertex().position, {2, f.value}, insideBounds(f, star.parameters())};
    appendStar(f, star, split);
}

void SampledSurface::commitFace(BrepFaceId f, const SurfaceSplit& split, SurfaceSplitResult& result)
{
    SampledFace& face = *faces_->face(f);
    FaceMesh& mesh = face.mesh;
    std::vector<TriangleId> removed, made;
    std::vector<std::pair<NodeId, VertexId>> corners;
    for (const FacetId facet : split.removed) {
        if (mesh_.facets[facet].face != f) continue;
        removed.push_back(triangleOf_[facet]);
        for (const VertexId v : mesh.triangle(triangleOf_[facet]).v)
            corners.emplace_back(mesh.vertex(v).node, v);
    }
    if (removed.empty()) return;
    const auto vertexOf = [&](NodeId node) {
        for (const auto& [known, v] : corners) {
            if (known == node) return v;
        }
        return VertexId();
    };
    std::vector<FacetCorners> added;
    VertexId centre;
    for (const SurfaceFacet& facet : split.added) {
        if (facet.face != f) continue;
        const unsigned own = newCornerOf(facet);
        if (!centre.isValid()) {
            FaceVertex vertex = face.refiner.splitter().vertexAt(face.geometry.at(facet.parameters[own]));
            vertex.position = split.node.position;
            vertex.node = result.node;
            vertex.isFree = split.node.entity.dimension == 2;
            centre = mesh.addVertex(vertex);
            if (!vertex.isFree) face.refiner.setVertexOf(result.node, centre);
        }
        // On the seam of a face that meets itself at an angle there is no one normal.
        mesh.vertex(centre).keepNormal(face.geometry.at(facet.parameters[own]).normal);
        FacetCorners corner{{centre, centre, centre}, facet.parameters};
        for (unsigned k = 0; k < 3; ++k) {
            if (k != own) corner.v[k] = vertexOf(facet.node[k]);
        }
        added.push_back(corner);
    }
    std::vector<NewSegmentSide> sides;
    if (split.segment.isValid()) {
        sides.push_back({vertexOf(split.halves[0].node[0]), centre, result.halves[0]});
        sides.push_back({centre, vertexOf(split.halves[1].node[1]), result.halves[1]});
    }
    replaceTriangles(mesh, removed, added, sides, made);
    facetOf_[f].resize(mesh.triangleSlots());
    std::size_t next = 0;
    for (std::size_t i = 0; i < split.added.size(); ++i) {
        if (split.added[i].face == f) {
            facetOf_[f][made[next].value] = result.added[i];
            triangleOf_[result.added[i]] = made[next++];
        }
    }
}

bool SampledSurface::accepts(const SurfaceSplit& split) const
{
    if (split.removed.empty()) return false;
    for (const FacetId facet : split.removed) {
        const BrepFaceId f = mesh_.facets[facet].face;
        if (faces_->model().faces[f].surface->kind() != SurfaceKind::Plane) return false;
    }
    if (!split.segment.isValid()) return true;
    const BrepEdge& edge = faces_->model().edges[mesh_.segments[split.segment].edge];
    const double t = split.node.parameters.x;
    const auto& ends = mesh_.segments[split.segment].parameter;
    return edge.curve->kind() == CurveKind::Line && ends[0] < t && t < ends[1];
}

SurfaceSplitResult SampledSurface::commit(const SurfaceSplit& split)
{
    MESHER_PRECONDITION(split.status == SurfaceSplitStatus::Ready);
    SurfaceSplitResult result;
    if (split.segment.isValid()) {
        // On a shell the chain must know of it, so the place is asked for again.
        std::optional<SegmentPlace> place = faces_->chains().splitPlace(split.segment);
        if (!place || !(place->position == split.node.position))
            place = SegmentPlace{split.node.parameters.x, split.node.position, {}, 0.0};
        const SegmentSplit made = faces_->chains().split(split.segment, *place, mesh_.nodes);
        result.node = made.node;
        result.halves = made.halves;
        for (const SegmentId half : made.halves) mesh_.segments.push_back(faces_->chains().segments()[half]);
        mesh_.segments[split.segment] = faces_->chains().segments()[split.segment];
    } else {
        result.node = mesh_.nodes.push_back(split.node);
    }
    for (const SurfaceFacet& facet : split.added) {
        SurfaceFacet named = facet;
        named.node[newCornerOf(facet)] = result.node;
        result.added.push_back(mesh_.facets.push_back(named));
        triangleOf_.push_back({});
    }
    BrepFaceId last;
    for (const FacetId facet : split.removed) {
        const BrepFaceId f = mesh_.facets[facet].face;
        if (f != last) commitFace(f, split, result);
        last = f;
    }
    for (const FacetId facet : split.removed) mesh_.facets[facet].face = BrepFaceId();
    return result;
}

// ---- swaps -----------------------------------------------------------------------------------------------------------

/// Invalid if the facets are not neighbours on one face.
EdgeLink SampledSurface::sideBetween(FacetId first, FacetId second) const
{
    const BrepFaceId f = mesh_.facets[first].face;
    if (!f.isValid() || mesh_.facets[second].face != f) return {};
    const FaceMesh& mesh = faces_->face(f)->mesh;
    for (unsigned k = 0; k < 3; ++k) {
        const EdgeLink side(triangleOf_[first], k), other = mesh.across(side);
        if (other.isValid() && other.triangle() == triangleOf_[second]) return side;
    }
    return {};
}

bool SampledSurface::isHeld(FacetId facet) const
{
    return faces_->face(mesh_.facets[facet].face)->mesh.isOfFan(triangleOf_[facet]);
}

bool SampledSurface::maySwap(FacetId first, FacetId second) const
{
    const EdgeLink side = sideBetween(first, second);
    if (!side.isValid()) return false;
    const SampledFace& face = *faces_->face(mesh_.facets[first].face);
    return obstacleToFlip(face.mesh, face.geometry, side) == FlipObstacle::None;
}

std::array<FacetId, 2> SampledSurface::swap(FacetId first, FacetId second)
{
    const BrepFaceId f = mesh_.facets[first].face;
    SampledFace& face = *faces_->face(f);
    const EdgeLink diagonal = flip(face.mesh, face.geometry, sideBetween(first, second));
    std::array<FacetId, 2> added;
    const std::array<TriangleId, 2> made{diagonal.triangle(), face.mesh.across(diagonal).triangle()};
    for (std::size_t i = 0; i < 2; ++i) {
        const FaceTriangle& record = face.mesh.triangle(made[i]);
        SurfaceFacet facet{{}, f, record.uv};
        for (std::size_t k = 0; k < 3; ++k) facet.node[k] = face.mesh.vertex(record.v[k]).node;
        added[i] = mesh_.facets.push_back(facet);
        triangleOf_.push_back(made[i]);
        facetOf_[f][made[i].value] = added[i];
    }
    mesh_.facets[first].face = BrepFaceId();
    mesh_.facets[second].face = BrepFaceId();
    return added;
}

bool SampledSurface::isOnFlatRim(FacetId facet) const
{
    const FacetLeft left = faces().face(mesh().facets[facet].face)->mesh.triangle(triangleOf(facet)).left;
    return left == FacetLeft::Rim || left == FacetLeft::Strip;
}

}  // namespace mesher
