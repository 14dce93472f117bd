#include "refinement/flat_strips.h"

#include "predicates/circumcenter.h"
#include "sizing/sizing_field.h"

#include <algorithm>
#include <iterator>
#include <utility>

namespace mesher {

namespace {

/// Circumradius of a tetrahedron across a strip over the length of the strip's facets, above which it is refined like any other:
/// it reaches into the solid beyond what they make flat.
constexpr double kMostRadius = 1.0;
/// Length of a side's segment over that at the start, above which it may be split for quality.
constexpr double kLeastLength = 0.8;
/// The same of what only touches a strip. Without it facets beside several strips would be split without end, for the sake of what
/// these keep flat.
constexpr double kLeastBeside = 0.5;
/// Width over the length of facets, below which a strip is narrow.
constexpr double kNarrow = 0.25;

}  // namespace

namespace {

/// The edges of the model that nodes are on.
IdVector<NodeId, std::vector<BrepEdgeId>> edgesOfNodes(const SurfaceMesh& surface)
{
    IdVector<NodeId, std::vector<BrepEdgeId>> edges(surface.nodes.size());
    for (const SurfaceSegment& segment : surface.segments) {
        if (!segment.isAlive()) continue;
        for (const NodeId node : segment.node) edges[node].push_back(segment.edge);
    }
    return edges;
}

}  // namespace

void FlatStrips::find(const SurfaceMesh& surface, std::span<const FlatStripFacet> facets)
{
    hasAny_ = !facets.empty();
    if (!hasAny_) return;
    marks_.resize(1);
    const IdVector<NodeId, std::vector<BrepEdgeId>> edges = edgesOfNodes(surface);
    for (const FlatStripFacet& flat : facets) {
        const auto& node = surface.facets[flat.facet].node;
        Vec3 longest;
        for (std::size_t k = 0; k < 3; ++k) {
            const Vec3 side = surface.nodes[node[(k + 1) % 3]].position - surface.nodes[node[k]].position;
            if (squaredLength(side) > squaredLength(longest)) longest = side;
        }
        for (const NodeId n : node) {
            Mark& mark = marked(t_.vertexOf[n]);
            if (edges[n].empty()) mark.sides.push_back({flat.face, {}});
            for (const BrepEdgeId edge : edges[n]) mark.sides.push_back({flat.face, edge});
            if (t_.scale * length(longest) <= mark.length) continue;
            mark.length = t_.scale * length(longest);
            mark.along = t_.scale * longest;
        }
    }
    for (Mark& mark : marks_) {
        std::sort(mark.sides.begin(), mark.sides.end());
        mark.sides.erase(std::unique(mark.sides.begin(), mark.sides.end()), mark.sides.end());
    }
}

FlatStrips::Mark& FlatStrips::marked(VertexId v)
{
    if (markOf_.size() <= v.value) markOf_.resize(v.value + 1, 0);
    if (markOf_[v] == 0) {
        markOf_[v] = static_cast<std::uint32_t>(marks_.size());
        marks_.emplace_back();
    }
    return marks_[markOf_[v]];
}

std::vector<FlatStrips::Side> FlatStrips::common(const Mark& a, const Mark& b)
{
    std::vector<Side> both;
    std::set_intersection(a.sides.begin(), a.sides.end(), b.sides.begin(), b.sides.end(),
                          std::back_inserter(both));
    return both;
}

/// Of a strip between the two, which are side by side there: on different edges, or nearer to each other than facets are long.
std::optional<BrepFaceId> FlatStrips::faceBetween(VertexId v, VertexId w) const
{
    const Mark *a = markOf(v), *b = markOf(w);
    if (a == nullptr || b == nullptr) return std::nullopt;
    const Vec3 apart = t_.mesh().position(w) - t_.mesh().position(v);
    const bool isNear = length(apart) < kNarrow * a->length;
    if (!isNear && length(cross(apart, a->along)) >= kNarrow * a->length * a->length) return std::nullopt;
    for (const Side& side : a->sides) {
        const auto other = std::find_if(b->sides.begin(), b->sides.end(),
                                        [&](const Side& s) { return s.strip == side.strip; });
        if (other == b->sides.end()) continue;
        if (isNear || common(*a, *b).empty()) return side.strip;
    }
    return std::nullopt;
}

std::optional<BrepFaceId> FlatStrips::faceAcrossed(std::span<const VertexId> corners) const
{
    for (std::size_t i = 0; i < corners.size(); ++i) {
        for (std::size_t k = i + 1; k < corners.size(); ++k) {
            if (const auto face = faceBetween(corners[i], corners[k])) return face;
        }
    }
    return std::nullopt;
}

bool FlatStrips::isAcrossSome(TetId tet) const
{
    const auto& v = t_.mesh().tet(tet).vertex;
    if (!faceAcrossed(v)) return false;
    double longest = 0.0;
    for (const VertexId corner : v) {
        if (const Mark* mark = markOf(corner)) longest = std::max(longest, mark->length);
    }
    const auto centre = approximateCircumcenter(t_.mesh().position(v[0]), t_.mesh().position(v[1]),
                                                t_.mesh().position(v[2]), t_.mesh().position(v[3]));
    const double most = kMostRadius * longest;
    return !centre || squaredLength(*centre - t_.mesh().position(v[0])) < most * most;
}

bool FlatStrips::maySplit(std::span<const VertexId> corners, double size) const
{
    if (!hasAny_) return true;
    double least = kNoSize;
    bool isSide = corners.size() == 2;
    for (const VertexId v : corners) {
        const Mark* mark = markOf(v);
        isSide = isSide && mark != nullptr;
        if (mark != nullptr) least = std::min(least, mark->length);
    }
    if (least == kNoSize) return true;
    if (faceAcrossed(corners)) return false;
    isSide = isSide && !common(*markOf(corners[0]), *markOf(corners[1])).empty();
    return size > (isSide ? kLeastLength : kLeastBeside) * least;
}

std::optional<BrepFaceId> FlatStrips::faceBeside(TetId tet) const
{
    if (!hasAny_) return std::nullopt;
    const auto& v = t_.mesh().tet(tet).vertex;
    if (const auto face = faceAcrossed(v)) return face;
    for (std::size_t i = 0; i < v.size(); ++i) {
        const Mark* a = markOf(v[i]);
        for (std::size_t k = i + 1; a != nullptr && k < v.size(); ++k) {
            const Mark* b = markOf(v[k]);
            if (b == nullptr) continue;
            const std::vector<Side> both = common(*a, *b);
            if (!both.empty()) return both.front().strip;
        }
    }
    return std::nullopt;
}

void FlatStrips::assign(VertexId v, std::span<const VertexId> surround)
{
    if (!hasAny_) return;
    if (v.value < markOf_.size()) markOf_[v] = 0;
    if (surround.size() != 2) return;
    const Mark *a = markOf(surround[0]), *b = markOf(surround[1]);
    if (a == nullptr || b == nullptr) return;
    Mark mark{common(*a, *b), std::min(a->length, b->length), a->along};
    if (!mark.sides.empty()) marked(v) = std::move(mark);
}

}  // namespace mesher
