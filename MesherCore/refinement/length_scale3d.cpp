#include "refinement/length_scale3d.h"

#include "sizing/gradation.h"

#include <algorithm>
#include <cmath>

namespace mesher {

namespace {

/// Scales that are too high by less than this are left: each lowering looks at its neighbourhood again.
constexpr double kSlack = 1.02;

double distanceToSegment(const Vec3& p, const Vec3& a, const Vec3& b)
{
    const Vec3 along = b - a;
    const double t = std::clamp(dot(p - a, along) / squaredLength(along), 0.0, 1.0);
    return length(p - (a + t * along));
}

double distanceToTriangle(const Vec3& p, const Vec3& a, const Vec3& b, const Vec3& c)
{
    const Vec3 normal = cross(b - a, c - a);
    const auto isInsideOf = [&](const Vec3& from, const Vec3& to) {
        return dot(cross(to - from, p - from), normal) >= 0.0;
    };
    if (isInsideOf(a, b) && isInsideOf(b, c) && isInsideOf(c, a)) {
        return std::abs(dot(p - a, normal)) / length(normal);
    }
    return std::min({distanceToSegment(p, a, b), distanceToSegment(p, b, c), distanceToSegment(p, c, a)});
}

bool isMeshed(const Triangulation3d& mesh, TetId tet)
{
    return mesh.isAlive(tet) && mesh.region(tet) != kExteriorRegion && !mesh.isGhostTet(tet);
}

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

/// The three distances of thesis section 4.4, as far as this tetrahedron knows them.
void LengthScale3d::lowerToLocalFeatures(TetId tet, std::vector<double>& lfs) const
{
    const auto& vertex = mesh_.tet(tet).vertex;
    std::array<Vec3, 4> p;
    for (unsigned i = 0; i < 4; ++i) p[i] = mesh_.position(vertex[i]);
    for (const auto& [from, to] : kEdgeSlots) {
        const auto i = static_cast<unsigned>(from);
        const auto j = static_cast<unsigned>(to);
        const double distance = length(p[j] - p[i]);
        lfs[vertex[i].value] = std::min(lfs[vertex[i].value], distance);
        lfs[vertex[j].value] = std::min(lfs[vertex[j].value], distance);
    }
    for (unsigned face = 0; face < 4; ++face) {
        if (!mesh_.isFaceConstrained({tet, static_cast<int>(face)})) continue;
        const unsigned a = static_cast<unsigned>(kFaceSlots[face][0]);
        const unsigned b = static_cast<unsigned>(kFaceSlots[face][1]);
        const unsigned c = static_cast<unsigned>(kFaceSlots[face][2]);
        double& apex = lfs[vertex[face].value];
        apex = std::min(apex, distanceToTriangle(p[face], p[a], p[b], p[c]));
        for (const auto& [v, from, to] : {std::array{a, b, c}, std::array{b, c, a}, std::array{c, a, b}}) {
            double& corner = lfs[vertex[v].value];
            corner = std::min(corner, distanceToSegment(p[v], p[from], p[to]));
        }
    }
}

std::vector<double> LengthScale3d::localFeatureSizes() const
{
    std::vector<double> lfs(mesh_.vertexLimit(), kNoSize);
    for (std::uint32_t i = 0; i < mesh_.tetLimit(); ++i) {
        if (isMeshed(mesh_, TetId(i))) lowerToLocalFeatures(TetId(i), lfs);
    }
    return lfs;
}

void LengthScale3d::setInitial()
{
    const GradationGraph graph = graphOf(mesh_);
    std::vector<double> guard = localFeatureSizes();
    std::vector<double> size(guard.size(), kNoSize);
    for (std::uint32_t i = 0; i < guard.size(); ++i) {
        if (guard[i] == kNoSize) continue;
        size[i] = wantedAt(mesh_.position(VertexId(i)));
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
