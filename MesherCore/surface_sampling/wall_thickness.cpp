#include "surface_sampling/wall_thickness.h"

#include "surface_sampling/facet_measures.h"

#include <algorithm>
#include <cmath>

namespace mesher {
namespace {

constexpr std::uint32_t kVerticesPerAsk = 64;
/// Cosine between the ways across a wall from its two sides.
constexpr double kFacing = 0.7;
/// Thickest over least thickness at the corners of a facet, above which a wall runs out.
constexpr double kMostChange = 2.0;
/// Edges shorter than this share of the size wanted there are left: what is so thin for its size is not worth the facets.
constexpr double kLeastShare = 0.02;
/// Of a search's reach: what is nearer is the vertex's own place, where two faces meet.
constexpr double kOwnPlace = 1e-6;

std::vector<FacetId> livingFacets(const SurfaceMesh& mesh)
{
    std::vector<FacetId> facets;
    for (std::uint32_t i = 0; i < mesh.facets.size(); ++i) {
        if (mesh.facets[FacetId(i)].isAlive()) facets.push_back(FacetId(i));
    }
    return facets;
}

/// Of a chord so long on a circle of that radius.
double sagOf(double chord, double radius) { return std::min(chord * chord / (8.0 * radius), 0.5 * chord); }

/// Of facets with their surface in them.
std::vector<Box3> boxesOf(const SampledSurface& surface, const std::vector<FacetId>& facets)
{
    std::vector<Box3> boxes;
    for (const FacetId id : facets) {
        const SurfaceFacet& facet = surface.mesh().facets[id];
        const FaceMesh& mesh = surface.faces().face(facet.face)->mesh;
        std::array<Vec3, 3> corner;
        double squaredLongest = 0.0;
        double radius = std::numeric_limits<double>::infinity();
        for (std::size_t i = 0; i < 3; ++i) corner[i] = surface.mesh().nodes[facet.node[i]].position;
        for (std::size_t i = 0; i < 3; ++i) {
            squaredLongest = std::max(squaredLongest, squaredLength(corner[(i + 1) % 3] - corner[i]));
            radius =
                std::min(radius, mesh.vertex(mesh.triangle(surface.triangleOf(id)).v[i]).curvatureRadius);
        }
        Box3 box = Box3::of(corner);
        const double sag = sagOf(std::sqrt(squaredLongest), radius);
        box.low = box.low - Vec3{sag, sag, sag};
        box.high = box.high + Vec3{sag, sag, sag};
        boxes.push_back(box);
    }
    return boxes;
}

bool doMeet(const Box3& a, const Box3& b)
{
    return a.low.x <= b.high.x && b.low.x <= a.high.x && a.low.y <= b.high.y && b.low.y <= a.high.y &&
           a.low.z <= b.high.z && b.low.z <= a.high.z;
}

/// A facet may bulge between corners that have the same normals; this share of what its radius of curvature says is always counted.
constexpr double kLeastSagShare = 0.25;

struct FacetExtent
{
    double longest = 0.0;
    double sag = 0.0;
    double chordSag = 0.0;
    double size = 0.0;       ///< wanted, the least
    bool isBeneath = false;  ///< the chords lie on the side that normals point away from

    FacetExtent(const FaceMesh& mesh, const FaceTriangle& record)
        : longest(std::sqrt(FacetShape::of(mesh.position(record.v[0]), mesh.position(record.v[1]),
                                           mesh.position(record.v[2]))
                                .longestSquared())),
          size(std::min(
              {mesh.vertex(record.v[0]).size, mesh.vertex(record.v[1]).size, mesh.vertex(record.v[2]).size}))
    {
        double radius = std::numeric_limits<double>::infinity();
        double diverging = 0.0;
        for (unsigned k = 0; k < 3; ++k) {
            const FaceVertex &a = mesh.vertex(record.v[nextCorner(k)]),
                             &b = mesh.vertex(record.v[previousCorner(k)]);
            radius = std::min(radius, a.curvatureRadius);
            const Vec3 chord = b.position - a.position;
            // The normals turn by this along the side, which is what its sag follows from, whatever it is in other directions.
            chordSag = std::max(chordSag, 0.125 * length(chord) * length(b.normal - a.normal));
            diverging += dot(b.normal - a.normal, chord);
        }
        const bool hasNormals = std::all_of(record.v.begin(), record.v.end(),
                                            [&](VertexId v) { return mesh.vertex(v).normal != Vec3{}; });
        sag = sagOf(longest, radius);
        chordSag = hasNormals ? std::max(chordSag, kLeastSagShare * sag) : sag;
        isBeneath = diverging > 0.0;
    }
    /// The thickness of wall below which the facet is too coarse.
    [[nodiscard]] double limit(double share, double leastEdges, double largestSize) const
    {
        if (longest < kLeastShare * std::min(size, largestSize)) return 0.0;
        return std::min(sag / share, longest / leastEdges);
    }
};

}  // namespace

WallThickness::WallThickness(const SampledSurface& surface, const RegionSides& sides, RunContext& context)
    : surface_(surface),
      sides_(sides),
      context_(context),
      facets_(livingFacets(surface.mesh())),
      boxes_(boxesOf(surface, facets_)),
      tree_(boxes_),
      largestSize_(length(surface.faces().model().box.extent()))
{
}

std::vector<CoarseWallFacet> WallThickness::coarseFacets(double share, double leastEdges) const
{
    std::vector<CoarseWallFacet> coarse;
    for (std::uint32_t f = 0; f < sides_.size(); ++f) {
        const SampledFace* face = surface_.faces().face(BrepFaceId(f));
        if (face == nullptr || face->geometry.isPlane()) continue;
        for (const std::size_t side : {0u, 1u}) {
            if (sides_[BrepFaceId(f)][side].value != 0)
                addCoarse(BrepFaceId(f), side, share, leastEdges, coarse);
        }
    }
    return coarse;
}

/// How far to look from each vertex: twice as thick as the thickest wall that a facet around it is too coarse for.
std::vector<double> WallThickness::reachesIn(BrepFaceId f, double share, double leastEdges) const
{
    const FaceMesh& mesh = surface_.faces().face(f)->mesh;
    std::vector<double> reach(mesh.vertexSlots(), 0.0);
    for (std::uint32_t i = 0; i < mesh.triangleSlots(); ++i) {
        const FaceTriangle& record = mesh.triangle(TriangleId(i));
        if (!record.isAlive) continue;
        const double limit = kMostChange * FacetExtent(mesh, record).limit(share, leastEdges, largestSize_);
        for (const VertexId v : record.v) reach[v.value] = std::max(reach[v.value], limit);
    }
    return reach;
}

void WallThickness::addCoarse(BrepFaceId f, std::size_t side, double share, double leastEdges,
                              std::vector<CoarseWallFacet>& coarse) const
{
    const FaceMesh& mesh = surface_.faces().face(f)->mesh;
    const std::vector<double> reach = reachesIn(f, share, leastEdges);
    std::vector<Wall> walls(reach.size());
    StepWatch watch(context_, kVerticesPerAsk);
    for (std::uint32_t v = 0; v < reach.size() && watch.mayGoOn(); ++v) {
        const FaceVertex& vertex = mesh.vertex(VertexId(v));
        if (reach[v] > 0.0 && vertex.isAlive)
            walls[v] = wallBehind({f, vertex.position, vertex.normal, vertex.node}, side, reach[v]);
    }
    for (std::uint32_t i = 0; i < mesh.triangleSlots(); ++i) {
        const FaceTriangle& record = mesh.triangle(TriangleId(i));
        if (!record.isAlive || record.isForced) continue;
        const auto [least, most] =
            std::minmax({walls[record.v[0].value].thickness, walls[record.v[1].value].thickness,
                         walls[record.v[2].value].thickness});
        const FacetExtent extent(mesh, record);
        if (!(least > 0.0 && least < extent.limit(share, leastEdges, largestSize_) &&
              most <= kMostChange * least))
            continue;
        const Vec3 normal = cross(mesh.position(record.v[1]) - mesh.position(record.v[0]),
                                  mesh.position(record.v[2]) - mesh.position(record.v[0]));
        coarse.push_back({f, TriangleId(i), walls[record.v[0].value].across, least, extent.longest,
                          extent.sag, extent.chordSag, 0.5 * length(normal), sides_[f][side],
                          extent.isBeneath == (side == 1)});
    }
}

std::vector<FacetId> WallThickness::facetsNear(const Vec3& from, const Vec3& to) const
{
    const Box3 way = Box3::of(std::array{from, to});
    std::vector<FacetId> near;
    std::vector<std::uint32_t> waiting{0};
    while (!waiting.empty()) {
        const std::uint32_t index = waiting.back();
        const BoxTree::Node& node = tree_.nodes()[index];
        waiting.pop_back();
        if (!doMeet(way, node.box)) continue;
        if (!node.isLeaf()) {
            waiting.push_back(index + 1);
            waiting.push_back(node.second);
            continue;
        }
        for (std::uint32_t i = node.begin; i < node.end; ++i) {
            const std::uint32_t item = tree_.order()[i];
            if (doMeet(way, boxes_[item])) near.push_back(facets_[item]);
        }
    }
    return near;
}

/// The nearest surface of a face that looks at the point from across the region on its side.
WallThickness::Wall WallThickness::wallBehind(const Probe& probe, std::size_t side, double reach) const
{
    if (probe.normal == Vec3{}) return {};
    const BrepFaceId f = probe.face;
    const bool isPlane = surface_.faces().face(f)->geometry.isPlane();
    const RegionId region = sides_[f][side];
    const Vec3 inward = side == 0 ? probe.normal : -1.0 * probe.normal;
    Wall wall;
    for (const FacetId id : facetsNear(probe.position, probe.position + reach * inward)) {
        const SurfaceFacet& facet = surface_.mesh().facets[id];
        const auto& behind = sides_[facet.face];
        if (behind[0] != region && behind[1] != region) continue;
        const bool isOwn = facet.face == f && (isPlane || std::find(facet.node.begin(), facet.node.end(),
                                                                    probe.node) != facet.node.end());
        if (isOwn) continue;
        // Closed forms and Newton steps alike need no better seed: facets follow their surface.
        const SurfaceFacts foot =
            surface_.faces().face(facet.face)->geometry.projected(probe.position, facet.parameters[0]);
        const Vec3 across = foot.position - probe.position;
        const double distance = length(across);
        if (!(distance > kOwnPlace * reach && distance <= reach) || dot(across, inward) < kFacing * distance)
            continue;
        const double cosine = dot(across, foot.normal) / distance;
        // What looks at the point is the side that du x dv points into where that is against the way across.
        if (std::abs(cosine) < kFacing || behind[cosine < 0.0 ? 0 : 1] != region) continue;
        if (wall.thickness == 0.0 || distance < wall.thickness) wall = {distance, facet.face};
    }
    return wall;
}

}  // namespace mesher
