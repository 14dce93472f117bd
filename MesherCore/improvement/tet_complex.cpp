#include "improvement/tet_complex.h"

#include "improvement/dihedral_score.h"
#include "predicates/orient3d.h"

#include <algorithm>

namespace mesher {

namespace {

/// The order of the rest does not matter, but it must be the same in each run.
template <class T>
void erase(std::vector<T>& list, const T& item)
{
    const auto found = std::find(list.begin(), list.end(), item);
    MESHER_INVARIANT(found != list.end());
    *found = list.back();
    list.pop_back();
}

}  // namespace

TetComplex::TetComplex(const ClassifiedMesh& mesh)
    : nodes_(mesh.nodes),
      stars_(mesh.nodes.size()),
      facetStars_(mesh.nodes.size()),
      lines_(mesh.nodes.size()),
      versions_(mesh.nodes.size()),
      isRemoved_(mesh.nodes.size())
{
    IdVector<NodeId, std::uint32_t> degree(mesh.nodes.size());
    for (const auto& tet : mesh.tets) {
        for (const NodeId n : tet.node) ++degree[n];
    }
    constexpr std::size_t kSpare = 4;
    for (std::uint32_t i = 0; i < nodeLimit(); ++i) stars_[NodeId(i)].reserve(degree[NodeId(i)] + kSpare);
    tets_.reserve(mesh.tets.size() + mesh.tets.size() / 16);
    for (const auto& tet : mesh.tets) put(tets_.push_back({}), tet.node, tet.entity.index);
    for (const auto& triangle : mesh.triangles) {
        const FacetId f = facets_.push_back({triangle.node, triangle.entity.index});
        for (const NodeId n : triangle.node) facetStars_[n].push_back(f);
    }
    for (const auto& line : mesh.lines) {
        lines_[line.node[0]].push_back(line.node[1]);
        lines_[line.node[1]].push_back(line.node[0]);
    }
}

void TetComplex::writeTo(ClassifiedMesh& mesh) const
{
    IdVector<NodeId, NodeId> numberOf(nodes_.size());
    mesh.nodes.clear();
    for (std::uint32_t i = 0; i < nodeLimit(); ++i) {
        if (isRemoved_[NodeId(i)] == 0) numberOf[NodeId(i)] = mesh.nodes.push_back(nodes_[NodeId(i)]);
    }
    for (auto& point : mesh.points) point.node[0] = numberOf[point.node[0]];
    for (auto& line : mesh.lines) line.node = {numberOf[line.node[0]], numberOf[line.node[1]]};
    for (std::uint32_t i = 0; i < facetLimit(); ++i) {
        const FacetNodes& v = facets_[FacetId(i)].node;
        mesh.triangles[i].node = {numberOf[v[0]], numberOf[v[1]], numberOf[v[2]]};
    }
    mesh.tets.clear();
    for (const Tet& tet : tets_) {
        if (!tet.node[0].isValid()) continue;
        const TetNodes& v = tet.node;
        mesh.tets.push_back(
            {{numberOf[v[0]], numberOf[v[1]], numberOf[v[2]], numberOf[v[3]]}, {3, tet.solid}});
    }
    const auto isBefore = [](const auto& a, const auto& b) { return a.entity < b.entity; };
    if (!std::is_sorted(mesh.tets.begin(), mesh.tets.end(), isBefore))
        std::stable_sort(mesh.tets.begin(), mesh.tets.end(), isBefore);
}

bool TetComplex::isLine(NodeId a, NodeId b) const
{
    return std::find(lines_[a].begin(), lines_[a].end(), b) != lines_[a].end();
}

bool TetComplex::isPositive(const TetNodes& tet) const
{
    return orient3d(position(tet[0]), position(tet[1]), position(tet[2]), position(tet[3])) == Sign::Positive;
}

TetId TetComplex::tetBeside(NodeId a, NodeId b, NodeId c, TetId except) const
{
    for (const TetId t : stars_[a]) {
        if (t != except && hasNode(t, b) && hasNode(t, c)) return t;
    }
    return {};
}

bool TetComplex::isEdge(NodeId a, NodeId b) const
{
    return std::any_of(stars_[a].begin(), stars_[a].end(), [&](TetId t) { return hasNode(t, b); });
}

int TetComplex::facetsAt(NodeId a, NodeId b, std::array<FacetId, 2>& found) const
{
    int count = 0;
    if (facetStars_[b].empty()) return 0;
    for (const FacetId f : facetStars_[a]) {
        const FacetNodes& v = facets_[f].node;
        if (v[0] != b && v[1] != b && v[2] != b) continue;
        if (count < 2) found[static_cast<std::size_t>(count)] = f;
        ++count;
    }
    return count;
}

bool TetComplex::isOnSurface(NodeId a, NodeId b) const
{
    std::array<FacetId, 2> found;
    return facetsAt(a, b, found) > 0;
}

FacetNodes TetComplex::faceOf(TetId t, std::size_t slot) const
{
    static constexpr std::array<std::array<std::size_t, 3>, 4> kSlots = {
        {{1, 3, 2}, {0, 2, 3}, {0, 3, 1}, {0, 1, 2}}};
    const TetNodes& v = tets_[t].node;
    const auto& [i, j, k] = kSlots[slot];
    return {v[i], v[j], v[k]};
}

bool TetComplex::isFacet(const FacetNodes& face) const
{
    return std::any_of(facetStars_[face[0]].begin(), facetStars_[face[0]].end(), [&](FacetId f) {
        return std::is_permutation(face.begin(), face.end(), facets_[f].node.begin());
    });
}

void TetComplex::put(TetId t, const TetNodes& nodes, std::uint32_t solid)
{
    tets_[t] = {nodes, solid, dihedralScore(corners(nodes))};
    for (const NodeId n : nodes) {
        stars_[n].push_back(t);
        ++versions_[n];
    }
}

void TetComplex::take(TetId t)
{
    for (const NodeId n : tets_[t].node) {
        erase(stars_[n], t);
        ++versions_[n];
    }
    tets_[t].node[0] = NodeId();
}

void TetComplex::replaceTets(std::span<const TetId> before, std::span<const TetNodes> after)
{
    const std::uint32_t solid = tets_[before.front()].solid;
    for (const TetId t : before) {
        MESHER_PRECONDITION(tets_[t].solid == solid);
        take(t);
    }
    for (std::size_t i = 0; i < after.size(); ++i) {
        TetId t;
        if (i < before.size()) {
            t = before[i];
        } else if (freeTets_.empty()) {
            t = tets_.push_back({});
        } else {
            t = freeTets_.back();
            freeTets_.pop_back();
        }
        put(t, after[i], solid);
    }
    for (std::size_t i = before.size(); i > after.size(); --i) freeTets_.push_back(before[i - 1]);
}

void TetComplex::replaceFacets(const std::array<FacetId, 2>& facets, const std::array<FacetNodes, 2>& after)
{
    for (std::size_t i = 0; i < 2; ++i) {
        for (const NodeId n : facets_[facets[i]].node) erase(facetStars_[n], facets[i]);
    }
    for (std::size_t i = 0; i < 2; ++i) {
        facets_[facets[i]].node = after[i];
        for (const NodeId n : after[i]) {
            facetStars_[n].push_back(facets[i]);
            ++versions_[n];
        }
    }
}

void TetComplex::move(NodeId n, const Vec3& position, Vec2 parameters)
{
    nodes_[n].position = position;
    nodes_[n].parameters = parameters;
    for (const TetId t : stars_[n]) {
        tets_[t].score = dihedralScore(corners(tets_[t].node));
        for (const NodeId other : tets_[t].node) ++versions_[other];
    }
}

void TetComplex::removeNode(NodeId n)
{
    MESHER_PRECONDITION(stars_[n].empty() && facetStars_[n].empty());
    isRemoved_[n] = 1;
}

NodeId TetComplex::addNode(const MeshNode& node)
{
    stars_.push_back({});
    facetStars_.push_back({});
    lines_.push_back({});
    versions_.push_back(0);
    isRemoved_.push_back(0);
    return nodes_.push_back(node);
}

}  // namespace mesher
