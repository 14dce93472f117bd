#include "surface_sampling/narrow_strips.h"

#include "surface_sampling/facet_measures.h"

#include <algorithm>
#include <numeric>
#include <optional>

namespace mesher {
namespace {

/// Good tetrahedra for a piece of an edge that is as long as the strip is wide, as measured on parts with steps and chamfers: sizes
/// grow from there into the faces and the solid beside it.
constexpr double kTetsPerEdge = 80.0;

/// Width over the length of facets, above which good ones are no more than some dozens for each that is wanted.
constexpr double kNarrow = 0.03;

bool isRimOf(const std::vector<SurveyedWall>& walls, const std::vector<WallSides>& between)
{
    return std::any_of(walls.begin(), walls.end(), [&](const SurveyedWall& wall) {
        return std::find(between.begin(), between.end(), wall.sides) != between.end();
    });
}

class StripSurveyor
{
public:
    StripSurveyor(const SampledSurface& surface, const std::vector<SurveyedWall>& walls,
                  const WallSurveyOptions& options)
        : faces_(surface.faces()), walls_(walls), options_(options)
    {
    }

    std::vector<SurveyedStrip> run()
    {
        for (std::uint32_t f = 0; f < faces_.model().faces.size(); ++f) {
            const SampledFace* face = faces_.face(BrepFaceId(f));
            if (face == nullptr) continue;
            SurveyedStrip strip;
            strip.face = BrepFaceId(f);
            addPlaces(*face, strip);
            // Beside edges that are fine anyhow flat facets would be bad and spare nothing.
            if (strip.coarse > strip.fine) strips_.push_back(strip);
        }
        return std::move(strips_);
    }

private:
    void addPlaces(const SampledFace& face, SurveyedStrip& strip) const
    {
        for (std::uint32_t i = 0; i < face.mesh.triangleSlots(); ++i) {
            const FaceTriangle& record = face.mesh.triangle(TriangleId(i));
            const bool isFlat = record.left == FacetLeft::Rim || record.left == FacetLeft::Strip;
            if (record.isAlive && isFlat) addPlace(face, TriangleId(i), strip);
        }
    }

    void addPlace(const SampledFace& face, TriangleId t, SurveyedStrip& strip) const
    {
        const std::optional<RimPlace> place = face.refiner.rimPlaceOf(t);
        if (!place) return;
        const auto& corner = face.mesh.triangle(t).v;
        const Vec3 middle = (1.0 / 3.0) * (face.mesh.position(corner[0]) + face.mesh.position(corner[1]) +
                                           face.mesh.position(corner[2]));
        // Where facets are larger than wanted, what is narrow beside them need not be so for the sizes.
        if (options_.sizeAt && place->width >= kFlatFacet * options_.sizeAt(middle)) return;
        if (!faces_.rims().isStrip(strip.face, place->edge[0], place->edge[1])) return;
        if (isRimOf(walls_, faces_.rims().wallsBetween(strip.face, place->edge[0], place->edge[1]))) return;
        strip.tets += kTetsPerEdge * place->length / place->width;
        (place->width < kNarrow * place->length ? strip.coarse : strip.fine) += place->length;
        if (strip.width > 0.0 && strip.width <= place->width) return;
        strip.width = place->width;
        strip.place = middle;
    }

    const SampledFaces& faces_;
    const std::vector<SurveyedWall>& walls_;
    const WallSurveyOptions& options_;
    std::vector<SurveyedStrip> strips_;
};

}  // namespace

std::vector<SurveyedStrip> surveyStrips(const SampledSurface& surface, const std::vector<SurveyedWall>& walls,
                                        const WallSurveyOptions& options)
{
    return StripSurveyor(surface, walls, options).run();
}

void keepDearStrips(std::vector<SurveyedStrip>& strips, double budget, double leastSize)
{
    std::vector<std::size_t> order(strips.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::stable_sort(order.begin(), order.end(),
                     [&](std::size_t a, std::size_t b) { return strips[a].tets < strips[b].tets; });
    double spent = 0.0;
    for (const std::size_t i : order) {
        SurveyedStrip& strip = strips[i];
        strip.needed = spent += strip.tets;
        strip.isBelowLeastSize = strip.width < leastSize;
        strip.isKept = strip.needed > budget || strip.isBelowLeastSize;
    }
}

bool letFineStripsGo(const SampledSurface& surface, const std::vector<SurveyedWall>& walls,
                     const WallSurveyOptions& options, std::vector<SurveyedStrip>& strips)
{
    const std::vector<SurveyedStrip> now = surveyStrips(surface, walls, options);
    bool isAny = false;
    for (SurveyedStrip& strip : strips) {
        const bool isCoarse = std::any_of(
            now.begin(), now.end(), [&](const SurveyedStrip& other) { return other.face == strip.face; });
        isAny = isAny || (strip.isKept && !isCoarse);
        strip.isKept = strip.isKept && isCoarse;
    }
    return isAny;
}

std::vector<BrepFaceId> facesOfKept(const std::vector<SurveyedStrip>& strips)
{
    std::vector<BrepFaceId> kept;
    for (const SurveyedStrip& strip : strips) {
        if (strip.isKept) kept.push_back(strip.face);
    }
    return kept;
}

std::vector<FlatStripFacet> facetsOnStrips(const SampledSurface& surface)
{
    std::vector<FlatStripFacet> found;
    const SurfaceMesh& mesh = surface.mesh();
    for (std::uint32_t i = 0; i < mesh.facets.size(); ++i) {
        const SurfaceFacet& facet = mesh.facets[FacetId(i)];
        if (!facet.isAlive()) continue;
        const FaceMesh& face = surface.faces().face(facet.face)->mesh;
        if (face.triangle(surface.triangleOf(FacetId(i))).left != FacetLeft::Strip) continue;
        found.push_back({FacetId(i), facet.face});
    }
    return found;
}

}  // namespace mesher
