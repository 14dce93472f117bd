#include "surface_sampling/wall_rims.h"

#include "surface_sampling/facet_measures.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace mesher {
namespace {

/// Tetrahedra for a piece of an edge as long as the rim is wide: in a plate, and between a block and a layer on it.
constexpr double kTetsPerFreeEdge = 16.0;
constexpr double kTetsPerBlockEdge = 100.0;
/// Cosines between normals: of faces that look at each other, and of faces that meet about at right angles.
constexpr double kOpposite = -0.7;
constexpr double kUpright = 0.7;
/// Share of a face that has to be rim.
constexpr double kNearlyAll = 0.8;
/// A face so many times as wide as the rim grades the rim's facets up.
constexpr double kWide = 4.0;

/// The faces beside each segment, with their normals there.
struct Beside
{
    BrepFaceId face;
    Vec3 normal;
};

class RimSearch
{
public:
    RimSearch(const SampledFaces& faces, const RegionSides& sides)
        : faces_(faces), sides_(sides), beside_(faces.chains().segments().size()), width_(sides.size(), 0.0)
    {
        forEachFace([&](BrepFaceId f, const FaceMesh& mesh) { measure(f, mesh); });
    }

    std::vector<WallRim> run(double maxTets)
    {
        std::vector<WallRim> rims = joined(rimFaces());
        std::stable_sort(rims.begin(), rims.end(),
                         [](const WallRim& a, const WallRim& b) { return a.tets < b.tets; });
        double spent = 0.0;
        std::erase_if(rims, [&](const WallRim& rim) { return (spent += rim.tets) <= maxTets; });
        return rims;
    }

private:
    template <class Visit>
    void forEachFace(Visit visit) const
    {
        for (std::uint32_t f = 0; f < sides_.size(); ++f) {
            if (const SampledFace* face = faces_.face(BrepFaceId(f))) visit(BrepFaceId(f), face->mesh);
        }
    }

    template <class Visit>
    static void forEachTriangle(const FaceMesh& mesh, Visit visit)
    {
        for (std::uint32_t i = 0; i < mesh.triangleSlots(); ++i) {
            if (mesh.triangle(TriangleId(i)).isAlive) visit(TriangleId(i));
        }
    }

    static double lengthOf(const FaceMesh& mesh, EdgeLink side)
    {
        return length(mesh.position(mesh.to(side)) - mesh.position(mesh.from(side)));
    }

    static Vec3 doubleArea(const FaceMesh& mesh, TriangleId t)
    {
        const auto& v = mesh.triangle(t).v;
        return cross(mesh.position(v[1]) - mesh.position(v[0]), mesh.position(v[2]) - mesh.position(v[0]));
    }

    static Vec3 normalAt(const FaceMesh& mesh, TriangleId t, VertexId v)
    {
        const Vec3& exact = mesh.vertex(v).normal;
        if (exact != Vec3{}) return exact;
        const Vec3 normal = doubleArea(mesh, t);
        const double size = length(normal);
        return size > 0.0 ? (1.0 / size) * normal : Vec3{};
    }

    void measure(BrepFaceId f, const FaceMesh& mesh)
    {
        double area = 0.0;
        double perimeter = 0.0;
        forEachTriangle(mesh, [&](TriangleId t) {
            area += 0.5 * length(doubleArea(mesh, t));
            for (unsigned k = 0; k < 3; ++k) {
                const EdgeLink side(t, k);
                const SegmentId segment = mesh.segment(side);
                if (!segment.isValid()) continue;
                perimeter += lengthOf(mesh, side);
                beside_[segment].push_back({f, normalAt(mesh, t, mesh.from(side))});
            }
        });
        width_[f.value] = perimeter > 0.0 ? 2.0 * area / perimeter : 0.0;
    }

    /// Normals, into the region, of the faces that stand upright beside a segment of the face.
    void collectUpright(BrepFaceId f, const Vec3& normal, SegmentId segment, RegionId region,
                        std::vector<Vec3>& found) const
    {
        for (const Beside& other : beside_[segment]) {
            const auto& sides = sides_[other.face];
            if (other.face == f || (sides[0] != region && sides[1] != region)) continue;
            if (std::abs(dot(other.normal, normal)) > kUpright) continue;
            found.push_back(sides[0] == region ? other.normal : -1.0 * other.normal);
        }
    }

    /// Whether the facet joins two faces that look at each other across the region.
    [[nodiscard]] bool joinsSides(BrepFaceId f, const FaceMesh& mesh, TriangleId t, RegionId region) const
    {
        std::vector<Vec3> here, there;
        for (unsigned k = 0; k < 3; ++k) {
            const EdgeLink side(t, k);
            if (!mesh.segment(side).isValid()) continue;
            here.clear();
            there.clear();
            const VertexId apex = mesh.apex(side);
            collectUpright(f, normalAt(mesh, t, mesh.from(side)), mesh.segment(side), region, here);
            mesh.forEachTriangleAround(apex, [&](EdgeLink opposite) {
                for (unsigned i = 1; i < 3; ++i) {
                    const EdgeLink next(opposite.triangle(), (opposite.edge() + i) % 3);
                    if (mesh.segment(next).isValid())
                        collectUpright(f, normalAt(mesh, t, apex), mesh.segment(next), region, there);
                }
            });
            for (const Vec3& a : here) {
                for (const Vec3& b : there) {
                    if (dot(a, b) < kOpposite) return true;
                }
            }
        }
        return false;
    }

    [[nodiscard]] bool isRim(BrepFaceId f, const FaceMesh& mesh) const
    {
        for (const RegionId region : sides_[f]) {
            if (region.value == 0) continue;
            double area = 0.0;
            double rim = 0.0;
            forEachTriangle(mesh, [&](TriangleId t) {
                const double own = length(doubleArea(mesh, t));
                area += own;
                if (isFlatFacet(mesh, t) && joinsSides(f, mesh, t, region)) rim += own;
            });
            if (rim >= kNearlyAll * area && area > 0.0) return true;
        }
        return false;
    }

    [[nodiscard]] double tetsBeside(BrepFaceId f, const FaceMesh& mesh) const
    {
        double tets = 0.0;
        const double width = width_[f.value];
        forEachTriangle(mesh, [&](TriangleId t) {
            for (unsigned k = 0; k < 3; ++k) {
                const SegmentId segment = mesh.segment(EdgeLink(t, k));
                if (!segment.isValid()) continue;
                double each = 0.0;
                for (const Beside& other : beside_[segment]) {
                    if (other.face == f || width_[other.face.value] <= kWide * width) continue;
                    const auto& sides = sides_[other.face];
                    const bool isBlock = sides[0].value != 0 && sides[1].value != 0;
                    each = std::max(each, isBlock ? kTetsPerBlockEdge : kTetsPerFreeEdge);
                }
                tets += each * lengthOf(mesh, EdgeLink(t, k)) / width;
            }
        });
        return tets;
    }

    [[nodiscard]] std::vector<BrepFaceId> rimFaces() const
    {
        std::vector<BrepFaceId> rims;
        forEachFace([&](BrepFaceId f, const FaceMesh& mesh) {
            if (isRim(f, mesh)) rims.push_back(f);
        });
        return rims;
    }

    /// Faces that share edges are one rim: a plate with good and with flat sides would be neither good nor cheap.
    [[nodiscard]] std::vector<WallRim> joined(const std::vector<BrepFaceId>& rimFaces) const
    {
        std::vector<std::uint32_t> root(sides_.size());
        std::iota(root.begin(), root.end(), 0u);
        const auto find = [&](std::uint32_t f) {
            while (root[f] != f) f = root[f];
            return f;
        };
        const auto isRimFace = [&](BrepFaceId f) {
            return std::binary_search(rimFaces.begin(), rimFaces.end(), f);
        };
        for (std::uint32_t e = 0; e < faces_.model().edges.size(); ++e) {
            BrepFaceId first;
            for (const BrepFaceId f : faces_.facesOf(BrepEdgeId(e))) {
                if (!isRimFace(f)) continue;
                if (first.isValid())
                    root[std::max(find(f.value), find(first.value))] =
                        std::min(find(f.value), find(first.value));
                first = f;
            }
        }
        std::vector<WallRim> rims;
        std::vector<std::size_t> rimOf(sides_.size(), sides_.size());
        for (const BrepFaceId f : rimFaces) {
            std::size_t& at = rimOf[find(f.value)];
            if (at == sides_.size()) {
                at = rims.size();
                rims.push_back({{}, width_[f.value], 0.0});
            }
            rims[at].faces.push_back(f);
            rims[at].width = std::min(rims[at].width, width_[f.value]);
            rims[at].tets += tetsBeside(f, faces_.face(f)->mesh);
        }
        return rims;
    }

    const SampledFaces& faces_;
    const RegionSides& sides_;
    IdVector<SegmentId, std::vector<Beside>> beside_;
    std::vector<double> width_;
};

}  // namespace

std::vector<WallRim> findFlatRims(const SampledFaces& faces, const RegionSides& sides, double maxTets)
{
    return RimSearch(faces, sides).run(maxTets);
}

}  // namespace mesher
