#include "delaunay/triangulation3d.h"

#include "delaunay/id_set.h"

#include <algorithm>
#include <stdexcept>

namespace mesher {

namespace {

constexpr std::uint32_t kDeadDimension = 7;

}  // namespace

VertexId Triangulation3d::addVertex(Vec3 position, VertexClass classification)
{
    if (freeVertexCount_ > 0) {
        const VertexId vertex = freeVertex_;
        freeVertex_ = VertexId(incidentTet_[vertex].value);
        --freeVertexCount_;
        vertices_[vertex] = {position, 0.0};
        incidentTet_[vertex] = TetId();
        vertexClass_[vertex] = classification;
        return vertex;
    }
    vertices_.push_back({position, 0.0});
    incidentTet_.push_back(TetId());
    return vertexClass_.push_back(classification);
}

void Triangulation3d::removeVertex(VertexId vertex)
{
    MESHER_PRECONDITION(isVertexAlive(vertex));
    vertexClass_[vertex].dimension = kDeadDimension;
    incidentTet_[vertex] = TetId(freeVertex_.value);
    freeVertex_ = vertex;
    ++freeVertexCount_;
}

bool Triangulation3d::isVertexAlive(VertexId vertex) const
{
    return vertex.value < vertexLimit() && vertexClass_[vertex].dimension != kDeadDimension;
}

std::uint32_t Triangulation3d::finiteTetCount() const
{
    std::uint32_t count = 0;
    for (std::uint32_t i = 0; i < tetLimit(); ++i)
        count += isAlive(TetId(i)) && !isGhostTet(TetId(i)) ? 1u : 0u;
    return count;
}

void Triangulation3d::growTets()
{
    // A quarter instead of doubling: the arrays of a finished mesh hold little that is not used.
    if (tets_.size() >= kMaxTets) throw std::length_error("more than 2^30 tetrahedra");
    const std::size_t size = std::min<std::size_t>(kMaxTets, tets_.size() + tets_.size() / 4 + 64);
    tets_.reserve(size);
    states_.reserve(size);
    regions_.reserve(size);
}

TetId Triangulation3d::allocateTet()
{
    if (!freeTets_.empty()) {
        const TetId tet = freeTets_.back();
        freeTets_.pop_back();
        renewTet(tet);
        regions_[tet] = kExteriorRegion;
        return tet;
    }
    if (tets_.size() == tets_.capacity()) growTets();
    tets_.push_back({});
    states_.push_back({0, firstGeneration_});
    return regions_.push_back(kExteriorRegion);
}

void Triangulation3d::freeTet(TetId tet)
{
    MESHER_PRECONDITION(isAlive(tet));
    renewTet(tet);
    states_[tet].flags = tet_flag::kDead;
    freeTets_.push_back(tet);
}

/// Lists the tetrahedra at a vertex until one is what is looked for; that one, or invalid.
template <class Predicate>
TetId Triangulation3d::walkStar(VertexId vertex, std::vector<TetId>& star, const Predicate& isSought) const
{
    star.clear();
    const TetId start = incidentTet_[vertex];
    if (!start.isValid()) return {};
    IdSet seen;
    seen.insert(start.value);
    star.push_back(start);
    for (std::size_t next = 0; next < star.size(); ++next) {
        if (isSought(star[next])) return star[next];
        const TetRecord& record = tets_[star[next]];
        for (unsigned face = 0; face < 4; ++face) {
            if (record.vertex[face] == vertex) continue;
            const TetId other = record.neighbour[face].tet();
            if (seen.insert(other.value)) star.push_back(other);
        }
    }
    return {};
}

void Triangulation3d::collectStar(VertexId vertex, std::vector<TetId>& star) const
{
    walkStar(vertex, star, [](TetId) { return false; });
}

TetId Triangulation3d::findEdge(VertexId a, VertexId b) const
{
    if (isGhost(a)) std::swap(a, b);
    std::vector<TetId> star;
    return walkStar(a, star, [&](TetId t) { return slotOf(t, b) >= 0; });
}

TetFace Triangulation3d::findFace(VertexId a, VertexId b, VertexId c) const
{
    if (isGhost(a)) std::swap(a, c);
    std::vector<TetId> star;
    const TetId found = walkStar(a, star, [&](TetId t) { return slotOf(t, b) >= 0 && slotOf(t, c) >= 0; });
    if (!found.isValid()) return {};
    return {found, 6 - slotOf(found, a) - slotOf(found, b) - slotOf(found, c)};
}

void Triangulation3d::collectEdgeRing(TetId start, VertexId a, VertexId b, std::vector<TetId>& ring) const
{
    ring.clear();
    TetId current = start;
    // Leave through the face opposite the ring vertex that comes first after (a, b) in positive order.
    int exit = -1;
    for (int face = 0; face < 4 && exit < 0; ++face) {
        const auto [f0, f1, f2] = faceVertices({start, face});
        const bool holdsDirectedEdge = (f0 == a && f1 == b) || (f1 == a && f2 == b) || (f2 == a && f0 == b);
        if (holdsDirectedEdge) exit = face;
    }
    MESHER_PRECONDITION(exit >= 0);
    do {
        ring.push_back(current);
        const TetFace entry = neighbour(current, exit);
        const int entered = entry.face();
        current = entry.tet();
        // Of the two faces at the edge leave by the one that was not entered by.
        exit = 6 - slotOf(current, a) - slotOf(current, b) - entered;
        MESHER_INVARIANT(ring.size() <= tetLimit());
    } while (current != start);
}

void Triangulation3d::setFaceConstrained(TetFace face, bool constrained)
{
    wasConstrained_ |= constrained;
    for (const TetFace side : {face, neighbour(face)}) {
        std::uint16_t& flags = states_[side.tet()].flags;
        const std::uint16_t bit = tet_flag::face(side.face());
        flags = static_cast<std::uint16_t>(constrained ? flags | bit : flags & ~bit);
    }
}

void Triangulation3d::setEdgeConstrained(TetId tet, VertexId a, VertexId b, bool constrained)
{
    wasConstrained_ |= constrained;
    std::vector<TetId> ring;
    collectEdgeRing(tet, a, b, ring);
    for (const TetId t : ring) {
        std::uint16_t& flags = states_[t].flags;
        const std::uint16_t bit = tet_flag::edge(kEdgeOfSlots[slotOf(t, a)][slotOf(t, b)]);
        flags = static_cast<std::uint16_t>(constrained ? flags | bit : flags & ~bit);
    }
}

void Triangulation3d::clear()
{
    vertices_.clear();
    incidentTet_.clear();
    vertexClass_.clear();
    freeVertex_ = VertexId();
    freeVertexCount_ = 0;
    tets_.clear();
    states_.clear();
    regions_.clear();
    freeTets_.clear();
    firstGeneration_ = 0;
    wasConstrained_ = false;
}

void Triangulation3d::reserve(std::size_t vertices, std::size_t tets)
{
    vertices_.reserve(vertices);
    incidentTet_.reserve(vertices);
    vertexClass_.reserve(vertices);
    tets_.reserve(tets);
    states_.reserve(tets);
    regions_.reserve(tets);
}

Renumbering3d Triangulation3d::compact()
{
    Renumbering3d map{IdVector<VertexId, VertexId>(vertexLimit()), IdVector<TetId, TetId>(tetLimit())};
    std::uint32_t vertexEnd = 0;
    for (std::uint32_t i = 0; i < vertexLimit(); ++i) {
        const VertexId from(i);
        if (!isVertexAlive(from)) continue;
        const VertexId to(vertexEnd++);
        map.vertex[from] = to;
        vertices_[to] = vertices_[from];
        incidentTet_[to] = incidentTet_[from];
        vertexClass_[to] = vertexClass_[from];
    }
    std::uint32_t tetEnd = 0;
    for (std::uint32_t i = 0; i < tetLimit(); ++i) {
        if (isAlive(TetId(i))) map.tet[TetId(i)] = TetId(tetEnd++);
    }
    for (std::uint32_t i = 0; i < tetLimit(); ++i) {
        const TetId to = map.tet[TetId(i)];
        if (!to.isValid()) continue;
        TetRecord record = tets_[TetId(i)];
        for (VertexId& v : record.vertex) v = isGhost(v) ? v : map.vertex[v];
        for (TetFace& n : record.neighbour) n = TetFace(map.tet[n.tet()], n.face());
        tets_[to] = record;
        states_[to].flags = states_[TetId(i)].flags;
        regions_[to] = regions_[TetId(i)];
    }
    // Slots that are cut off may come again: no entry of before may then pass for a current one.
    for (const TetState& state : states_) {
        firstGeneration_ = std::max(firstGeneration_, static_cast<std::uint16_t>(state.generation + 1));
    }
    vertices_.resize(vertexEnd);
    incidentTet_.resize(vertexEnd);
    vertexClass_.resize(vertexEnd);
    tets_.resize(tetEnd);
    states_.resize(tetEnd);
    regions_.resize(tetEnd);
    for (TetState& state : states_) ++state.generation;
    for (TetId& t : incidentTet_) t = t.isValid() ? map.tet[t] : t;
    freeTets_.clear();
    freeVertex_ = VertexId();
    freeVertexCount_ = 0;
    return map;
}

void Triangulation3d::rebuildIncidentTets()
{
    for (std::uint32_t i = 0; i < tetLimit(); ++i) {
        if (!isAlive(TetId(i))) continue;
        const auto& vertices = tets_[TetId(i)].vertex;
        for (unsigned slot = 0; slot < 3; ++slot) incidentTet_[vertices[slot]] = TetId(i);
        if (!isGhost(vertices[3])) incidentTet_[vertices[3]] = TetId(i);
    }
}

std::size_t Triangulation3d::bytes() const
{
    return vertices_.capacity() * sizeof(VertexRecord) + incidentTet_.capacity() * sizeof(TetId) +
           vertexClass_.capacity() * sizeof(VertexClass) + tets_.capacity() * sizeof(TetRecord) +
           states_.capacity() * sizeof(TetState) + regions_.capacity() * sizeof(RegionId) +
           freeTets_.capacity() * sizeof(TetId);
}

}  // namespace mesher
