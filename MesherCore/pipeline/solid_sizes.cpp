#include "pipeline/solid_sizes.h"

#include "mesh/classified_mesh.h"
#include "pipeline/curve_pieces.h"
#include "pipeline/space_sizes.h"
#include "sizing/attractor_size.h"
#include "sizing/combined_size.h"

#include <optional>
#include <utility>
#include <vector>

namespace mesher {

namespace {

/// Points and chords of an entity that stand for it.
class EntityPieces
{
public:
    explicit EntityPieces(const BrepModel& model) : model_(model) {}

    /// Empty if the model has no such entity.
    [[nodiscard]] std::vector<CurvePiece> of(const std::string& name) const
    {
        std::vector<CurvePiece> pieces;
        const std::optional<EntityRef> entity = entityNamed(name);
        if (!entity) return pieces;
        if (entity->dimension == 0 && entity->index < model_.vertices.size()) {
            const Vec3& place = model_.vertices[BrepVertexId(entity->index)].position;
            pieces.push_back({place, place, 0.0});
        }
        if (entity->dimension == 1 && entity->index < model_.edges.size())
            append(BrepEdgeId(entity->index), pieces);
        if (entity->dimension == 2 && entity->index < model_.faces.size()) {
            for (const BrepLoop& loop : model_.faces[BrepFaceId(entity->index)].loops) {
                for (const BrepCoedge& coedge : loop.coedges) append(coedge.edge, pieces);
            }
        }
        return pieces;
    }

private:
    void append(BrepEdgeId id, std::vector<CurvePiece>& pieces) const
    {
        const BrepEdge& edge = model_.edges[id];
        if (edge.isDegenerate) return;
        const std::vector<CurvePiece> own = piecesOf(*edge.curve, edge.part);
        pieces.insert(pieces.end(), own.begin(), own.end());
    }

    const BrepModel& model_;
};

std::shared_ptr<const SizingField> attractorField(const std::vector<CurvePiece>& pieces, double size,
                                                  double growth, double plateau)
{
    std::vector<Attractor> attractors;
    for (const CurvePiece& piece : pieces) attractors.push_back({piece.first, piece.last, size});
    DistanceProfile profile;
    profile.growth = growth;
    profile.plateau = plateau;
    return std::make_shared<AttractorSize>(std::move(attractors), profile);
}

Error notInModel(const char* option, const std::string& entity)
{
    return {ErrorCode::InvalidArgument,
            std::string("cannot have a size of its own by --").append(option) +
                ": it is no edge or vertex of the model",
            entity,
            {},
            "see mesher info for the names of the model"};
}

}  // namespace

Result<std::shared_ptr<const SizingField>> solidSizes(const BrepModel& model, const MeshOptions& options,
                                                      std::shared_ptr<const SizingField> fromFiles)
{
    std::vector<std::shared_ptr<const SizingField>> fields = spaceSizes(options);
    if (fromFiles) fields.push_back(std::move(fromFiles));
    const EntityPieces entities(model);
    for (const LocalSize& local : options.localSizes) {
        const std::vector<CurvePiece> pieces = entities.of(local.entity);
        if (pieces.empty()) return notInModel("local-size", local.entity);
        fields.push_back(attractorField(pieces, local.size, 1.0 / options.grading, 0.0));
    }
    for (const SizeByDistance& wish : options.distanceSizes) {
        const std::vector<CurvePiece> pieces = entities.of(wish.entity);
        if (pieces.empty()) return notInModel("size-distance", wish.entity);
        fields.push_back(attractorField(pieces, wish.size, wish.growth, wish.plateau));
    }
    if (fields.empty()) return std::shared_ptr<const SizingField>();
    return std::shared_ptr<const SizingField>(
        std::make_shared<CombinedSize>(std::move(fields), options.minSize.value_or(0.0)));
}

}  // namespace mesher
