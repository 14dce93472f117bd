#include "surface_sampling/wall_rims.h"

#include "delaunay/triangulation3d.h"
#include "surface_sampling/sampled_faces.h"

#include <algorithm>
#include <utility>

namespace mesher {
namespace {

/// Cosine between the inward normals of faces that look at each other.
constexpr double kOpposite = -0.7;

Vec3 normalAt(const FaceMesh& mesh, TriangleId t, VertexId v)
{
    const Vec3& exact = mesh.vertex(v).normal;
    if (exact != Vec3{}) return exact;
    const auto& corner = mesh.triangle(t).v;
    const Vec3 normal = cross(mesh.position(corner[1]) - mesh.position(corner[0]),
                              mesh.position(corner[2]) - mesh.position(corner[0]));
    const double size = length(normal);
    return size > 0.0 ? (1.0 / size) * normal : Vec3{};
}

}  // namespace

WallRims::WallRims(const SampledFaces& faces, RegionSides sides)
    : sides_(std::move(sides)), beside_(faces.model().edges.size())
{
    for (std::uint32_t f = 0; f < sides_.size(); ++f) collect(faces, BrepFaceId(f));
}

void WallRims::collect(const SampledFaces& faces, BrepFaceId f)
{
    const SampledFace* face = faces.face(f);
    if (face == nullptr) return;
    const FaceMesh& mesh = face->mesh;
    for (std::uint32_t i = 0; i < mesh.triangleSlots(); ++i) {
        if (!mesh.triangle(TriangleId(i)).isAlive) continue;
        for (unsigned k = 0; k < 3; ++k) {
            const EdgeLink side(TriangleId(i), k);
            if (!mesh.segment(side).isValid()) continue;
            std::vector<Beside>& beside = beside_[faces.chains().segments()[mesh.segment(side)].edge];
            if (beside.empty() || beside.back().face != f) beside.push_back({f, {}});
            std::vector<Vec3>& normals = beside.back().normals;
            const Vec3 normal = normalAt(mesh, side.triangle(), mesh.from(side));
            if (normals.empty() || normals.back() != normal) normals.push_back(normal);
        }
    }
}

bool WallRims::doFaceEachOther(const Beside& first, const Beside& second, RegionId region) const
{
    const double sign = (sides_[first.face][0] == region) == (sides_[second.face][0] == region) ? 1.0 : -1.0;
    return std::any_of(first.normals.begin(), first.normals.end(), [&](const Vec3& a) {
        return std::any_of(second.normals.begin(), second.normals.end(),
                           [&](const Vec3& b) { return sign * dot(a, b) < kOpposite; });
    });
}

/// Among those, or all that there may be; until the visitor returns true.
template <class Visit>
void WallRims::forEachWall(BrepFaceId face, BrepEdgeId a, BrepEdgeId b, const std::vector<WallSides>* among,
                           Visit visit) const
{
    for (const RegionId region : sides_[face]) {
        if (region.value == 0) continue;
        const auto isOfWall = [&](const Beside& beside) {
            const auto& sides = sides_[beside.face];
            return beside.face != face && (sides[0] == region || sides[1] == region);
        };
        for (const Beside& first : beside_[a]) {
            for (const Beside& second : beside_[b]) {
                if (!isOfWall(first) || !isOfWall(second)) continue;
                const WallSides wall = WallSides::of(first.face, second.face, region);
                const bool isOne = among != nullptr ? std::binary_search(among->begin(), among->end(), wall)
                                                    : doFaceEachOther(first, second, region);
                if (isOne && visit(wall)) return;
            }
        }
    }
}

bool WallRims::isBetween(BrepFaceId face, BrepEdgeId a, BrepEdgeId b) const
{
    bool isAny = false;
    forEachWall(face, a, b, isDecided_ ? &kept_ : nullptr, [&](const WallSides&) { return isAny = true; });
    return isAny;
}

bool WallRims::isStrip(BrepFaceId face, BrepEdgeId a, BrepEdgeId b) const
{
    if (isDecided_ && !std::binary_search(strips_.begin(), strips_.end(), face)) return false;
    bool isGoodRim = false;
    forEachWall(face, a, b, &good_, [&](const WallSides&) { return isGoodRim = true; });
    return !isGoodRim && !isEndOfGap(face, a, b);
}

bool WallRims::isEndOfGap(BrepFaceId face, BrepEdgeId a, BrepEdgeId b) const
{
    const auto isOutside = [&](BrepFaceId f) {
        return sides_[f][0] == kExteriorRegion || sides_[f][1] == kExteriorRegion;
    };
    if (!isOutside(face)) return false;
    for (const Beside& first : beside_[a]) {
        for (const Beside& second : beside_[b]) {
            if (first.face == face || second.face == face) continue;
            if (isOutside(first.face) && isOutside(second.face) &&
                doFaceEachOther(first, second, kExteriorRegion))
                return true;
        }
    }
    return false;
}

std::vector<WallSides> WallRims::wallsBetween(BrepFaceId face, BrepEdgeId a, BrepEdgeId b) const
{
    std::vector<WallSides> walls;
    forEachWall(face, a, b, isDecided_ ? &kept_ : nullptr, [&](const WallSides& wall) {
        walls.push_back(wall);
        return false;
    });
    return walls;
}

void WallRims::keep(std::vector<WallSides> walls, std::vector<WallSides> goodWalls,
                    std::vector<BrepFaceId> strips)
{
    kept_ = std::move(walls);
    good_ = std::move(goodWalls);
    strips_ = std::move(strips);
    isDecided_ = true;
}

}  // namespace mesher
