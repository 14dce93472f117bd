#include "io/read_size_fields.h"

#include "io/mesh_reader.h"
#include "sizing/attractor_size.h"
#include "sizing/background_size.h"
#include "sizing/combined_size.h"

#include <utility>
#include <vector>

namespace mesher {

Result<std::shared_ptr<const SizingField>> readBackgroundField(const std::string& path)
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

std::shared_ptr<const SizingField> fieldOfPoints(const std::vector<SizePoint>& points, double grading)
{
    std::vector<Attractor> attractors;
    for (const SizePoint& point : points) attractors.push_back({point.position, point.position, point.size});
    DistanceProfile profile;
    profile.growth = 1.0 / grading;
    return std::make_shared<AttractorSize>(std::move(attractors), profile);
}

Result<std::shared_ptr<const SizingField>> readSizeFields(const std::string& background,
                                                          const std::string& points, double grading)
{
    std::vector<std::shared_ptr<const SizingField>> fields;
    if (!background.empty()) {
        Result<std::shared_ptr<const SizingField>> field = readBackgroundField(background);
        if (!field) return field.error();
        fields.push_back(std::move(field).value());
    }
    if (!points.empty()) {
        const Result<std::vector<SizePoint>> read = readSizePoints(points);
        if (!read) return read.error();
        fields.push_back(fieldOfPoints(read.value(), grading));
    }
    if (fields.empty()) return std::shared_ptr<const SizingField>();
    return std::shared_ptr<const SizingField>(std::make_shared<CombinedSize>(std::move(fields)));
}

}  // namespace mesher
