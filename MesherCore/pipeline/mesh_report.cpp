#include "pipeline/mesh_report.h"

#include "mesh/classified_mesh_hash.h"

#include <nlohmann/json.hpp>

namespace mesher {

namespace {

using Json = nlohmann::ordered_json;

std::string_view nameOf(MeshReport::Status status)
{
    switch (status) {
        case MeshReport::Status::Done: return "done";
        case MeshReport::Status::Failed: return "failed";
        case MeshReport::Status::Cancelled: return "cancelled";
    }
    return "";
}

/// Sixteen hexadecimal digits: JSON's numbers are doubles to many readers.
std::string hexadecimal(std::uint64_t value)
{
    std::string digits(16, '0');
    for (std::size_t i = digits.size(); i > 0; --i, value >>= 4)
        digits[i - 1] = "0123456789abcdef"[value & 15u];
    return digits;
}

template <class T>
Json orNull(const std::optional<T>& value)
{
    return value ? Json(*value) : Json(nullptr);
}

template <class Pairs>
Json objectOf(const Pairs& pairs)
{
    Json object = Json::object();
    for (const auto& [key, value] : pairs) object[key] = value;
    return object;
}

Json toJson(const Vec3& p) { return {p.x, p.y, p.z}; }

Json toJson(const Error& error)
{
    Json json = {
        {"entity", error.entity}, {"point", nullptr}, {"reason", error.message}, {"remedy", error.remedy}};
    if (error.point) json["point"] = toJson(*error.point);
    return json;
}

Json toJson(const LeftElements& left)
{
    return {{"entities", left.entities},
            {"reason", left.reason},
            {"count", left.count},
            {left.dimension == 3 ? "min_dihedral" : "min_angle", left.leastAngle},
            {left.dimension == 3 ? "max_dihedral" : "max_angle", left.largestAngle},
            {"point", toJson(left.worst)},
            {"remedy", left.remedy}};
}

Json toJson(const LeftFaces& left)
{
    return {{"entities", left.entities},
            {"reason", left.reason},
            {"count", left.count},
            {"point", toJson(left.place)},
            {"remedy", left.remedy}};
}

/// The places where most was left; the others in one entry, so that the report stays short.
template <class Left>
Json toJson(const std::vector<Left>& left)
{
    constexpr std::size_t kMostPlaces = 50;
    Json places = Json::array();
    std::uint64_t total = 0;
    std::uint64_t listed = 0;
    for (const Left& place : left) {
        total += place.count;
        if (places.size() >= kMostPlaces) continue;
        listed += place.count;
        places.push_back(toJson(place));
    }
    return {{"count", total}, {"not_listed", total - listed}, {"places", places}};
}

/// The sizes that may be given more than once.
void addWishes(const MeshOptions& options, Json& json)
{
    for (const LocalSize& local : options.localSizes) json["local_sizes"][local.entity] = local.size;
    for (const SizeByDistance& wish : options.distanceSizes) {
        json["size_distance"].push_back({{"entity", wish.entity},
                                         {"size", wish.size},
                                         {"growth", wish.growth},
                                         {"plateau", wish.plateau}});
    }
    for (const SizeInBox& box : options.boxSizes) {
        json["size_box"].push_back({{"first", toJson(box.first)},
                                    {"last", toJson(box.last)},
                                    {"size", box.size},
                                    {"growth", box.growth.value_or(1.0 / options.grading)}});
    }
    for (const SizeInBall& ball : options.ballSizes) {
        json["size_ball"].push_back({{"centre", toJson(ball.centre)},
                                     {"radius", ball.radius},
                                     {"size", ball.size},
                                     {"growth", ball.growth.value_or(1.0 / options.grading)}});
    }
}

Json toJson(const MeshOptions& options)
{
    Json json = {{"dimension", options.dimension},
                 {"faces", options.faces},
                 {"size", orNull(options.size)},
                 {"min_size", orNull(options.minSize)},
                 {"curvature", options.curvature},
                 {"sag", options.sag},
                 {"refinement", orNull(options.refinement)},
                 {"grading", options.grading},
                 {"local_sizes", Json::object()},
                 {"size_distance", Json::array()},
                 {"size_box", Json::array()},
                 {"size_ball", Json::array()},
                 {"size_formula", options.sizeFormula},
                 {"size_points", options.sizePoints},
                 {"background", options.background},
                 {"min_angle", options.minAngle},
                 {"max_turn", options.maxTurn},
                 {"measure", infoOf(options.measure).key},
                 {"threshold", options.threshold.value_or(infoOf(options.measure).threshold)},
                 {"max_dihedral", options.maxDihedral.value_or(infoOf(options.measure).largestDihedral)},
                 {"lambda", options.lambda.value_or(infoOf(options.measure).lambda)},
                 {"improve", options.isImproved},
                 {"order", options.order},
                 {"threads", options.threads},
                 {"max_elements", options.maxElements},
                 {"max_wall_elements", orNull(options.maxWallElements)},
                 {"timeout", orNull(options.timeout)},
                 {"check", options.isChecked}};
    // By default it is not spoken of, so that a report with the word in it is one of solids that do overlap.
    if (options.overlap != MeshOptions{}.overlap) json["overlap"] = nameOf(options.overlap);
    addWishes(options, json);
    return json;
}

Json qualityOf(const TetQuality& quality, const MeshOptions& options)
{
    return {{"min_dihedral", quality.dihedral.least()},
            {"max_dihedral", quality.dihedral.largest()},
            {"dihedral_histogram", quality.dihedralHistogram},
            {"min_radius_ratio", quality.radiusRatio.least()},
            {"mean_radius_ratio", quality.radiusRatio.mean()},
            {"min_volume_ratio", quality.volumeRatio.least()},
            {"measure", infoOf(options.measure).key},
            {"threshold", options.threshold.value_or(infoOf(options.measure).threshold)}};
}

Json qualityOf(const TriangleQuality& quality, const MeshOptions& options)
{
    return {{"min_angle", quality.angle.least()},
            {"max_angle", quality.angle.largest()},
            {"angle_histogram", quality.angleHistogram},
            {"min_radius_ratio", quality.radiusRatio.least()},
            {"mean_radius_ratio", quality.radiusRatio.mean()},
            {"shortest_edge", quality.shortestEdge},
            {"longest_edge", quality.longestEdge},
            {"measure", "angle"},
            {"threshold", options.minAngle}};
}

}  // namespace

void describeMesh(const ClassifiedMesh& mesh, MeshReport& report)
{
    report.meshHash = classifiedMeshHash(mesh);
    report.unit = mesh.unit;
    report.counts.emplace_back("vertices", mesh.nodes.size());
    report.counts.emplace_back("lines", mesh.lines.size());
    report.counts.emplace_back("triangles", mesh.triangles.size());
    report.counts.emplace_back("tets", mesh.tets.size());
    if (!mesh.triangles.empty()) {
        report.triangleQuality = triangleQualityOf(mesh);
        report.meshArea = report.triangleQuality->area.mean() * static_cast<double>(mesh.triangles.size());
    }
    if (!mesh.tets.empty()) {
        report.tetQuality = tetQualityOf(mesh);
        report.meshVolume = report.tetQuality->volume.mean() * static_cast<double>(mesh.tets.size());
    }
}

std::string toJson(const MeshReport& report)
{
    Json json = {{"status", nameOf(report.status)},
                 {"stop_reason", nameOf(report.stopReason)},
                 {"failures", Json::array()},
                 {"warnings", report.warnings},
                 {"left", toJson(report.left)},
                 {"not_delaunay", toJson(report.nonDelaunay)},
                 {"counts", objectOf(report.counts)},
                 {"seconds", objectOf(report.seconds)},
                 {"cpu_seconds", objectOf(report.cpuSeconds)},
                 {"quality", nullptr},
                 {"model",
                  {{"file", report.modelFile},
                   {"unit", report.unit},
                   {"area", orNull(report.modelArea)},
                   {"volume", orNull(report.modelVolume)}}},
                 {"mesh", {{"area", report.meshArea}, {"volume", report.meshVolume}}},
                 {"mesh_hash", hexadecimal(report.meshHash)},
                 {"versions", objectOf(report.versions)},
                 {"options", toJson(report.options)}};
    for (const Error& failure : report.failures) json["failures"].push_back(toJson(failure));
    if (report.tetQuality) {
        json["quality"] = qualityOf(*report.tetQuality, report.options);
        if (const auto& before = report.anglesBeforeImprovement) {
            json["quality"]["before_improvement"] = {{"min_dihedral", before->least},
                                                     {"max_dihedral", before->largest}};
        }
    } else if (report.triangleQuality) {
        json["quality"] = qualityOf(*report.triangleQuality, report.options);
    }
    // What is no UTF-8 (a path may hold anything) is replaced, not thrown at.
    return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace mesher
