#include "refinement/length_scale3d.h"

#include "refinement/local_feature_size.h"
#include "refinement/meshed_tets.h"
#include "sizing/gradation.h"

#include <algorithm>

namespace mesher {

namespace {

/// Scales that are too high by less than this are left: each lowering looks at its neighbourhood again.
constexpr double kSlack = 1.02;

/// The length scale at the boundary over the mean side of the facets there. Facets around a vertex differ by up to a quarter from
/// their mean where the surface is refined to one size; those must not be split for that.
constexpr double kScaleOfSides = 1.25;

GradationGraph graphOf(const Triangulation3d& mesh)
{
    std::vector<std::uint64_t> keys;
    for (std::uint32_t i = 0; i < mesh.tetLimit(); ++i) {
        if (!isMeshed(mesh, TetId(i))) continue;
        for (const auto& [from, to] : kEdgeSlots) {
            const VertexId a = mesh.vertex(TetId(i), from);
            const VertexId b = mesh.vertex(TetId(i), to);
            keys.push_back(std::uint64_t{std::min(a, b).value} << 32 | std::max(a, b).value);
        }
    }
    std::sort(keys.begin(), keys.end());
    keys.erase(std::unique(keys.begin(), keys.end()), keys.end());
    std::vector<GradationGraph::Edge> edges;
    edges.reserve(keys.size());
    for (const std::uint64_t key : keys) {
        const auto a = static_cast<std::uint32_t>(key >> 32);
        const auto b = static_cast<std::uint32_t>(key);
        edges.push_back({a, b, length(mesh.position(VertexId(a)) - mesh.position(VertexId(b)))});
    }
    return GradationGraph::of(mesh.vertexLimit(), edges);
}

}  // namespace

LengthScale3d::LengthScale3d(ConstrainedTetrahedralization& tetrahedralization, const VolumeSizing& sizing)
    : tetrahedralization_(tetrahedralization), mesh_(tetrahedralization.mesh()), sizing_(sizing)
{
}

double LengthScale3d::wantedAt(const Vec3& position) const
{
    if (sizing_.field == nullptr) return kNoSize;
    const double scale = tetrahedralization_.scale;
    return scale * sizing_.field->sizeAt((1.0 / scale) * position);
}

double LengthScale3d::wantedNear(const Vec3& position, double radius) const
{
    if (sizing_.field == nullptr) return kNoSize;
    const double scale = tetrahedralization_.scale;
    return scale * sizing_.field->smallestNear((1.0 / scale) * position, radius / scale);
}

void LengthScale3d::setInitial()
{
    const GradationGraph graph = graphOf(mesh_);
    std::vector<double> guard = localFeatureSizes(mesh_);
    std::vector<double> sides(guard.size(), kNoSize);
    if (sizing_.usesFacetSides) sides = meanFacetSides(mesh_);
    std::vector<double> size(guard.size(), kNoSize);
    for (std::uint32_t i = 0; i < guard.size(); ++i) {
        if (guard[i] == kNoSize) continue;
        size[i] = std::min(wantedAt(mesh_.position(VertexId(i))), kScaleOfSides * sides[i]);
        guard[i] = std::min(guard[i] / sizing_.refinement, size[i]);
    }
    gradeSizes(graph, sizing_.grading, guard);
    if (!sizing_.usesLocalFeatureSize) gradeSizes(graph, sizing_.grading, size);
    guard_.clear();
    guard_.resize(guard.size(), kNoSize);
    for (std::uint32_t i = 0; i < guard.size(); ++i) {
        if (!mesh_.isVertexAlive(VertexId(i))) continue;
        mesh_.setLengthScale(VertexId(i), sizing_.usesLocalFeatureSize ? guard[i] : size[i]);
        setGuard(VertexId(i), guard[i]);
    }
}

void LengthScale3d::setGuard(VertexId v, double value)
{
    if (guard_.size() <= v.value) guard_.resize(v.value + v.value / 4u + 16u, kNoSize);
    guard_[v] = value;
}

void LengthScale3d::leaveOut(VertexId v)
{
    mesh_.setLengthScale(v, kNoSize);
    setGuard(v, kNoSize);
}

bool LengthScale3d::assign(VertexId v, std::span<const VertexId> neighbours, double sizeCeiling)
{
    const Vec3 p = mesh_.position(v);
    const double slope = 1.0 / sizing_.grading;
    double newSize = std::min(wantedAt(p), sizeCeiling);
    double guards = 0.0;
    int count = 0;
    growths_.clear();
    for (const VertexId w : neighbours) {
        growths_.push_back(kNoSize);
        if (isGhost(w) || guard_[w] == kNoSize) continue;
        growths_.back() = slope * length(mesh_.position(w) - p);
        newSize = std::min(newSize, size(w) + growths_.back());
        guards += guard_[w];
        ++count;
    }
    mesh_.setLengthScale(v, newSize);
    setGuard(v, count == 0 ? newSize : std::min(newSize, guards / count));
    for (std::size_t i = 0; i < neighbours.size(); ++i) {
        if (growths_[i] != kNoSize && size(neighbours[i]) > kSlack * (newSize + growths_[i])) return true;
    }
    return false;
}

void LengthScale3d::gradeAgainFrom(VertexId v, std::vector<VertexId>& lowered)
{
    lowered.clear();
    front_.assign(1, v);
    const double slope = 1.0 / sizing_.grading;
    for (std::size_t next = 0; next < front_.size(); ++next) {
        const VertexId from = front_[next];
        mesh_.collectStar(from, star_);
        for (const TetId tet : star_) {
            if (!isMeshed(mesh_, tet)) continue;
            for (const VertexId to : mesh_.tet(tet).vertex) {
                if (to == from) continue;
                const double growth = slope * length(mesh_.position(to) - mesh_.position(from));
                const double bound = size(from) + growth;
                if (size(to) <= kSlack * bound) continue;
                mesh_.setLengthScale(to, bound);
                guard_[to] = std::min(guard_[to], bound);
                front_.push_back(to);
                lowered.push_back(to);
            }
        }
    }
    std::sort(lowered.begin(), lowered.end());
    lowered.erase(std::unique(lowered.begin(), lowered.end()), lowered.end());
}

}  // namespace mesher
