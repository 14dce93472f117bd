#include "pipeline/estimate_solids.h"

#include "brep/face_area.h"
#include "brep/solid_volume.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <optional>
#include <vector>

namespace mesher {

namespace {

// Measured on meshes of ordinary parts: an element of edge length h takes 0.118 h^3 if it is regular; sizes are upper bounds, so
// that there are more. Beside a face finer than its surroundings elements grow away from it.
constexpr double kRegularTet = 0.118;
constexpr double kRegularTriangle = 0.433;
constexpr double kTetsForWanted = 1.35;
constexpr double kTetsForFineTriangle = 13.0;  // with those along its edges
constexpr double kTetsForEdge = 15.0;
constexpr double kBytesForTet = 220.0;
constexpr double kBytesAtLeast = 4e7;
constexpr double kTetsInSecond = 3.5e5;
constexpr double kRadiansForEdge = 1.2;    // that an edge turns at most where no curvature is asked for
constexpr double kLargestOfModel = 0.125;  // size without any wish, of the box's diagonal
constexpr double kTrustedUncertainty = 0.05;

/// Mean of 1 / size^3 over a box, on cells as fine as the field varies.
class MeanDensity
{
public:
    explicit MeanDensity(const SizingField& sizes, double largest) : sizes_(sizes), largest_(largest) {}

    double of(const Box3& box, int depth)
    {
        ++cells_;
        const Vec3 centre = 0.5 * (box.low + box.high);
        const double size = std::min(largest_, sizes_.sizeAt(centre));
        const double radius = 0.5 * length(box.extent());
        const bool varies = std::min(largest_, sizes_.smallestNear(centre, radius)) < 0.8 * size;
        if (depth >= kLeastDepth && (!varies || depth >= kMostDepth || cells_ > kMostCells))
            return 1.0 / (size * size * size);
        double sum = 0.0;
        for (int octant = 0; octant < 8; ++octant) {
            Box3 part;
            part.include(centre);
            part.include({(octant & 1) != 0 ? box.high.x : box.low.x,
                          (octant & 2) != 0 ? box.high.y : box.low.y,
                          (octant & 4) != 0 ? box.high.z : box.low.z});
            sum += of(part, depth + 1);
        }
        return sum / 8.0;
    }

private:
    static constexpr int kLeastDepth = 3;
    static constexpr int kMostDepth = 8;
    static constexpr int kMostCells = 300'000;

    const SizingField& sizes_;
    double largest_;
    int cells_ = 0;
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
std::vector<FaceSample> samplesOf(const BrepFace& face, const SizingField* sizes, double largest)
{
    constexpr int kPoints = 12;  // each way
    std::vector<FaceSample> samples;
    std::vector<double> bends;
    for (int i = 0; i < kPoints * kPoints; ++i) {
        const double row = i / kPoints;
        const double column = i % kPoints;
        const Vec2 uv{face.boundsU.at((column + 0.5) / kPoints), face.boundsV.at((row + 0.5) / kPoints)};
        if (face.trim && face.trim->classify(uv) == TrimSide::Outside) continue;
        const SurfacePoint point = face.surface->evaluate(uv);
        const std::optional<SurfaceCurvature> curvature = curvatureOf(point);
        bends.push_back(curvature ? std::abs(curvature->largest) : 0.0);
        const double wanted = sizes != nullptr ? sizes->sizeAt(point.position) : kNoSize;
        samples.push_back({length(point.normal()), std::min(largest, wanted), bends.back()});
    }
    if (samples.empty()) return samples;
    const auto highest = bends.begin() + static_cast<std::ptrdiff_t>(9 * bends.size() / 10);
    std::nth_element(bends.begin(), highest, bends.end());
    for (FaceSample& sample : samples) sample.bend = std::min(sample.bend, *highest);
    return samples;
}

/// Triangles of a face beyond those that the sizes around it would make.
double fineTriangles(const BrepModel& model, const BrepFace& face, const MeshOptions& options,
                     const SizingField* sizes, double largest)
{
    if (face.surface->kind() == SurfaceKind::Plane) return 0.0;
    double weights = 0.0;
    double sum = 0.0;
    for (const FaceSample& sample : samplesOf(face, sizes, largest)) {
        const double size = std::min(sample.wanted, curvedSize(sample.bend, options));
        weights += sample.weight;
        sum += sample.weight * (1.0 / (size * size) - 1.0 / (sample.wanted * sample.wanted));
    }
    return weights > 0.0 ? areaOf(model, face) * sum / (weights * kRegularTriangle) : 0.0;
}

}  // namespace

MeshEstimate estimateSolids(const BrepModel& model, const MeshOptions& options, const SizingField* sizes)
{
    const double largest =
        std::min(options.size.value_or(kNoSize), kLargestOfModel * length(model.box.extent()));
    const SolidVolume volume = volumeOf(model);
    const bool isTrusted = volume.uncertainty <= kTrustedUncertainty * volume.value;
    double elements = 0.0;
    if (isTrusted) {
        const double density = sizes != nullptr ? MeanDensity(*sizes, largest).of(model.box, 0)
                                                : 1.0 / (largest * largest * largest);
        elements += kTetsForWanted * volume.value * density / kRegularTet;
    }
    for (std::uint32_t i = 0; i < model.faces.size(); ++i) {
        elements +=
            kTetsForFineTriangle * fineTriangles(model, model.faces[BrepFaceId(i)], options, sizes, largest);
    }
    elements = std::max(elements, kTetsForEdge * static_cast<double>(model.edges.size()));
    return {elements, kBytesAtLeast + kBytesForTet * elements, elements / kTetsInSecond};
}

}  // namespace mesher
