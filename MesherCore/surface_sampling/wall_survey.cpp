#include "surface_sampling/wall_survey.h"

#include "surface_sampling/facet_measures.h"
#include "surface_sampling/wall_thickness.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <utility>

namespace mesher {
namespace {

constexpr std::uint32_t kFacetsPerAsk = 64;
/// Thickness over the longest edge of a facet, below which a wall is thin there: above, it takes few more to make it good.
constexpr double kThin = 0.25;
/// Good tetrahedra per area of both sides over the squared thickness, as measured on hollowed boxes.
constexpr double kTetsPerSide = 2.0;
/// The same for a piece of a rim's edge that is as long as the rim is wide.
constexpr double kTetsPerRimEdge = 16.0;
/// Area of an equilateral triangle over its squared edge.
constexpr double kEquilateral = 0.433;
/// Of the way from a facet's centroid to its corners, where it is measured.
constexpr double kTowardsCorners = 0.75;
/// Least over largest thickness behind a facet, above which it counts as even.
constexpr double kEven = 0.7;
/// Pieces each way that a facet is looked at in, where it is larger than wanted.
constexpr int kMostPieces = 8;

using Corners = std::array<Vec3, 3>;

Vec3 centroidOf(const Corners& c) { return (1.0 / 3.0) * (c[0] + c[1] + c[2]); }

double longestOf(const Corners& c) { return std::sqrt(FacetShape::of(c[0], c[1], c[2]).longestSquared()); }

double areaOf(const Corners& c) { return 0.5 * length(cross(c[1] - c[0], c[2] - c[0])); }

/// In so many pieces each way.
template <class Visit>
void forEachPiece(const Corners& whole, int n, Visit visit)
{
    const auto at = [&](int i, int k) {
        return whole[0] + (static_cast<double>(i) / n) * (whole[1] - whole[0]) +
               (static_cast<double>(k) / n) * (whole[2] - whole[0]);
    };
    for (int i = 0; i < n; ++i) {
        for (int k = 0; k < n - i; ++k) {
            visit(Corners{at(i, k), at(i + 1, k), at(i, k + 1)});
            if (k < n - i - 1) visit(Corners{at(i + 1, k + 1), at(i, k + 1), at(i + 1, k)});
        }
    }
}

/// What is behind a point near a facet, up to `reach` from it.
WallThickness::Wall wallAt(const WallThickness& thickness, const SampledFace& face, TriangleId t,
                           std::size_t side, const Vec3& point, double reach)
{
    const FaceTriangle& record = face.mesh.triangle(t);
    WallThickness::Probe probe{face.mesh.face(), point, face.mesh.vertex(record.v[0]).normal, {}};
    if (!face.geometry.isPlane()) {
        const SurfaceFacts facts = face.geometry.projected(point, record.uv[0]);
        probe.position = facts.position;
        probe.normal = facts.normal;
    }
    return thickness.wallBehind(probe, side, reach);
}

Corners cornersOf(const FaceMesh& mesh, TriangleId t)
{
    const auto& v = mesh.triangle(t).v;
    return {mesh.position(v[0]), mesh.position(v[1]), mesh.position(v[2])};
}

class Surveyor
{
public:
    Surveyor(const SampledSurface& surface, const RegionSides& sides, const WallSurveyOptions& options,
             RunContext& context)
        : surface_(surface),
          sides_(sides),
          options_(options),
          thickness_(surface, sides, context),
          watch_(context, kFacetsPerAsk)
    {
    }

    std::vector<SurveyedWall> run()
    {
        findNeighbours();
        for (std::uint32_t f = 0; f < sides_.size(); ++f) {
            const SampledFace* face = surface_.faces().face(BrepFaceId(f));
            if (face == nullptr) continue;
            for (std::uint32_t i = 0; i < face->mesh.triangleSlots(); ++i) {
                if (!watch_.mayGoOn()) return std::move(walls_);
                if (!face->mesh.triangle(TriangleId(i)).isAlive) continue;
                for (const std::size_t side : {0u, 1u}) {
                    if (sides_[BrepFaceId(f)][side].value != 0) measure(*face, TriangleId(i), side);
                }
            }
        }
        for (std::uint32_t f = 0; f < sides_.size(); ++f) {
            if (const SampledFace* face = surface_.faces().face(BrepFaceId(f))) addRims(*face);
        }
        return std::move(walls_);
    }

private:
    void measure(const SampledFace& face, TriangleId t, std::size_t side)
    {
        const Corners whole = cornersOf(face.mesh, t);
        const double longest = longestOf(whole);
        double wanted = longest;
        if (options_.sizeAt) wanted = std::min(wanted, options_.sizeAt(centroidOf(whole)));
        const int n = std::clamp(static_cast<int>(std::ceil(longest / wanted)), 1, kMostPieces);
        forEachPiece(whole, n, [&](const Corners& piece) { measurePiece(face, t, side, piece, wanted); });
    }

    void measurePiece(const SampledFace& face, TriangleId t, std::size_t side, const Corners& corner,
                      double wanted)
    {
        const double longest = std::min(wanted, longestOf(corner));
        const Vec3 middle = centroidOf(corner);
        const WallThickness::Wall wall = wallAt(thickness_, face, t, side, middle, kThin * longest);
        if (wall.thickness == 0.0) return;
        const double tets = tetsBehind({face, t, side, wall.across, kThin * longest}, corner);
        if (tets == 0.0) return;
        SurveyedWall& found =
            wallOf(WallSides::of(face.mesh.face(), wall.across, sides_[face.mesh.face()][side]));
        found.facets += options_.sizeAt ? areaOf(corner) / (kEquilateral * longest * longest) : 1.0;
        found.tets += tets;
        if (found.thickness == 0.0 || wall.thickness < found.thickness) {
            found.thickness = wall.thickness;
            found.place = middle;
        }
    }

    /// One side of a wall, seen from a facet.
    struct View
    {
        const SampledFace& face;
        TriangleId triangle;
        std::size_t side;
        BrepFaceId across;
        double reach;
    };

    /// Good tetrahedra behind a piece of a facet; 0 where it runs out.
    [[nodiscard]] double tetsBehind(const View& view, const Corners& corner) const
    {
        const Vec3 middle = centroidOf(corner);
        const auto thicknessAt = [&](const Vec3& p) {
            return wallAt(thickness_, view.face, view.triangle, view.side, p, view.reach).thickness;
        };
        double thickest = 0.0;
        double least = view.reach;
        for (const Vec3& c : corner) {
            const double there = thicknessAt(middle + kTowardsCorners * (c - middle));
            thickest = std::max(thickest, there == 0.0 ? view.reach : there);
            least = std::min(least, there == 0.0 ? view.reach : there);
        }
        const bool meet = doMeet(view.face.mesh.face(), view.across);
        // A wedge is thin beside its edge whatever its angle: what counts is where it is thickest. That decides as well where it
        // hardly changes.
        if (meet || least > kEven * thickest)
            return thickest < view.reach ? kTetsPerSide * areaOf(corner) / (thickest * thickest) : 0.0;
        double tets = 0.0;
        forEachPiece(corner, kMostPieces, [&](const Corners& piece) {
            const double there = thicknessAt(centroidOf(piece));
            if (there > 0.0) tets += kTetsPerSide * areaOf(piece) / (there * there);
        });
        return tets;
    }

    /// Whether the faces have an edge in common.
    [[nodiscard]] bool doMeet(BrepFaceId a, BrepFaceId b) const
    {
        return std::binary_search(neighbours_.begin(), neighbours_.end(),
                                  std::pair(std::min(a, b), std::max(a, b)));
    }

    void findNeighbours()
    {
        const SampledFaces& faces = surface_.faces();
        for (std::uint32_t e = 0; e < faces.model().edges.size(); ++e) {
            for (const BrepFaceId a : faces.facesOf(BrepEdgeId(e))) {
                for (const BrepFaceId b : faces.facesOf(BrepEdgeId(e))) {
                    if (a < b) neighbours_.emplace_back(a, b);
                }
            }
        }
        std::sort(neighbours_.begin(), neighbours_.end());
    }

    SurveyedWall& wallOf(const WallSides& sides)
    {
        const auto known = std::find_if(walls_.begin(), walls_.end(),
                                        [&](const SurveyedWall& wall) { return wall.sides == sides; });
        if (known != walls_.end()) return *known;
        walls_.push_back({});
        walls_.back().sides = sides;
        return walls_.back();
    }

    /// What good facets would bring about where flat ones wait.
    void addRims(const SampledFace& face)
    {
        for (std::uint32_t i = 0; i < face.mesh.triangleSlots(); ++i) {
            const FaceTriangle& record = face.mesh.triangle(TriangleId(i));
            if (!record.isAlive || record.left != FacetLeft::Rim) continue;
            const std::optional<RimPlace> place = face.refiner.rimPlaceOf(TriangleId(i));
            if (!place) continue;
            for (const WallSides& sides :
                 surface_.faces().rims().wallsBetween(face.mesh.face(), place->edge[0], place->edge[1])) {
                const auto wall = std::find_if(walls_.begin(), walls_.end(),
                                               [&](const SurveyedWall& w) { return w.sides == sides; });
                if (wall == walls_.end()) continue;
                wall->tets += kTetsPerRimEdge * place->length / place->width;
                if (wall->rims.empty() || wall->rims.back() != face.mesh.face())
                    wall->rims.push_back(face.mesh.face());
            }
        }
    }

    const SampledSurface& surface_;
    const RegionSides& sides_;
    const WallSurveyOptions& options_;
    WallThickness thickness_;
    StepWatch watch_;
    std::vector<std::pair<BrepFaceId, BrepFaceId>> neighbours_;  ///< ascending
    std::vector<SurveyedWall> walls_;
};

}  // namespace

std::vector<SurveyedWall> surveyWalls(const SampledSurface& surface, const RegionSides& sides,
                                      const WallSurveyOptions& options, RunContext& context)
{
    return Surveyor(surface, sides, options, context).run();
}

std::vector<FlatWallFacet> facetsOnWalls(const SampledSurface& surface, const RegionSides& sides,
                                         const std::vector<WallSides>& kept, RunContext& context)
{
    std::vector<FlatWallFacet> found;
    if (kept.empty()) return found;
    const WallThickness thickness(surface, sides, context);
    StepWatch watch(context, kFacetsPerAsk);
    const auto isOfKept = [&](BrepFaceId f) {
        return std::any_of(kept.begin(), kept.end(),
                           [&](const WallSides& wall) { return wall.face[0] == f || wall.face[1] == f; });
    };
    for (std::uint32_t i = 0; i < surface.mesh().facets.size() && watch.mayGoOn(); ++i) {
        const SurfaceFacet& facet = surface.mesh().facets[FacetId(i)];
        if (!facet.isAlive() || !isOfKept(facet.face)) continue;
        const SampledFace& face = *surface.faces().face(facet.face);
        const TriangleId t = surface.triangleOf(FacetId(i));
        const Corners corner = cornersOf(face.mesh, t);
        const Vec3 middle = centroidOf(corner);
        for (const std::size_t side : {0u, 1u}) {
            if (sides[facet.face][side].value == 0) continue;
            const WallThickness::Wall wall = wallAt(thickness, face, t, side, middle, longestOf(corner));
            if (wall.thickness == 0.0) continue;
            const WallSides between = WallSides::of(facet.face, wall.across, sides[facet.face][side]);
            if (std::binary_search(kept.begin(), kept.end(), between))
                found.push_back({FacetId(i), between, wall.thickness, middle});
        }
    }
    return found;
}

void keepDearWalls(std::vector<SurveyedWall>& walls, double budget, double leastSize)
{
    std::vector<std::size_t> order(walls.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::stable_sort(order.begin(), order.end(),
                     [&](std::size_t a, std::size_t b) { return walls[a].tets < walls[b].tets; });
    double spent = 0.0;
    for (const std::size_t i : order) {
        SurveyedWall& wall = walls[i];
        wall.needed = spent += wall.tets;
        wall.isBelowLeastSize = wall.thickness < leastSize;
        wall.isKept = wall.needed > budget || wall.isBelowLeastSize;
    }
}

namespace {

std::vector<WallSides> sidesOf(const std::vector<SurveyedWall>& walls, bool isKept)
{
    std::vector<WallSides> sides;
    for (const SurveyedWall& wall : walls) {
        if (wall.isKept == isKept) sides.push_back(wall.sides);
    }
    std::sort(sides.begin(), sides.end());
    return sides;
}

}  // namespace

std::vector<WallSides> keptOf(const std::vector<SurveyedWall>& walls) { return sidesOf(walls, true); }

std::vector<WallSides> goodOf(const std::vector<SurveyedWall>& walls) { return sidesOf(walls, false); }

}  // namespace mesher
