#include "pipeline/planar_sizes.h"

#include "mesh/classified_mesh.h"
#include "sizing/attractor_size.h"
#include "sizing/combined_size.h"
#include "sizing/uniform_size.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

namespace mesher {

namespace {

/// Straight pieces that stand for a curve between two of its knots.
constexpr int kPiecesBetweenKnots = 64;

struct CurveSample
{
    Vec3 position;
    double curvature = 0.0;
};

std::vector<CurveSample> sampled(const PccCurve& curve)
{
    std::vector<double> cuts = {curve.part.first};
    for (const double knot : curve.curve->knots()) {
        if (knot > curve.part.first && knot < curve.part.last) cuts.push_back(knot);
    }
    cuts.push_back(curve.part.last);
    std::vector<CurveSample> samples;
    for (std::size_t i = 0; i + 1 < cuts.size(); ++i) {
        for (int k = i == 0 ? 0 : 1; k <= kPiecesBetweenKnots; ++k) {
            const Interval piece = {cuts[i], cuts[i + 1]};
            const CurvePoint point =
                curve.curve->evaluate(piece.at(static_cast<double>(k) / kPiecesBetweenKnots));
            const double speed = length(point.d1);
            const double curvature =
                speed > 0.0 ? length(cross(point.d1, point.d2)) / (speed * speed * speed) : 0.0;
            samples.push_back({point.position, curvature});
        }
    }
    return samples;
}

class PlanarSizeBuilder
{
public:
    PlanarSizeBuilder(const PlanarCurveComplex& complex, const MeshOptions& options)
        : complex_(complex), options_(options)
    {
    }

    Result<void> addLocalSizes()
    {
        for (const LocalSize& local : options_.localSizes) {
            if (!addLocal(local)) {
                return Error{ErrorCode::InvalidArgument,
                             "cannot have a size of its own: it is not an edge or vertex of the domain",
                             local.entity,
                             {},
                             "see mesher info for the names of the model"};
            }
        }
        return {};
    }

    /// On a circle of curvature k the edge for N in a turn is 2 pi / (N k), that of sag s is sqrt(8 s / k).
    void addCurvatureSizes()
    {
        if (options_.curvature == 0.0 && options_.sag == 0.0) return;
        for (const PccCurve& curve : complex_.curves) {
            addPieces(sampled(curve), [this](double curvature) {
                double size = kNoSize;
                if (options_.curvature > 0.0)
                    size = 2.0 * std::numbers::pi / (options_.curvature * curvature);
                if (options_.sag > 0.0) size = std::min(size, std::sqrt(8.0 * options_.sag / curvature));
                return size;
            });
        }
    }

    std::shared_ptr<const SizingField> combine(std::shared_ptr<const SizingField> background)
    {
        if (options_.size) fields_.push_back(std::make_shared<UniformSize>(*options_.size));
        if (background) fields_.push_back(std::move(background));
        if (!attractors_.empty()) {
            DistanceProfile profile;
            profile.growth = 1.0 / options_.grading;
            fields_.push_back(std::make_shared<AttractorSize>(std::move(attractors_), profile));
        }
        if (fields_.empty()) return nullptr;
        return std::make_shared<CombinedSize>(std::move(fields_), options_.minSize.value_or(0.0));
    }

private:
    bool addLocal(const LocalSize& local)
    {
        const std::optional<EntityRef> entity = entityNamed(local.entity);
        if (!entity) return false;
        bool isFound = false;
        if (entity->dimension == 0) {
            for (const PccPoint& point : complex_.points) {
                if (point.vertex.value != entity->index) continue;
                attractors_.push_back({point.spacePosition, point.spacePosition, local.size});
                isFound = true;
            }
        } else if (entity->dimension == 1) {
            for (const PccCurve& curve : complex_.curves) {
                if (curve.edge.value != entity->index) continue;
                addPieces(sampled(curve), [&](double) { return local.size; });
                isFound = true;
            }
        } else if (entity->dimension == 2 && complex_.regionNames.size() == 1) {
            isFound = complex_.regionNames.front() == local.entity;
            if (isFound) fields_.push_back(std::make_shared<UniformSize>(local.size));
        }
        return isFound;
    }

    template <class SizeOf>
    void addPieces(const std::vector<CurveSample>& samples, SizeOf sizeOf)
    {
        for (std::size_t i = 0; i + 1 < samples.size(); ++i) {
            const double size = sizeOf(std::max(samples[i].curvature, samples[i + 1].curvature));
            if (size < kNoSize && size > 0.0)
                attractors_.push_back({samples[i].position, samples[i + 1].position, size});
        }
    }

    const PlanarCurveComplex& complex_;
    const MeshOptions& options_;
    std::vector<Attractor> attractors_;
    std::vector<std::shared_ptr<const SizingField>> fields_;
};

}  // namespace

Result<std::shared_ptr<const SizingField>> planarSizes(const PlanarCurveComplex& complex,
                                                       const MeshOptions& options,
                                                       std::shared_ptr<const SizingField> background)
{
    PlanarSizeBuilder builder(complex, options);
    if (const Result<void> added = builder.addLocalSizes(); !added) return added.error();
    builder.addCurvatureSizes();
    return builder.combine(std::move(background));
}

}  // namespace mesher
