#pragma once

#include "base/error.h"
#include "base/stop_reason.h"
#include "improvement/improve_mesh.h"
#include "mesh/classified_mesh.h"
#include "pipeline/mesh_options.h"
#include "quality/quality_statistics.h"

#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace mesher {

/// Elements that a run left worse than it was asked for, for one reason at one place.
struct LeftElements
{
    std::string reason;                 ///< a clause without a full stop
    std::vector<std::string> entities;  ///< of the model: what is to blame
    std::uint64_t count = 0;
    double leastAngle = 180.0;  ///< degrees; of tetrahedra the dihedral angle
    double largestAngle = 0.0;
    Vec3 worst;          ///< where the one with the least angle is, model units
    std::string remedy;  ///< a clause without a full stop
    int dimension = 3;   ///< 2: triangles, 3: tetrahedra
};

/// Faces between tetrahedra of a solid that refinement left not locally Delaunay, for one reason at one place.
struct LeftFaces
{
    std::string reason;                 ///< a clause without a full stop
    std::vector<std::string> entities;  ///< of the model: what keeps them from being flipped
    std::uint64_t count = 0;
    Vec3 place;          ///< of one of them, model units
    std::string remedy;  ///< a clause without a full stop
};

/// What a run did, for people and programs.
struct MeshReport
{
    enum class Status
    {
        Done,    ///< a mesh as it was asked for
        Failed,  ///< none, or one that a limit ended
        Cancelled
    };

    Status status = Status::Done;
    StopReason stopReason = StopReason::Done;
    std::vector<Error> failures;
    std::vector<std::string> warnings;
    std::vector<LeftElements> left;      ///< after refinement, those with the most elements first
    std::vector<LeftFaces> nonDelaunay;  ///< after refinement, those with the most faces first
    std::vector<std::pair<std::string, std::uint64_t>> counts;  ///< by stage, in its order
    std::vector<std::pair<std::string, double>> seconds;        ///< by stage, in its order
    /// Of all threads of the process, by stage. Of plane domains only reading and writing are known.
    std::vector<std::pair<std::string, double>> cpuSeconds;
    std::optional<TetQuality> tetQuality;
    std::optional<DihedralRange> anglesBeforeImprovement;
    std::optional<TriangleQuality> triangleQuality;
    std::optional<double> modelArea;  ///< model units squared
    std::optional<double> modelVolume;
    double meshArea = 0.0;
    double meshVolume = 0.0;
    std::uint64_t meshHash = 0;
    std::string modelFile;
    std::string unit = "mm";
    std::vector<std::pair<std::string, std::string>> versions;
    MeshOptions options;
};

/// Fills in the quality, size, hash and numbers of the mesh.
void describeMesh(const ClassifiedMesh& mesh, MeshReport& report);

/// The report as JSON: one object with snake_case keys.
[[nodiscard]] std::string toJson(const MeshReport& report);

}  // namespace mesher
