#include "pipeline/planar_sizes.h"

#include "mesh/classified_mesh.h"
#include "pipeline/curve_pieces.h"
#include "pipeline/option_checks.h"
#include "pipeline/plane_region.h"
#include "pipeline/space_sizes.h"
#include "sizing/attractor_size.h"
#include "sizing/combined_size.h"
#include "sizing/formula_size.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <utility>

namespace mesher {

namespace {

/// What an entity of the domain is made of: points and chords, and the inside if it is a face.
struct EntityPlace
{
    std::vector<CurvePiece> pieces;
    std::shared_ptr<const PlaneRegion> region;
};

class PlanarSizeBuilder
{
public:
    PlanarSizeBuilder(const PlanarCurveComplex& complex, const MeshOptions& options)
        : complex_(complex), options_(options), fields_(spaceSizes(options))
    {
        const bool needsCurves = !options.localSizes.empty() || !options.distanceSizes.empty() ||
                                 options.curvature > 0.0 || options.sag > 0.0 || !options.sizeFormula.empty();
        if (!needsCurves) return;
        for (const PccCurve& curve : complex.curves) pieces_.push_back(piecesOf(*curve.curve, curve.part));
    }

    Result<void> addEntitySizes()
    {
        for (const LocalSize& local : options_.localSizes) {
            const std::optional<EntityPlace> place = placeOf(local.entity);
            if (!place) return notInDomain("local-size", local.entity);
            for (const CurvePiece& piece : place->pieces)
                graded_.push_back({piece.first, piece.last, local.size});
            if (place->region) fields_.push_back(std::make_shared<RegionSize>(place->region, local.size));
        }
        for (const SizeByDistance& wish : options_.distanceSizes) {
            const std::optional<EntityPlace> place = placeOf(wish.entity);
            if (!place) return notInDomain("size-distance", wish.entity);
            std::vector<Attractor> attractors;
            for (const CurvePiece& piece : place->pieces)
                attractors.push_back({piece.first, piece.last, wish.size});
            addAttractors(std::move(attractors), wish.growth, wish.plateau);
            if (place->region) fields_.push_back(std::make_shared<RegionSize>(place->region, wish.size));
        }
        return {};
    }

    /// On a circle of curvature k the edge for N in a turn is 2 pi / (N k), that of sag s is sqrt(8 s / k).
    void addCurvatureSizes()
    {
        for (const std::vector<CurvePiece>& pieces : pieces_) {
            for (const CurvePiece& piece : pieces) {
                double size = kNoSize;
                if (options_.curvature > 0.0)
                    size = 2.0 * std::numbers::pi / (options_.curvature * piece.curvature);
                if (options_.sag > 0.0)
                    size = std::min(size, std::sqrt(8.0 * options_.sag / piece.curvature));
                if (size < kNoSize && size > 0.0) graded_.push_back({piece.first, piece.last, size});
            }
        }
    }

    PlanarSizes combine(std::shared_ptr<const SizingField> fromFiles)
    {
        PlanarSizes sizes;
        warnOfFormula(sizes.warnings);
        if (fromFiles) fields_.push_back(std::move(fromFiles));
        addAttractors(std::move(graded_), 1.0 / options_.grading, 0.0);
        if (!fields_.empty())
            sizes.field = std::make_shared<CombinedSize>(std::move(fields_), options_.minSize.value_or(0.0));
        return sizes;
    }

private:
    static Error notInDomain(const char* option, const std::string& entity)
    {
        return {ErrorCode::InvalidArgument,
                std::string("cannot have a size of its own by --").append(option) +
                    ": it is no face, edge or vertex of the domain",
                entity,
                {},
                "see mesher info for the names of the model"};
    }

    std::optional<EntityPlace> placeOf(const std::string& name) const
    {
        const std::optional<EntityRef> entity = entityNamed(name);
        EntityPlace place;
        if (!entity) return std::nullopt;
        if (entity->dimension == 0) {
            for (const PccPoint& point : complex_.points) {
                if (point.vertex.value == entity->index)
                    place.pieces.push_back({point.spacePosition, point.spacePosition, 0.0});
            }
        } else if (entity->dimension == 1) {
            for (std::size_t i = 0; i < pieces_.size(); ++i) {
                if (complex_.curves[i].edge.value == entity->index) append(pieces_[i], place.pieces);
            }
        } else if (entity->dimension == 2) {
            const auto found = std::find(complex_.regionNames.begin(), complex_.regionNames.end(), name);
            if (found != complex_.regionNames.end()) {
                const auto region = static_cast<std::uint32_t>(found - complex_.regionNames.begin()) + 1;
                place = placeOf(RegionId(region));
            }
        }
        if (place.pieces.empty()) return std::nullopt;
        return place;
    }

    EntityPlace placeOf(RegionId region) const
    {
        EntityPlace place;
        std::vector<PlaneRegion::Chord> boundary;
        for (std::size_t i = 0; i < pieces_.size(); ++i) {
            const PccCurve& curve = complex_.curves[i];
            if ((curve.left == region) == (curve.right == region)) continue;
            append(pieces_[i], place.pieces);
            for (const CurvePiece& piece : pieces_[i]) {
                boundary.push_back({complex_.frame.toPlane(piece.first), complex_.frame.toPlane(piece.last)});
            }
        }
        place.region = std::make_shared<PlaneRegion>(complex_.frame, std::move(boundary));
        return place;
    }

    static void append(const std::vector<CurvePiece>& from, std::vector<CurvePiece>& to)
    {
        to.insert(to.end(), from.begin(), from.end());
    }

    void addAttractors(std::vector<Attractor> attractors, double growth, double plateau)
    {
        if (attractors.empty()) return;
        DistanceProfile profile;
        profile.growth = growth;
        profile.plateau = plateau;
        fields_.push_back(std::make_shared<AttractorSize>(std::move(attractors), profile));
    }

    /// Where a formula is not positive it asks for nothing, which its author should know.
    void warnOfFormula(std::vector<std::string>& warnings) const
    {
        if (options_.sizeFormula.empty()) return;
        const Result<FormulaSize> formula = FormulaSize::parse(options_.sizeFormula);
        for (const std::vector<CurvePiece>& pieces : pieces_) {
            for (const CurvePiece& piece : pieces) {
                if (formula->sizeAt(piece.first) < kNoSize) continue;
                warnings.push_back("--size-formula is not a positive number at (" + decimalOf(piece.first.x) +
                                   ", " + decimalOf(piece.first.y) + ", " + decimalOf(piece.first.z) +
                                   "), it asks for no size there");
                return;
            }
        }
    }

    const PlanarCurveComplex& complex_;
    const MeshOptions& options_;
    std::vector<std::vector<CurvePiece>> pieces_;  ///< by curve; empty if no option needs them
    std::vector<Attractor> graded_;
    std::vector<std::shared_ptr<const SizingField>> fields_;
};

}  // namespace

Result<PlanarSizes> planarSizes(const PlanarCurveComplex& complex, const MeshOptions& options,
                                std::shared_ptr<const SizingField> fromFiles)
{
    PlanarSizeBuilder builder(complex, options);
    if (const Result<void> added = builder.addEntitySizes(); !added) return added.error();
    builder.addCurvatureSizes();
    return builder.combine(std::move(fromFiles));
}

}  // namespace mesher
