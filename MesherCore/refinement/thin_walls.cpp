#include "refinement/thin_walls.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace mesher {

namespace {

/// Thickness over the longest edge of a facet, below which a wall is thin there: above, it takes few more to make it good.
constexpr double kThin = 0.25;
/// The same, up to which a wall that is kept is kept: where it turns into the sizes around it.
constexpr double kKept = 1.0;
/// Cosine between the inward normals of two sides that look at each other.
constexpr double kOpposite = -0.7;
/// Good tetrahedra per area of both sides over the squared thickness, as measured on hollowed boxes.
constexpr double kTetsPerSide = 2.0;
/// Size of a facet of a kept wall over what it was at the start, down to which it may be split for its other side.
constexpr double kLeastSize = 0.8;

/// Inward, with the length of twice the area.
Vec3 normalOf(const Triangulation3d& mesh, TetFace face)
{
    const auto [a, b, c] = mesh.faceVertices(face);
    const Vec3& origin = mesh.position(a);
    return cross(mesh.position(b) - origin, mesh.position(c) - origin);
}

double longestEdge(const Triangulation3d& mesh, TetFace face)
{
    const auto [a, b, c] = mesh.faceVertices(face);
    return std::sqrt(std::max({squaredLength(mesh.position(b) - mesh.position(a)),
                               squaredLength(mesh.position(c) - mesh.position(b)),
                               squaredLength(mesh.position(a) - mesh.position(c))}));
}

bool isMeshed(const Triangulation3d& mesh, TetId tet)
{
    return mesh.isAlive(tet) && mesh.region(tet) != kExteriorRegion && !mesh.isGhostTet(tet);
}

BrepFaceId faceOf(const ConstrainedTetrahedralization& t, TetFace face, const SurfaceMesh& surface)
{
    std::array<VertexId, 3> corners = t.mesh().faceVertices(face);
    std::sort(corners.begin(), corners.end());
    const FacetId* facet = t.facetOf.find(corners);
    return facet == nullptr ? BrepFaceId() : surface.facets[*facet].face;
}

}  // namespace

void ThinWalls::find(const SurfaceMesh& surface, double budget, std::span<const FlatWallFacet> flat)
{
    collectSides(surface, flat);
    choose(budget);
    markKept(surface);
    sides_.clear();
}

void ThinWalls::collectSides(const SurfaceMesh& surface, std::span<const FlatWallFacet> flat)
{
    const Triangulation3d& mesh = t_.mesh();
    for (std::uint32_t i = 0; i < mesh.tetLimit(); ++i) {
        const TetId tet(i);
        if (!isMeshed(mesh, tet) || (mesh.flags(tet) & tet_flag::kFaces) == 0) continue;
        for (int f = 0; f < 4; ++f) {
            const TetFace face(tet, f);
            if (mesh.isFaceConstrained(face) && !addFlatSides(face, flat)) measureSide(face, surface);
        }
    }
}

/// Where the surface was made for a flat wall; facets there need not have the other side's vertices on their tetrahedra.
bool ThinWalls::addFlatSides(TetFace face, std::span<const FlatWallFacet> flat)
{
    if (flat.empty()) return false;
    std::array<VertexId, 3> corners = t_.mesh().faceVertices(face);
    std::sort(corners.begin(), corners.end());
    const FacetId* facet = t_.facetOf.find(corners);
    if (facet == nullptr) return false;
    const RegionId region = t_.mesh().region(face.tet());
    auto at = std::lower_bound(flat.begin(), flat.end(), *facet,
                               [](const FlatWallFacet& a, FacetId b) { return a.facet < b; });
    for (; at != flat.end() && at->facet == *facet; ++at) {
        if (at->sides.region != region) continue;
        const std::uint32_t between = wallBetween(at->sides.face[0], at->sides.face[1], region);
        ThinWall& wall = walls_[between];
        wall.isAsked = true;
        wall.facets += 1.0;
        if (wall.thickness == 0.0 || at->thickness < wall.thickness) {
            wall.thickness = at->thickness;
            wall.place = at->middle;
        }
        sides_.push_back({face, between});
        return true;
    }
    return false;
}

void ThinWalls::measureSide(TetFace face, const SurfaceMesh& surface)
{
    const Triangulation3d& mesh = t_.mesh();
    const VertexId apex = mesh.vertex(face.tet(), face.face());
    if (!t_.nodeOf[apex].isValid()) return;
    const Vec3 normal = normalOf(mesh, face);
    const double area = 0.5 * length(normal);
    const Vec3& corner = mesh.position(mesh.faceVertices(face)[0]);
    const double height = dot(normal, mesh.position(apex) - corner) / (2.0 * area);
    if (!(height > 0.0 && height < kKept * longestEdge(mesh, face))) return;
    const BrepFaceId across = faceAcross(face, apex, surface);
    if (!across.isValid()) return;
    const std::uint32_t between = wallBetween(faceOf(t_, face, surface), across, mesh.region(face.tet()));
    sides_.push_back({face, between});
    if (height >= kThin * longestEdge(mesh, face)) return;
    ThinWall& wall = walls_[between];
    wall.facets += 1.0;
    wall.tets += kTetsPerSide * area / (height * height);
    if (wall.thickness == 0.0 || height < wall.thickness * t_.scale) {
        wall.thickness = height / t_.scale;
        wall.place = (1.0 / t_.scale) * mesh.position(apex);
    }
}

/// The face of the apex that looks at a facet from across its tetrahedron; invalid if none does.
BrepFaceId ThinWalls::faceAcross(TetFace face, VertexId apex, const SurfaceMesh& surface) const
{
    const Triangulation3d& mesh = t_.mesh();
    const Vec3 normal = normalOf(mesh, face);
    const double limit = kOpposite * length(normal);
    std::vector<TetId> star;
    mesh.collectStar(apex, star);
    BrepFaceId across;
    double best = 0.0;
    for (const TetId tet : star) {
        if (!isMeshed(mesh, tet) || mesh.region(tet) != mesh.region(face.tet())) continue;
        for (int f = 0; f < 4; ++f) {
            if (mesh.vertex(tet, f) == apex || !mesh.isFaceConstrained({tet, f})) continue;
            const Vec3 other = normalOf(mesh, {tet, f});
            const double cosine = dot(normal, other) / length(other);
            if (cosine > limit || cosine >= best) continue;
            best = cosine;
            across = faceOf(t_, {tet, f}, surface);
        }
    }
    return across;
}

std::uint32_t ThinWalls::wallBetween(BrepFaceId a, BrepFaceId b, RegionId region)
{
    const std::array<BrepFaceId, 2> face{std::min(a, b), std::max(a, b)};
    const auto found = std::find_if(walls_.begin(), walls_.end(),
                                    [&](const ThinWall& w) { return w.face == face && w.region == region; });
    if (found != walls_.end()) return static_cast<std::uint32_t>(found - walls_.begin());
    walls_.push_back({face, region, 0.0, 0.0, 0.0, {}, false, false});
    return static_cast<std::uint32_t>(walls_.size() - 1);
}

/// The cheapest are made good as long as the budget lasts.
void ThinWalls::choose(double budget)
{
    std::vector<std::uint32_t> order(walls_.size());
    std::iota(order.begin(), order.end(), 0u);
    std::stable_sort(order.begin(), order.end(),
                     [&](std::uint32_t a, std::uint32_t b) { return walls_[a].tets < walls_[b].tets; });
    double spent = 0.0;
    for (const std::uint32_t i : order) {
        ThinWall& wall = walls_[i];
        if (!wall.isAsked) spent += wall.tets;
        wall.isKept = wall.isAsked || (wall.tets > 0.0 && spent > budget);
        hasKept_ = hasKept_ || wall.isKept;
    }
}

/// A vertex is in a kept wall if all facets around it on the wall's own faces and side are, and its rim is not finer than
/// the wall.
void ThinWalls::markKept(const SurfaceMesh& surface)
{
    if (!hasKept_) return;
    const Triangulation3d& mesh = t_.mesh();
    marks_.resize(mesh.vertexLimit());
    std::vector<std::uint32_t> kept(mesh.vertexLimit(), 0);
    for (const Side& side : sides_) {
        if (!walls_[side.wall].isKept) continue;
        for (const VertexId v : mesh.faceVertices(side.face)) {
            Mark& mark = marks_[v];
            const RegionId region = mesh.region(side.face.tet());
            mark.region = kept[v.value] == 0 || mark.region == region ? region : kAnyRegion;
            mark.size += static_cast<float>(longestEdge(mesh, side.face));
            mark.wall = side.wall;
            ++kept[v.value];
        }
    }
    const std::vector<std::uint32_t> all = countOwnFacets(kept, surface);
    for (std::uint32_t i = 0; i < mesh.vertexLimit(); ++i) {
        if (kept[i] == 0) continue;
        Mark& mark = marks_[VertexId(i)];
        mark.size /= static_cast<float>(kept[i]);
        if (kept[i] >= all[i]) mark.share = 1.0F;
    }
}

/// The facets around each marked vertex that lie on a face of its wall, seen from the wall's region, or on a rim which
/// is as fine as the wall is thick; facets of a rim that the surface mesh left flat have the wall's own lot.
std::vector<std::uint32_t> ThinWalls::countOwnFacets(const std::vector<std::uint32_t>& kept,
                                                     const SurfaceMesh& surface) const
{
    const Triangulation3d& mesh = t_.mesh();
    std::vector<std::uint32_t> count(mesh.vertexLimit(), 0);
    for (std::uint32_t i = 0; i < mesh.tetLimit(); ++i) {
        const TetId tet(i);
        if (!isMeshed(mesh, tet) || (mesh.flags(tet) & tet_flag::kFaces) == 0) continue;
        for (int f = 0; f < 4; ++f) {
            if (!mesh.isFaceConstrained({tet, f})) continue;
            const BrepFaceId face = faceOf(t_, {tet, f}, surface);
            for (const VertexId v : mesh.faceVertices({tet, f})) {
                if (kept[v.value] == 0 || !isIn(marks_[v], mesh.region(tet))) continue;
                const ThinWall& wall = walls_[marks_[v].wall];
                const bool isOwn = face == wall.face[0] || face == wall.face[1];
                if (isOwn || kThin * longestEdge(mesh, {tet, f}) < wall.thickness * t_.scale)
                    ++count[v.value];
            }
        }
    }
    return count;
}

/// Not behind the wall, in the solid on its other side.
bool ThinWalls::isOnItsSide(TetId tet) const
{
    const RegionId region = t_.mesh().region(tet);
    const auto& vertex = t_.mesh().tet(tet).vertex;
    return std::all_of(vertex.begin(), vertex.end(), [&](VertexId v) {
        return v.value >= marks_.size() || marks_[v].share == 0.0F || isIn(marks_[v], region);
    });
}

bool ThinWalls::maySplit(std::span<const VertexId> corners, double size) const
{
    if (!hasKept_ || 2.0F * shareOf(corners) < static_cast<float>(corners.size())) return true;
    double shares = 0.0;
    double sizes = 0.0;
    for (const VertexId v : corners) {
        const Mark& mark = marks_[v];
        shares += static_cast<double>(mark.share);
        sizes += static_cast<double>(mark.share) * static_cast<double>(mark.size);
    }
    return size * shares > kLeastSize * sizes;
}

const ThinWall* ThinWalls::wallBeside(TetId tet) const
{
    if (!hasKept_) return nullptr;
    const auto& vertex = t_.mesh().tet(tet).vertex;
    const auto most = std::max_element(vertex.begin(), vertex.end(), [&](VertexId a, VertexId b) {
        return shareOf({&a, 1}) < shareOf({&b, 1});
    });
    return shareOf({&*most, 1}) > 0.0F ? &walls_[marks_[*most].wall] : nullptr;
}

void ThinWalls::assign(VertexId v, std::span<const VertexId> neighbours, RegionId region)
{
    if (!hasKept_) return;
    if (marks_.size() <= v.value) marks_.resize(v.value + v.value / 4u + 16u);
    Mark mark;
    double weights = 0.0;
    double shares = 0.0;
    for (const VertexId w : neighbours) {
        if (isGhost(w)) continue;
        const double weight = 1.0 / length(t_.mesh().position(w) - t_.mesh().position(v));
        const Mark& other = marks_[w];
        weights += weight;
        if (other.share == 0.0F || (region != kAnyRegion && !isIn(other, region))) continue;
        shares += weight * static_cast<double>(other.share);
        mark.region = mark.size == 0.0F || mark.region == other.region ? other.region : kAnyRegion;
        mark.size = std::max(mark.size, other.size);
        mark.wall = other.wall;
    }
    if (region != kAnyRegion) mark.region = region;
    if (shares > 0.0) mark.share = static_cast<float>(shares / weights);
    marks_[v] = mark;
}

}  // namespace mesher
