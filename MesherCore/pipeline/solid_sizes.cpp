#include "pipeline/solid_sizes.h"

#include "mesh/classified_mesh.h"
#include "pipeline/coarse_faces.h"
#include "pipeline/curve_pieces.h"
#include "pipeline/solid_region.h"
#include "pipeline/space_sizes.h"
#include "sizing/attractor_size.h"
#include "sizing/combined_size.h"
#include "sizing/surface_size.h"
#include "sizing/uniform_size.h"

#include <algorithm>
#include <array>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace mesher {

namespace {

/// Facets that stand for a face depart from it by this share of the size on it, unless that is less than the share of the model
/// below: sizes so small are rather wanted in a layer as thin as that.
constexpr double kSagOfSize = 0.1;
constexpr double kLeastSag = 1e-4;

/// What a size is wanted on or in, and how it grows from there.
struct EntitySize
{
    const char* option;
    std::string entity;
    DistanceProfile profile;
};

class EntitySizes
{
public:
    EntitySizes(const BrepModel& model, const MeshOptions& options, RunContext& context)
        : model_(model), options_(options), context_(context)
    {
    }

    Result<void> add(const EntitySize& wish)
    {
        const std::optional<EntityRef> entity = entityNamed(wish.entity);
        if (!entity || !exists(*entity)) return notInModel(wish);
        if (entity->dimension == 3) return addSolid(BrepSolidId(entity->index), wish);
        if (entity->dimension == 2) return addFace(BrepFaceId(entity->index), wish);
        return addCurve(*entity, wish);
    }

    std::vector<std::shared_ptr<const SizingField>>& fields() { return fields_; }

private:
    [[nodiscard]] bool exists(const EntityRef& entity) const
    {
        switch (entity.dimension) {
            case 0: return entity.index < model_.vertices.size();
            case 1: return entity.index < model_.edges.size();
            case 2: return entity.index < model_.faces.size();
            default: return entity.index < model_.solids.size();
        }
    }

    static Error notInModel(const EntitySize& wish)
    {
        return {ErrorCode::InvalidArgument,
                std::string("cannot have a size of its own by --").append(wish.option) +
                    ": it is no solid, face, edge or vertex of the model",
                wish.entity,
                {},
                "see mesher info for the names of the model"};
    }

    Result<void> addSolid(BrepSolidId solid, const EntitySize& wish)
    {
        // Nothing else is meshed then, and no place has to be told from another.
        if (options_.dimension == 3 && model_.solids.size() == 1) {
            fields_.push_back(std::make_shared<UniformSize>(wish.profile.size));
            return {};
        }
        const auto facets = facetsOf(solidAlone(model_, solid), wish);
        if (!facets) return facets.error();
        std::vector<std::array<Vec3, 3>> triangles;
        for (const CoarseFacet& facet : *facets) triangles.push_back(facet.corner);
        fields_.push_back(std::make_shared<RegionSize>(std::make_shared<SolidRegion>(std::move(triangles)),
                                                       wish.profile.size));
        addFacets(*facets, wish);
        return {};
    }

    Result<void> addFace(BrepFaceId face, const EntitySize& wish)
    {
        const auto facets = facetsOf(facesAlone(model_, {face}), wish);
        if (!facets) return facets.error();
        addFacets(*facets, wish);
        return {};
    }

    Result<void> addCurve(const EntityRef& entity, const EntitySize& wish)
    {
        std::vector<Attractor> attractors;
        const auto append = [&](const Vec3& first, const Vec3& last) {
            attractors.push_back({first, last, wish.profile.size});
        };
        if (entity.dimension == 0) {
            const Vec3& place = model_.vertices[BrepVertexId(entity.index)].position;
            append(place, place);
        } else {
            const BrepEdge& edge = model_.edges[BrepEdgeId(entity.index)];
            if (edge.isDegenerate) {
                const Vec3& place = model_.vertices[edge.first].position;
                append(place, place);
            } else {
                for (const CurvePiece& piece : piecesOf(*edge.curve, edge.part))
                    append(piece.first, piece.last);
            }
        }
        fields_.push_back(std::make_shared<AttractorSize>(std::move(attractors), wish.profile));
        return {};
    }

    Result<std::vector<CoarseFacet>> facetsOf(const ModelComponent& part, const EntitySize& wish)
    {
        const double least = kLeastSag * length(model_.box.extent());
        return coarseFaces(part, std::max(kSagOfSize * wish.profile.size, least), context_);
    }

    void addFacets(const std::vector<CoarseFacet>& facets, const EntitySize& wish)
    {
        const double size = wish.profile.size;
        std::vector<SizedTriangle> triangles;
        triangles.reserve(facets.size());
        for (const CoarseFacet& facet : facets) {
            triangles.push_back({facet.corner, {size, size, size}, facet.departure + wish.profile.plateau});
        }
        fields_.push_back(std::make_shared<SurfaceSize>(std::move(triangles), wish.profile.growth));
    }

    const BrepModel& model_;
    const MeshOptions& options_;
    RunContext& context_;
    std::vector<std::shared_ptr<const SizingField>> fields_;
};

std::vector<EntitySize> wishesOf(const MeshOptions& options)
{
    std::vector<EntitySize> wishes;
    const auto add = [&](const char* option, const std::string& entity, const DistanceProfile& profile) {
        wishes.push_back({option, entity, profile});
    };
    for (const LocalSize& local : options.localSizes)
        add("local-size", local.entity, {.size = local.size, .growth = 1.0 / options.grading});
    for (const SizeByDistance& wish : options.distanceSizes)
        add("size-distance", wish.entity,
            {.size = wish.size, .plateau = wish.plateau, .growth = wish.growth});
    return wishes;
}

}  // namespace

Result<std::shared_ptr<const SizingField>> solidSizes(const BrepModel& model, const MeshOptions& options,
                                                      std::shared_ptr<const SizingField> fromFiles,
                                                      RunContext& context)
{
    EntitySizes ofEntities(model, options, context);
    ofEntities.fields() = spaceSizes(options);
    if (fromFiles) ofEntities.fields().push_back(std::move(fromFiles));
    for (const EntitySize& wish : wishesOf(options)) {
        if (const Result<void> added = ofEntities.add(wish); !added) return added.error();
    }
    if (ofEntities.fields().empty()) return std::shared_ptr<const SizingField>();
    return std::shared_ptr<const SizingField>(
        std::make_shared<CombinedSize>(std::move(ofEntities.fields()), options.minSize.value_or(0.0)));
}

}  // namespace mesher
