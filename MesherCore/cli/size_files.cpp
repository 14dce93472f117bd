#include "cli/size_files.h"

#include "io/mesh_reader.h"
#include "io/read_size_points.h"
#include "sizing/attractor_size.h"
#include "sizing/background_size.h"
#include "sizing/combined_size.h"

#include <utility>
#include <vector>

namespace mesher {

namespace {

/// A mesh with one number at each node: the size.
Result<std::shared_ptr<const SizingField>> readBackground(const std::string& path)
{
    Result<MeshFile> file = readMesh(path);
    if (!file) return file.error();
    if (file->fields.empty()) {
        return Error{ErrorCode::Unreadable,
                     "has no number at its nodes to take as the size",
                     path,
                     {},
                     "add a nodal field to the mesh"};
    }
    BackgroundMesh background;
    for (const MeshNode& node : file->mesh.nodes) background.nodes.push_back(node.position);
    background.sizes = std::move(file->fields.front().values);
    for (const auto& [node, entity] : file->mesh.triangles) {
        background.triangles.push_back({node[0].value, node[1].value, node[2].value});
    }
    for (const auto& [node, entity] : file->mesh.tets) {
        background.tets.push_back({node[0].value, node[1].value, node[2].value, node[3].value});
    }
    Result<std::shared_ptr<const BackgroundSize>> field = BackgroundSize::make(std::move(background));
    if (field) return std::shared_ptr<const SizingField>(std::move(field).value());
    Error error = field.error();
    error.message = error.entity + ": " + error.message;
    error.entity = path;
    return error;
}

Result<std::shared_ptr<const SizingField>> readPoints(const std::string& path, double grading)
{
    const Result<std::vector<SizePoint>> points = readSizePoints(path);
    if (!points) return points.error();
    std::vector<Attractor> attractors;
    for (const SizePoint& point : points.value())
        attractors.push_back({point.position, point.position, point.size});
    DistanceProfile profile;
    profile.growth = 1.0 / grading;
    return std::shared_ptr<const SizingField>(
        std::make_shared<AttractorSize>(std::move(attractors), profile));
}

}  // namespace

Result<std::shared_ptr<const SizingField>> readSizeFiles(const MeshOptions& options)
{
    std::vector<std::shared_ptr<const SizingField>> fields;
    if (!options.background.empty()) {
        Result<std::shared_ptr<const SizingField>> field = readBackground(options.background);
        if (!field) return field.error();
        fields.push_back(std::move(field).value());
    }
    if (!options.sizePoints.empty()) {
        Result<std::shared_ptr<const SizingField>> field = readPoints(options.sizePoints, options.grading);
        if (!field) return field.error();
        fields.push_back(std::move(field).value());
    }
    if (fields.empty()) return std::shared_ptr<const SizingField>();
    return std::shared_ptr<const SizingField>(std::make_shared<CombinedSize>(std::move(fields)));
}

}  // namespace mesher
