#pragma once

#include "base/result.h"
#include "io/draw_png.h"
#include "io/write_options.h"
#include "pipeline/mesh_options.h"

#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace mesher {

/// A file to write; an empty format means that of the extension.
struct OutputTarget
{
    std::filesystem::path path;
    std::string format;
};

struct MeshCommand
{
    std::filesystem::path model;
    std::vector<OutputTarget> outputs;
    std::optional<std::filesystem::path> report;
    std::optional<std::filesystem::path> curvedBoundary;
    int boundaryOrder = 4;
    WriteOptions writing;
    bool keepsPartial = false;
    bool heals = false;
    MeshOptions options;
};

struct CheckCommand
{
    std::filesystem::path mesh;
    std::optional<std::filesystem::path> model;
    std::optional<std::filesystem::path> report;
};

struct InfoCommand
{
    std::filesystem::path model;
    bool isJson = false;
};

struct DrawCommand
{
    std::filesystem::path mesh;
    std::filesystem::path picture;
    DrawingOptions options;
};

/// Each takes the arguments behind the name of the command, and refuses what it does not know or what makes no sense with
/// ErrorCode::InvalidArgument.
[[nodiscard]] Result<MeshCommand> parseMeshCommand(std::span<const std::string> arguments);
/// The model and the options of `mesh` that matter before meshing.
[[nodiscard]] Result<MeshCommand> parseEstimateCommand(std::span<const std::string> arguments);
[[nodiscard]] Result<CheckCommand> parseCheckCommand(std::span<const std::string> arguments);
[[nodiscard]] Result<InfoCommand> parseInfoCommand(std::span<const std::string> arguments);
[[nodiscard]] Result<DrawCommand> parseDrawCommand(std::span<const std::string> arguments);

/// How to call the program, with all options.
[[nodiscard]] std::string usageText();

}  // namespace mesher
