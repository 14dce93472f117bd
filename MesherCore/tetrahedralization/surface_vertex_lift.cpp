#include "tetrahedralization/surface_vertex_lift.h"

#include "delaunay/hole_refill.h"
#include "predicates/orient3d.h"

#include <algorithm>
#include <cmath>

namespace mesher {

namespace {

constexpr int kNoSector = -1;
/// Halvings of the distance from the surface at which a point may see all of its sector.
constexpr int kMostHalvings = 60;
/// Tetrahedra that the sectors at a vertex may take in.
constexpr std::size_t kMostTakenIn = 100;
/// How much nearer than a face that it blocks another may be.
constexpr double kAboutAsNear = 4.0;

bool contains(const std::array<VertexId, 3>& face, VertexId vertex)
{
    return std::find(face.begin(), face.end(), vertex) != face.end();
}

}  // namespace

int SurfaceVertexLift::sectorAt(TetId tet) const
{
    const auto place = std::lower_bound(star_.begin(), star_.end(), tet);
    return sectorOf_[static_cast<std::size_t>(place - star_.begin())];
}

void SurfaceVertexLift::spreadSector(std::size_t first, int sector)
{
    const Triangulation3d& mesh = std::as_const(constraints_).mesh();
    sectorOf_[first] = sector;
    queue_.assign(1, star_[first]);
    for (std::size_t next = 0; next < queue_.size(); ++next) {
        const TetId tet = queue_[next];
        const int own = mesh.slotOf(tet, vertex_);
        for (int face = 0; face < 4; ++face) {
            if (face == own || mesh.isFaceConstrained({tet, face})) continue;
            const TetId other = mesh.neighbour(tet, face).tet();
            const auto place = std::lower_bound(star_.begin(), star_.end(), other) - star_.begin();
            if (sectorOf_[static_cast<std::size_t>(place)] != kNoSector) continue;
            sectorOf_[static_cast<std::size_t>(place)] = sector;
            queue_.push_back(other);
        }
    }
}

bool SurfaceVertexLift::partStar(const TemporarySplits::Made& made)
{
    const Triangulation3d& mesh = std::as_const(constraints_).mesh();
    vertex_ = constraints_.tets().vertexOf[made.result.node];
    mesh.collectStar(vertex_, star_);
    std::sort(star_.begin(), star_.end());
    sectorOf_.assign(star_.size(), kNoSector);
    int count = 0;
    for (std::size_t i = 0; i < star_.size(); ++i) {
        if (mesh.isGhostTet(star_[i])) return false;
        if (sectorOf_[i] == kNoSector) spreadSector(i, count++);
    }
    sectors_.assign(static_cast<std::size_t>(count), Sector());
    for (std::size_t i = 0; i < star_.size(); ++i) {
        const int own = mesh.slotOf(star_[i], vertex_);
        CavityShell& shell = sectors_[static_cast<std::size_t>(sectorOf_[i])].shell;
        if (!shell.add({mesh.faceVertices({star_[i], own}), mesh.neighbour(star_[i], own)})) return false;
    }
    return true;
}

/// Puts the whole facet onto the shells of the sectors on both sides of one of its parts.
bool SurfaceVertexLift::addFacet(const std::array<VertexId, 3>& facet, const std::array<VertexId, 3>& part)
{
    const Triangulation3d& mesh = std::as_const(constraints_).mesh();
    const TetFace face = mesh.findFace(part[0], part[1], part[2]);
    if (!face.isValid() || !mesh.isFaceConstrained(face)) return false;
    const Vec3& a = mesh.position(facet[0]);
    const Vec3 normal = cross(mesh.position(facet[1]) - a, mesh.position(facet[2]) - a);
    // One sector all around an edge where but one facet ends: no point sees both sides of that.
    if (sectorAt(face.tet()) == sectorAt(mesh.neighbour(face).tet())) return false;
    for (const TetFace side : {face, mesh.neighbour(face)}) {
        Sector& sector = sectors_[static_cast<std::size_t>(sectorAt(side.tet()))];
        const auto corner = mesh.faceVertices(side);
        // Facet and part turn in the same sense about their common plane.
        const std::size_t first =
            static_cast<std::size_t>(std::find(corner.begin(), corner.end(), part[0]) - corner.begin());
        const bool isInFront = corner[(first + 1) % 3] == part[1];
        const std::array<VertexId, 3> turned =
            isInFront ? facet : std::array<VertexId, 3>{facet[0], facet[2], facet[1]};
        if (!sector.shell.add({turned, TetFace()})) return false;
        sector.inwards = sector.inwards + ((isInFront ? 1.0 : -1.0) / length(normal)) * normal;
    }
    return true;
}

bool SurfaceVertexLift::addFacets(const TemporarySplits::Made& made)
{
    const std::size_t partsEach =
        made.split.added.size() / std::max<std::size_t>(1, made.split.removed.size());
    for (std::size_t i = 0; i < made.split.removed.size(); ++i) {
        const auto part = constraints_.cornersOf(made.result.added[i * partsEach]);
        if (!addFacet(constraints_.cornersOf(made.split.removed[i]), part)) return false;
    }
    return !made.split.removed.empty();
}

bool SurfaceVertexLift::seesAll(const Sector& sector, const Vec3& point) const
{
    const Triangulation3d& mesh = std::as_const(constraints_).mesh();
    return std::all_of(sector.shell.faces().begin(), sector.shell.faces().end(), [&](const auto& face) {
        const auto& v = face.second.corner;
        return orient3d(mesh.position(v[0]), mesh.position(v[1]), mesh.position(v[2]), point) ==
               Sign::Positive;
    });
}

bool SurfaceVertexLift::fillFromCorner(Sector& sector) const
{
    const Triangulation3d& mesh = std::as_const(constraints_).mesh();
    std::vector<VertexId> corners;
    for (const auto& [key, face] : sector.shell.faces())
        corners.insert(corners.end(), key.begin(), key.end());
    std::sort(corners.begin(), corners.end());
    corners.erase(std::unique(corners.begin(), corners.end()), corners.end());
    for (const VertexId from : corners) {
        sector.filling.clear();
        const bool isSeen =
            std::all_of(sector.shell.faces().begin(), sector.shell.faces().end(), [&](const auto& face) {
                const auto& v = face.second.corner;
                if (contains(v, from)) return true;
                sector.filling.push_back({v[0], v[1], v[2], from});
                return orient3d(mesh.position(v[0]), mesh.position(v[1]), mesh.position(v[2]),
                                mesh.position(from)) == Sign::Positive;
            });
        if (isSeen) return true;
    }
    return false;
}

/// The best one of an ascent, else one near the vertex's place; of those the second largest distance that will do.
bool SurfaceVertexLift::findStarPoint(Sector& sector) const
{
    if (cavities_.findKernelPoint(sector.shell, sector.starPoint)) return true;
    const Triangulation3d& mesh = std::as_const(constraints_).mesh();
    Box3 box;
    for (const auto& [key, face] : sector.shell.faces()) {
        for (const VertexId v : key) box.include(mesh.position(v));
    }
    const Vec3 deepest = sector.starPoint;
    const double reach = length(sector.inwards);
    if (!(reach > 0.0)) return false;
    const Vec3 step = (length(box.extent()) / reach) * sector.inwards;
    double share = 0.5;
    for (int i = 0; i < kMostHalvings; ++i, share *= 0.5) {
        sector.starPoint = mesh.position(vertex_) + share * step;
        if (!seesAll(sector, sector.starPoint)) continue;
        const Vec3 nearer = mesh.position(vertex_) + 0.5 * share * step;
        if (seesAll(sector, nearer)) sector.starPoint = nearer;
        return true;
    }
    sector.starPoint = deepest;
    return false;
}

bool SurfaceVertexLift::fillAsItIs(Sector& sector)
{
    sector.filling.clear();
    // Nothing is left of a single tetrahedron whose face behind the vertex is the facet itself.
    if (sector.shell.faces().empty()) return true;
    if (cavities_.fillDelaunay(sector.shell, sector.insideVertices, sector.filling)) return true;
    if (!sector.insideVertices.empty()) return false;
    if (fillFromCorner(sector)) return true;
    sector.filling.clear();
    if (!findStarPoint(sector)) return false;
    sector.isStar = true;
    for (const auto& [key, face] : sector.shell.faces()) {
        sector.filling.push_back({face.corner[0], face.corner[1], face.corner[2], kGhostVertex});
    }
    return true;
}

bool SurfaceVertexLift::fill(Sector& sector)
{
    while (!fillAsItIs(sector)) {
        if (tets_.size() > star_.size() + kMostTakenIn || !enlarge(sector)) return false;
    }
    return true;
}

/// The faces of a sector in whose way a star is: those that its point does not see, and those that keep it from seeing these,
/// which are about as near. The facets themselves, which have nothing behind, cannot give way.
void SurfaceVertexLift::listBlocking(const Sector& sector)
{
    const Triangulation3d& mesh = std::as_const(constraints_).mesh();
    blocking_.clear();
    std::vector<std::pair<double, TetFace>> distances;
    double hidden = 0.0;
    for (const auto& [key, face] : sector.shell.faces()) {
        const Vec3& a = mesh.position(face.corner[0]);
        const Vec3& b = mesh.position(face.corner[1]);
        const Vec3& c = mesh.position(face.corner[2]);
        const Vec3 normal = cross(b - a, c - a);
        const double distance = dot(normal, sector.starPoint - a) / length(normal);
        const bool isSeen = orient3d(a, b, c, sector.starPoint) == Sign::Positive;
        if (!isSeen) hidden = std::max(hidden, std::abs(distance));
        distances.emplace_back(isSeen ? distance : 0.0, face.outer);
    }
    for (const auto& [distance, outer] : distances) {
        if (distance <= kAboutAsNear * hidden && outer.isValid()) blocking_.push_back(outer);
    }
}

/// Takes in what is behind the faces that block a star, or that are not Delaunay if a star cannot do; false if nothing can be
/// taken in.
bool SurfaceVertexLift::enlarge(Sector& sector)
{
    const Triangulation3d& mesh = std::as_const(constraints_).mesh();
    if (sector.insideVertices.empty()) {
        listBlocking(sector);
    } else {
        blocking_.clear();
        for (const CavityShell::Corners& key : cavities_.missing())
            blocking_.push_back(sector.shell.faces().at(key).outer);
    }
    bool isChanged = false;
    for (const TetFace outer : blocking_) {
        if (!outer.isValid() || mesh.isFaceConstrained(outer)) continue;
        // Another of them may have brought it.
        if (std::find(tets_.begin(), tets_.end(), outer.tet()) != tets_.end()) continue;
        if (mesh.isGhostTet(outer.tet()) || !takeIn(sector, outer)) return false;
        isChanged = true;
    }
    return isChanged;
}

bool SurfaceVertexLift::takeIn(Sector& sector, TetFace outer)
{
    const Triangulation3d& mesh = std::as_const(constraints_).mesh();
    tets_.push_back(outer.tet());
    for (int face = 0; face < 4; ++face) {
        const TetFace inner(outer.tet(), face);
        const TetFace behind = mesh.neighbour(inner);
        const bool isWithin = std::find(tets_.begin(), tets_.end(), behind.tet()) != tets_.end();
        if (isWithin && mesh.isFaceConstrained(inner)) return false;
        if (!sector.shell.add({mesh.faceVertices(inner), behind})) return false;
    }
    const auto isOnShell = [&](VertexId v) {
        return std::any_of(sector.shell.faces().begin(), sector.shell.faces().end(),
                           [&](const auto& face) { return contains(face.first, v); });
    };
    std::erase_if(sector.insideVertices, isOnShell);
    for (const VertexId v : mesh.tet(outer.tet()).vertex) {
        const bool isKnown = std::find(sector.insideVertices.begin(), sector.insideVertices.end(), v) !=
                             sector.insideVertices.end();
        if (!isKnown && !isOnShell(v)) sector.insideVertices.push_back(v);
    }
    return true;
}

bool SurfaceVertexLift::lift(const TemporarySplits::Made& made)
{
    addedVertices_ = 0;
    if (!partStar(made) || !addFacets(made)) return false;
    tets_ = star_;
    if (!std::all_of(sectors_.begin(), sectors_.end(), [&](Sector& sector) { return fill(sector); }))
        return false;
    std::vector<TetCorners> after;
    for (const Sector& sector : sectors_)
        after.insert(after.end(), sector.filling.begin(), sector.filling.end());
    // Constrained edges may have come to lie inside of sectors that were enlarged.
    if (!keepsConstrainedEdges(std::as_const(constraints_).mesh(), std::span(tets_).subspan(star_.size()),
                               after))
        return false;
    commit(made);
    return true;
}

std::vector<VertexId> SurfaceVertexLift::freeNeighbours() const
{
    const Triangulation3d& mesh = std::as_const(constraints_).mesh();
    std::vector<VertexId> free;
    for (const TetId tet : star_) {
        for (const VertexId v : mesh.tet(tet).vertex) {
            if (!isGhost(v) && !constraints_.nodeAt(v).isValid()) free.push_back(v);
        }
    }
    std::sort(free.begin(), free.end());
    free.erase(std::unique(free.begin(), free.end()), free.end());
    return free;
}

void SurfaceVertexLift::commit(const TemporarySplits::Made& made)
{
    ConstrainedTetrahedralization& tets = constraints_.tets();
    Triangulation3d& mesh = tets.mesh();
    std::vector<TetCorners> after;
    for (const Sector& sector : sectors_) {
        VertexId centre;
        if (sector.isStar) {
            tets.delaunay->expectPointsIn({sector.starPoint, sector.starPoint});
            centre = mesh.addVertex(sector.starPoint);
            ++addedVertices_;
        }
        for (TetCorners corners : sector.filling) {
            if (sector.isStar) corners[3] = centre;
            after.push_back(corners);
        }
    }
    tets.nodeOf.resize(std::max<std::size_t>(tets.nodeOf.size(), mesh.vertexLimit()));
    std::vector<TetId> behind;
    for (const TetId tet : star_) behind.push_back(mesh.neighbour(tet, mesh.slotOf(tet, vertex_)).tet());
    std::erase_if(behind,
                  [&](TetId tet) { return std::find(tets_.begin(), tets_.end(), tet) != tets_.end(); });
    replacement_.replace(tets_, after);
    mesh.removeVertex(vertex_);
    for (const TetId tet : behind) {
        for (const VertexId v : mesh.tet(tet).vertex) {
            if (!isGhost(v)) mesh.setIncidentTet(v, tet);
        }
    }
    for (const FacetId facet : made.split.removed) {
        const auto corner = constraints_.cornersOf(facet);
        constraints_.lockFacet(mesh.findFace(corner[0], corner[1], corner[2]));
    }
}

}  // namespace mesher
