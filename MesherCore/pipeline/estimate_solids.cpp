#include "pipeline/estimate_solids.h"

#include "delaunay/triangulation3d.h"
#include "pipeline/feature_sizes.h"
#include "pipeline/model_components.h"
#include "pipeline/solid_region.h"
#include "pipeline/wall_budget.h"
#include "sizing/combined_size.h"
#include "surface_sampling/sample_surface.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace mesher {

namespace {

// Measured on meshes of ordinary parts: an element of edge length h takes 0.118 h^3 if it is regular; inside, edges are longer than
// the size (size_bounds.h), so that there are fewer. Beside a face finer than its surroundings elements grow away from it.
constexpr double kRegularTet = 0.118;
constexpr double kRegularTriangle = 0.433;
constexpr double kTetsForWanted = 0.72;
constexpr double kTetsForFineTriangle = 9.0;  // with those along its edges
constexpr double kTetsForFineFacet = 9.2;
constexpr double kTetsForEdge = 15.0;
constexpr double kTetsForFlatFacet =
    2.3;  // 1.5 where the sides of a wall have the same facets, up to 3.5 where not
constexpr double kBytesForTet = 220.0;
constexpr double kBytesAtLeast = 4e7;
constexpr double kTetsInSecond = 3.5e5;
constexpr double kRadiansForEdge = 1.2;    // that an edge turns at most where no curvature is asked for
constexpr double kLargestOfModel = 0.125;  // size without any wish, of the box's diagonal
constexpr double kTrustedUncertainty = 0.05;
constexpr double kLeastShare =
    1e-9;  // of the largest size: what is smaller makes far too many elements anyway
constexpr double kLargestMinAngle = 34.0;             // degrees, see FacetCriteriaOptions
constexpr std::size_t kMostSampledVertices = 60'000;  // about a second

double sizeAt(const SizingField& sizes, double largest, const Vec3& place)
{
    return std::clamp(sizes.sizeAt(place), kLeastShare * largest, largest);
}

/// Mean of 1 / size^3 over the part of a box that is in a region, on cells as fine as the field varies.
class MeanDensity
{
public:
    /// Without a region, over all of the box.
    MeanDensity(const SizingField& sizes, double largest, const SizeRegion* region)
        : sizes_(sizes), largest_(largest), region_(region), leastDepth_(region != nullptr ? 5 : 3)
    {
    }

    /// None if no cell is in the region.
    std::optional<double> of(const Box3& box, RunContext& context)
    {
        StepWatch watch(context, kCellsPerAsk);
        add(box, 0, 1.0, watch);
        if (!(inside_ > 0.0)) return std::nullopt;
        return sum_ / inside_;
    }

private:
    void add(const Box3& box, int depth, double share, StepWatch& watch)
    {
        if (!watch.mayGoOn()) return;
        ++cells_;
        const Vec3 centre = 0.5 * (box.low + box.high);
        const double size = sizeAt(sizes_, largest_, centre);
        const double radius = 0.5 * length(box.extent());
        const bool varies = std::min(largest_, sizes_.smallestNear(centre, radius)) < 0.8 * size;
        if (depth >= leastDepth_ && (!varies || depth >= kMostDepth || cells_ > kMostCells)) {
            if (region_ != nullptr && !region_->contains(centre)) return;
            inside_ += share;
            sum_ += share / (size * size * size);
            return;
        }
        for (int octant = 0; octant < 8; ++octant) {
            Box3 part;
            part.include(centre);
            part.include({(octant & 1) != 0 ? box.high.x : box.low.x,
                          (octant & 2) != 0 ? box.high.y : box.low.y,
                          (octant & 4) != 0 ? box.high.z : box.low.z});
            add(part, depth + 1, 0.125 * share, watch);
        }
    }

    static constexpr int kMostDepth = 8;
    static constexpr int kMostCells = 300'000;
    static constexpr std::uint32_t kCellsPerAsk = 256;

    const SizingField& sizes_;
    double largest_;
    const SizeRegion* region_;
    int leastDepth_;
    int cells_ = 0;
    double inside_ = 0.0;
    double sum_ = 0.0;
};

/// The edge length that a curvature asks for.
double curvedSize(double bend, const MeshOptions& options)
{
    if (!(bend > 0.0)) return kNoSize;
    double size = kRadiansForEdge / bend;
    if (options.curvature > 0.0) size = std::min(size, 2.0 * std::numbers::pi / (options.curvature * bend));
    if (options.sag > 0.0) size = std::min(size, std::sqrt(8.0 * options.sag / bend));
    return std::max(size, options.minSize.value_or(0.0));
}

struct FaceSample
{
    double weight;  // area per du dv
    double wanted;  // size without curvature
    double bend;    // larger curvature, per model unit
};

/// On a grid of the face's parameters. Of curvatures the highest tenth is levelled: a spike is no area.
std::vector<FaceSample> samplesOf(const BrepFace& face, const SizingField* sizes, double largest, int perSide)
{
    std::vector<FaceSample> samples;
    std::vector<double> bends;
    for (int i = 0; i < perSide * perSide; ++i) {
        const double row = i / perSide;
        const double column = i % perSide;
        const Vec2 uv{face.boundsU.at((column + 0.5) / perSide), face.boundsV.at((row + 0.5) / perSide)};
        if (face.trim && face.trim->classify(uv) == TrimSide::Outside) continue;
        const SurfacePoint point = face.surface->evaluate(uv);
        const std::optional<SurfaceCurvature> curvature = curvatureOf(point);
        bends.push_back(curvature ? std::abs(curvature->largest) : 0.0);
        const double wanted = sizes != nullptr ? sizeAt(*sizes, largest, point.position) : largest;
        samples.push_back({length(point.normal()), wanted, bends.back()});
    }
    if (samples.empty()) return samples;
    const auto highest = bends.begin() + static_cast<std::ptrdiff_t>(9 * bends.size() / 10);
    std::nth_element(bends.begin(), highest, bends.end());
    for (FaceSample& sample : samples) sample.bend = std::min(sample.bend, *highest);
    return samples;
}

/// Triangles of a face beyond those that the sizes around it would make.
double fineTriangles(const BrepFace& face, double area, const MeshOptions& options, const SizingField* sizes,
                     double largest)
{
    if (face.surface->kind() == SurfaceKind::Plane) return 0.0;
    constexpr int kPerSide = 12;
    double weights = 0.0;
    double sum = 0.0;
    for (const FaceSample& sample : samplesOf(face, sizes, largest, kPerSide)) {
        const double curved = std::max(kLeastShare * largest, curvedSize(sample.bend, options));
        const double size = std::min(sample.wanted, curved);
        weights += sample.weight;
        sum += sample.weight * (1.0 / (size * size) - 1.0 / (sample.wanted * sample.wanted));
    }
    return weights > 0.0 ? area * sum / (weights * kRegularTriangle) : 0.0;
}

/// Segments that the sizes make of an edge.
double segmentsOf(const BrepEdge& edge, const SizingField& sizes, double largest)
{
    constexpr int kPieces = 16;
    double sum = 0.0;
    if (!edge.curve) return sum;
    Vec3 before = edge.curve->position(edge.part.first);
    for (int i = 1; i <= kPieces; ++i) {
        const Vec3 here = edge.curve->position(edge.part.at(static_cast<double>(i) / kPieces));
        const Vec3 middle = edge.curve->position(edge.part.at((i - 0.5) / kPieces));
        sum += length(here - before) / sizeAt(sizes, largest, middle);
        before = here;
    }
    return sum;
}

/// Triangles that the sizes make of a face.
double trianglesOf(const BrepFace& face, double area, const SizingField& sizes, double largest)
{
    constexpr int kPerSide = 4;
    double weights = 0.0;
    double sum = 0.0;
    for (const FaceSample& sample : samplesOf(face, &sizes, largest, kPerSide)) {
        weights += sample.weight;
        sum += sample.weight / (sample.wanted * sample.wanted);
    }
    return weights > 0.0 ? area * sum / (weights * kRegularTriangle) : 0.0;
}

/// What edges and faces have for the sizes on them alone, and the one that has the most.
struct BoundaryElements
{
    double segments = 0.0;
    double triangles = 0.0;
    double most = 0.0;
    std::string entity;

    [[nodiscard]] double count() const { return std::max(segments, triangles); }
    void add(double elements, const std::string& name, double& sum)
    {
        sum += elements;
        if (!(elements > most)) return;
        most = elements;
        entity = name;
    }
};

BoundaryElements boundaryElements(const BrepModel& model, const ModelMeasures& measures,
                                  const SizingField& sizes, double largest, RunContext& context)
{
    BoundaryElements elements;
    for (std::uint32_t i = 0; i < model.edges.size() && context.mayGoOn(); ++i) {
        const BrepEdgeId e(i);
        elements.add(segmentsOf(model.edges[e], sizes, largest), nameOf(e), elements.segments);
    }
    for (std::uint32_t i = 0; i < model.faces.size() && context.mayGoOn(); ++i) {
        const BrepFaceId f(i);
        const double triangles = trianglesOf(model.faces[f], measures.areaOf[f], sizes, largest);
        elements.add(triangles, nameOf(f), elements.triangles);
    }
    return elements;
}

double largestSize(const BrepModel& model, const MeshOptions& options)
{
    return std::min(options.size.value_or(kNoSize), kLargestOfModel * length(model.box.extent()));
}

/// Of the sizes wanted in the volume, which is the region if there is one; 0 where it is not known.
double tetsForSizes(const BrepModel& model, const SolidVolume& volume, const SizingField* sizes,
                    double largest, const SizeRegion* region, RunContext& context)
{
    if (volume.uncertainty > kTrustedUncertainty * volume.value) return 0.0;
    std::optional<double> density = 1.0 / (largest * largest * largest);
    if (sizes != nullptr) density = MeanDensity(*sizes, largest, region).of(model.box, context);
    if (!density) density = MeanDensity(*sizes, largest, nullptr).of(model.box, context);
    return kTetsForWanted * volume.value * density.value_or(0.0) / kRegularTet;
}

MeshEstimate costOfTets(double tets, const BrepModel& model, const BoundaryElements& boundary)
{
    constexpr double kShareToBeNamed = 0.5;
    const double elements =
        std::max({tets, boundary.count(), kTetsForEdge * static_cast<double>(model.edges.size())});
    MeshEstimate estimate = {elements, kBytesAtLeast + kBytesForTet * elements, elements / kTetsInSecond};
    if (boundary.most > kShareToBeNamed * elements) estimate.entity = boundary.entity;
    return estimate;
}

/// As the surfaces of a run are sampled, but for the sizes.
SurfaceSamplingOptions samplingOfShape(const MeshOptions& options)
{
    SurfaceSamplingOptions sampling;
    sampling.curves.segmentsPerTurn = options.curvature;
    sampling.curves.maxSag = options.sag;
    sampling.curves.maxVariation = std::min(options.maxTurn, sampling.curves.maxVariation);
    sampling.facets.minAngle = std::min(options.minAngle, kLargestMinAngle);
    sampling.facets.elementsPerTurn = options.curvature;
    sampling.facets.maxSag = options.sag;
    sampling.facets.leastCurvatureSize = options.minSize.value_or(0.0);
    sampling.limits.maxVertices = kMostSampledVertices;
    sampling.maxCertificateRounds = -1;
    return sampling;
}

std::shared_ptr<const SizingField> featuresOf(const BrepModel& model, const MeshOptions& options,
                                              RunContext& context)
{
    const Result<RegionSides> sides = regionSidesOf(model);
    if (!options.refinement || !sides) return nullptr;
    MeshOptions ofShape = options;
    ofShape.curvature = ofShape.sag = 0.0;
    SurfaceSamplingOptions sampling = samplingOfShape(ofShape);
    sampling.walls.sides = &*sides;
    sampling.walls.maxTets = wallBudgetOfFeatures(options).walls;
    sampling.walls.maxStripTets = wallBudgetOfFeatures(options).strips;
    sampling.walls.leastSize = options.minSize.value_or(0.0);
    return featureSizes(model, *sides, sampling, *options.refinement, options.grading, context).field;
}

/// Those with a solid on one side only.
void addOuterFacets(const BrepModel& model, const SurfaceMesh& mesh,
                    std::vector<std::array<Vec3, 3>>& triangles)
{
    const Result<RegionSides> sides = regionSidesOf(model);
    if (!sides) return;
    for (const SurfaceFacet& facet : mesh.facets) {
        if (!facet.isAlive()) continue;
        const auto& [front, behind] = (*sides)[facet.face];
        if ((front == kExteriorRegion) == (behind == kExteriorRegion)) continue;
        triangles.push_back({mesh.nodes[facet.node[0]].position, mesh.nodes[facet.node[1]].position,
                             mesh.nodes[facet.node[2]].position});
    }
}

double areaOfFacet(const SurfaceMesh& mesh, const SurfaceFacet& facet)
{
    const Vec3& a = mesh.nodes[facet.node[0]].position;
    return 0.5 *
           length(cross(mesh.nodes[facet.node[1]].position - a, mesh.nodes[facet.node[2]].position - a));
}

/// The surface of a component in the facets that its shape needs.
struct SampledComponentSurface
{
    SurfaceSample sample;
    RegionSides sides;
};

/// What a body has behind its surface, on average; infinite where its volume is not known.
double meanDepth(const SolidVolume& volume, const std::vector<SampledComponentSurface>& samples)
{
    if (volume.uncertainty > kTrustedUncertainty * volume.value) return kNoSize;
    double area = 0.0;
    for (const SampledComponentSurface& sample : samples) {
        const SurfaceMesh& mesh = sample.sample.surface->mesh();
        for (const SurfaceFacet& facet : mesh.facets)
            area += facet.isAlive() ? areaOfFacet(mesh, facet) : 0.0;
    }
    return volume.value / area;
}

/// Where what the shape needs cannot be told.
MeshEstimate leastOf(MeshEstimate forSizes)
{
    forSizes.isLeast = true;
    return forSizes;
}

/// In walls that are as good as the run may make them, and in those that it keeps flat.
double tetsInWalls(const std::vector<SurveyedWall>& walls)
{
    double tets = 0.0;
    for (const SurveyedWall& wall : walls) tets += wall.isKept ? kTetsForFlatFacet * wall.facets : wall.tets;
    return tets;
}

/// At facets beyond those that the sizes around them would make. Where there is no depth for all that a facet may have, as in
/// bars and plates, it has that of tetrahedra as small as itself in the depth that there is.
double tetsAtFineFacets(const SampledComponentSurface& sampled, const SizingField* sizes, double largest,
                        double depth, RunContext& context)
{
    const SampledSurface& surface = *sampled.sample.surface;
    const SurfaceMesh& mesh = surface.mesh();
    std::vector<bool> isInFlatWall(mesh.facets.size(), false);
    const std::vector<WallSides> kept = keptOf(sampled.sample.counts.surveyedWalls);
    for (const FlatWallFacet& flat : facetsOnWalls(surface, sampled.sides, kept, context))
        isInFlatWall[flat.facet.value] = true;
    double tets = 0.0;
    for (std::uint32_t i = 0; i < mesh.facets.size(); ++i) {
        const SurfaceFacet& facet = mesh.facets[FacetId(i)];
        if (!facet.isAlive() || surface.isOnFlatRim(FacetId(i))) continue;
        Vec3 middle;
        for (const NodeId node : facet.node) middle = middle + (1.0 / 3.0) * mesh.nodes[node].position;
        const double wanted = sizes != nullptr ? sizeAt(*sizes, largest, middle) : largest;
        const double own = std::sqrt(areaOfFacet(mesh, facet) / kRegularTriangle);
        const double inDepth = kTetsForWanted * kRegularTriangle * depth / (kRegularTet * own);
        const double share = std::max(0.0, 1.0 - own * own / (wanted * wanted));
        tets += share * (isInFlatWall[i] ? kTetsForFlatFacet : std::min(kTetsForFineFacet, inDepth));
    }
    return tets;
}

}  // namespace

MeshEstimate estimateSolids(const BrepModel& model, const ModelMeasures& measures, const MeshOptions& options,
                            const SizingField* sizes, RunContext& context)
{
    const double largest = largestSize(model, options);
    const double forSizes = tetsForSizes(model, measures.volume, sizes, largest, nullptr, context);
    double tets = forSizes;
    for (std::uint32_t i = 0; i < model.faces.size() && context.mayGoOn(); ++i) {
        const BrepFaceId f(i);
        tets +=
            kTetsForFineTriangle * fineTriangles(model.faces[f], measures.areaOf[f], options, sizes, largest);
    }
    BoundaryElements boundary;
    if (sizes != nullptr) boundary = boundaryElements(model, measures, *sizes, largest, context);
    MeshEstimate estimate = costOfTets(tets, model, boundary);
    estimate.forSizes = std::max(forSizes, boundary.count());
    return estimate;
}

MeshEstimate estimateSolidsBySample(const BrepModel& model, const MeshOptions& options,
                                    std::shared_ptr<const SizingField> sizes, RunContext& context)
{
    const ModelMeasures measures = measureModel(model, context);
    const MeshEstimate forSizes = estimateSolids(model, measures, options, sizes.get(), context);
    const std::vector<ModelComponent> components = solidComponents(model);
    const std::vector<WallBudget> budgets = wallBudgets(components, options, forSizes);
    const double largest = largestSize(model, options);
    std::vector<std::shared_ptr<const SizingField>> fields;
    if (sizes) fields.push_back(sizes);
    std::vector<SampledComponentSurface> samples;
    std::vector<std::array<Vec3, 3>> hull;
    for (std::size_t i = 0; i < components.size(); ++i) {
        const ModelComponent& component = components[i];
        Result<RegionSides> sides = regionSidesOf(component.model);
        if (!sides) return leastOf(forSizes);
        SurfaceSamplingOptions sampling = samplingOfShape(options);
        sampling.walls.sides = &*sides;
        sampling.walls.maxTets = budgets[i].walls;
        sampling.walls.maxStripTets = budgets[i].strips;
        sampling.walls.leastSize = options.minSize.value_or(0.0);
        // Without a size, facets are as the shape makes them.
        if (options.size || sizes) {
            sampling.walls.sizeAt = [&](const Vec3& p) {
                return std::min(largest, sizes ? sizes->sizeAt(p) : kNoSize);
            };
        }
        Result<SurfaceSample> sample = sampleSurface(component.model, sampling, context);
        const bool isWhole = sample && sample->failures.empty() && sample->stopReason == StopReason::Done;
        if (!isWhole) return leastOf(forSizes);
        samples.push_back({std::move(sample).value(), std::move(sides).value()});
        addOuterFacets(component.model, samples.back().sample.surface->mesh(), hull);
        // What has no such sizes is refused by the run.
        if (auto features = featuresOf(component.model, options, context))
            fields.push_back(std::move(features));
    }
    if (options.refinement && !fields.empty())
        sizes = std::make_shared<CombinedSize>(std::move(fields), options.minSize.value_or(0.0));
    const SolidRegion inside(std::move(hull));
    double tets = tetsForSizes(model, measures.volume, sizes.get(), largest, &inside, context);
    const double depth = meanDepth(measures.volume, samples);
    for (const SampledComponentSurface& sample : samples)
        tets += tetsAtFineFacets(sample, sizes.get(), largest, depth, context) +
                tetsInWalls(sample.sample.counts.surveyedWalls);
    BoundaryElements boundary;
    if (sizes) boundary = boundaryElements(model, measures, *sizes, largest, context);
    return costOfTets(tets, model, boundary);
}

}  // namespace mesher
