#include "tetrahedralization/facet_recovery.h"

#include "delaunay/hole_refill.h"
#include "predicates/orient3d.h"

#include <algorithm>

namespace mesher {

namespace {

constexpr std::uint32_t kTrialsPerDepth[] = {16, 60, 300, 1000};
/// Tetrahedra that a pair of cavities may grow to.
constexpr std::size_t kMaxCavity = 400;

}  // namespace

Vec3 facetCrossingPoint(const Triangulation3d& mesh, const std::array<VertexId, 3>& facet,
                        const std::array<VertexId, 2>& edge)
{
    const Vec3 corner = mesh.position(facet[0]);
    const Vec3 normal = cross(mesh.position(facet[1]) - corner, mesh.position(facet[2]) - corner);
    const Vec3 from = mesh.position(edge[0]);
    const Vec3 direction = mesh.position(edge[1]) - from;
    return from + clampedShare(dot(normal, corner - from), dot(normal, direction)) * direction;
}

RecoveryStatus FacetRecovery::findObstacle()
{
    const Triangulation3d& mesh = constraints_.mesh();
    if (found_.touching.isValid()) {
        obstacle_ = {{found_.touching, {}, {}}, mesh.position(found_.touching)};
        return RecoveryStatus::VertexInWay;
    }
    for (const auto& edge : found_.edges) {
        if (!constraints_.isConstraint(mesh.findEdge(edge[0], edge[1]), edge[0], edge[1])) continue;
        obstacle_ = {{edge[0], edge[1], {}}, facetCrossingPoint(mesh, facet_, edge)};
        return RecoveryStatus::Intersection;
    }
    return RecoveryStatus::Stuck;
}

bool FacetRecovery::lock()
{
    const TetFace face = constraints_.mesh().findFace(facet_[0], facet_[1], facet_[2]);
    if (!face.isValid()) return false;
    constraints_.lockFacet(face);
    return true;
}

RecoveryStatus FacetRecovery::recover(FacetId facet, int depth, FacetEffort effort)
{
    facet_ = constraints_.cornersOf(facet);
    method_ = FacetMethod::Present;
    addedVertices_ = 0;
    if (lock()) return RecoveryStatus::Recovered;
    crossings_.find(facet_, found_);
    const RecoveryStatus obstacle = findObstacle();
    if (obstacle != RecoveryStatus::Stuck) return obstacle;
    if (removeCrossingEdges(depth) && lock()) {
        method_ = FacetMethod::Flips;
        return RecoveryStatus::Recovered;
    }
    if (!retriangulate(effort)) return RecoveryStatus::Stuck;
    return lock() ? RecoveryStatus::Recovered : RecoveryStatus::Stuck;
}

/// Each removal has to lessen the number of crossing edges, else it is taken back.
bool FacetRecovery::removeCrossingEdges(int depth)
{
    const Triangulation3d& mesh = constraints_.mesh();
    const std::array<Vec3, 3> plane{mesh.position(facet_[0]), mesh.position(facet_[1]),
                                    mesh.position(facet_[2])};
    const TetMeasure measure = [&](const Vec3& p, const Vec3& q, const Vec3& r, const Vec3& s) {
        bool isAbove = false;
        bool isBelow = false;
        for (const Vec3* corner : {&p, &q, &r, &s}) {
            const Sign side = orient3d(plane[0], plane[1], plane[2], *corner);
            isAbove |= side == Sign::Positive;
            isBelow |= side == Sign::Negative;
        }
        return flatness(p, q, r, s) + (isAbove && isBelow ? 0.0 : 2.0);
    };
    bool isImproved = true;
    while (isImproved && !found_.edges.empty()) {
        isImproved = false;
        flips_.allowTrials(kTrialsPerDepth[depth]);
        for (const auto& edge : found_.edges) {
            const std::size_t mark = flips_.mark();
            if (!flips_.removeEdge(edge[0], edge[1], TetId(), depth, measure)) continue;
            crossings_.find(facet_, trial_);
            if (trial_.edges.size() < found_.edges.size()) {
                isImproved = true;
                break;
            }
            flips_.takeBackTo(mark);
        }
        flips_.accept();
        if (isImproved) std::swap(found_, trial_);
    }
    return found_.edges.empty();
}

/// The surface of the tetrahedra that the facet passes through, parted by the facet.
void FacetRecovery::splitShells()
{
    const Triangulation3d& mesh = constraints_.mesh();
    tets_ = found_.tets;
    for (Side& side : sides_) {
        side.shell.clear();
        side.insideVertices.clear();
        side.isStar = false;
    }
    innerFacets_.clear();
    std::vector<VertexId> vertices;
    for (const TetId tet : tets_) {
        for (int face = 0; face < 4; ++face) {
            const TetFace outer = mesh.neighbour(tet, face);
            const auto corner = mesh.faceVertices({tet, face});
            if (std::find(tets_.begin(), tets_.end(), outer.tet()) != tets_.end()) {
                if (mesh.isFaceConstrained(outer) && tet < outer.tet()) innerFacets_.push_back(corner);
                continue;
            }
            Sign at = Sign::Zero;
            for (unsigned k = 0; k < 3 && at == Sign::Zero; ++k) {
                const bool isCorner = std::find(facet_.begin(), facet_.end(), corner[k]) != facet_.end();
                if (!isCorner) at = crossings_.sideOf(corner[k]);
            }
            sides_[at == Sign::Positive ? 1 : 0].shell.add({corner, outer});
        }
        for (const VertexId v : mesh.tet(tet).vertex) {
            if (std::find(vertices.begin(), vertices.end(), v) == vertices.end()) vertices.push_back(v);
        }
    }
    const auto isOn = [](const Side& side, VertexId v) {
        return std::any_of(side.shell.faces().begin(), side.shell.faces().end(), [&](const auto& face) {
            return std::find(face.first.begin(), face.first.end(), v) != face.first.end();
        });
    };
    for (const VertexId v : vertices) {
        const bool isCorner = std::find(facet_.begin(), facet_.end(), v) != facet_.end();
        if (isCorner || isOn(sides_[0], v) || isOn(sides_[1], v)) continue;
        sides_[crossings_.sideOf(v) == Sign::Positive ? 1 : 0].insideVertices.push_back(v);
    }
    sides_[0].shell.add({{facet_[0], facet_[2], facet_[1]}, TetFace()});
    sides_[1].shell.add({facet_, TetFace()});
}

/// Adds the tetrahedra behind the faces of the side's shell that are not Delaunay; false if one must not be added.
bool FacetRecovery::enlarge(Side& side, const Side& other)
{
    const Triangulation3d& mesh = constraints_.mesh();
    for (const CavityShell::Corners& key : std::vector<CavityShell::Corners>(cavities_.missing())) {
        const auto found = side.shell.faces().find(key);
        if (found == side.shell.faces().end()) continue;
        const TetFace outer = found->second.outer;
        if (!outer.isValid() || mesh.isFaceConstrained(outer) || mesh.isGhostTet(outer.tet())) return false;
        if (tets_.size() >= kMaxCavity) return false;
        if (std::find(tets_.begin(), tets_.end(), outer.tet()) != tets_.end()) return false;
        tets_.push_back(outer.tet());
        side.shell.remove(key);
        const VertexId apex = mesh.vertex(outer.tet(), outer.face());
        const auto hasApex = [&](const auto& face) {
            return std::find(face.first.begin(), face.first.end(), apex) != face.first.end();
        };
        const bool isFacetCorner = std::find(facet_.begin(), facet_.end(), apex) != facet_.end();
        if (!isFacetCorner && std::any_of(other.shell.faces().begin(), other.shell.faces().end(), hasApex)) {
            return false;
        }
        std::erase(side.insideVertices, apex);
        for (int face = 0; face < 4; ++face) {
            if (face == outer.face()) continue;
            const TetFace inner(outer.tet(), face);
            auto corner = mesh.faceVertices(inner);
            std::array<VertexId, 3> sortedCorner = corner;
            std::sort(sortedCorner.begin(), sortedCorner.end());
            if (other.shell.faces().contains(sortedCorner)) return false;
            if (mesh.isFaceConstrained(inner) && side.shell.faces().contains(sortedCorner)) return false;
            if (!side.shell.add({corner, mesh.neighbour(inner)})) return false;
        }
        const auto isOnShell = [&](VertexId v) {
            return std::any_of(side.shell.faces().begin(), side.shell.faces().end(), [&](const auto& face) {
                return std::find(face.first.begin(), face.first.end(), v) != face.first.end();
            });
        };
        for (const VertexId v : mesh.tet(outer.tet()).vertex) {
            const bool isKnown = std::find(side.insideVertices.begin(), side.insideVertices.end(), v) !=
                                 side.insideVertices.end();
            if (!isKnown && !isOnShell(v)) side.insideVertices.push_back(v);
        }
    }
    return true;
}

bool FacetRecovery::fill(Side& side, bool& mayGrow)
{
    side.filling.clear();
    if (cavities_.fillDelaunay(side.shell, side.insideVertices, side.filling)) return true;
    const Side& other = &side == &sides_[0] ? sides_[1] : sides_[0];
    mayGrow = mayGrow && !cavities_.missing().empty() && enlarge(side, other);
    return false;
}

/// A constraint within the tetrahedra that go must be there in those that come.
bool FacetRecovery::keepsConstraints() const
{
    const Triangulation3d& mesh = std::as_const(constraints_).mesh();
    std::vector<TetCorners> after = sides_[0].filling;
    after.insert(after.end(), sides_[1].filling.begin(), sides_[1].filling.end());
    if (!keepsConstrainedEdges(mesh, tets_, after)) return false;
    return std::all_of(innerFacets_.begin(), innerFacets_.end(), [&](const CavityShell::Corners& corner) {
        return std::any_of(after.begin(), after.end(), [&](const TetCorners& tet) {
            return std::all_of(corner.begin(), corner.end(),
                               [&](VertexId v) { return std::find(tet.begin(), tet.end(), v) != tet.end(); });
        });
    });
}

/// The star of a point that sees the whole shell. The vertex is made on commit: till then it has the ghost's id.
bool FacetRecovery::fillStar(Side& side)
{
    side.filling.clear();
    if (!side.insideVertices.empty() || !cavities_.findKernelPoint(side.shell, side.starPoint)) return false;
    side.isStar = true;
    for (const auto& [key, face] : side.shell.faces()) {
        side.filling.push_back({face.corner[0], face.corner[1], face.corner[2], kGhostVertex});
    }
    return true;
}

bool FacetRecovery::retriangulate(FacetEffort effort)
{
    splitShells();
    bool mayGrow = true;
    bool isFilled = false;
    while (mayGrow && !isFilled) {
        const bool isBelowFilled = fill(sides_[0], mayGrow);
        const bool isAboveFilled = mayGrow && fill(sides_[1], mayGrow);
        isFilled = isBelowFilled && isAboveFilled;
    }
    method_ = FacetMethod::Cavity;
    if (!isFilled || !keepsConstraints()) {
        if (effort != FacetEffort::Star) return false;
        splitShells();
        method_ = FacetMethod::Star;
        for (Side& side : sides_) {
            side.filling.clear();
            if (cavities_.fillDelaunay(side.shell, side.insideVertices, side.filling)) continue;
            if (!fillStar(side)) return false;
        }
        if (!keepsConstraints()) return false;
    }
    commit();
    return true;
}

void FacetRecovery::commit()
{
    std::vector<TetCorners> after;
    Triangulation3d& mesh = constraints_.mesh();
    for (Side& side : sides_) {
        VertexId centre;
        if (side.isStar) {
            constraints_.tets().delaunay->expectPointsIn({side.starPoint, side.starPoint});
            centre = mesh.addVertex(side.starPoint);
            constraints_.tets().nodeOf.resize(mesh.vertexLimit());
            ++addedVertices_;
        }
        for (TetCorners corners : side.filling) {
            if (side.isStar) corners[3] = centre;
            after.push_back(corners);
        }
    }
    innerFacets_.push_back(facet_);
    replacement_.replace(tets_, after, innerFacets_);
}

}  // namespace mesher
