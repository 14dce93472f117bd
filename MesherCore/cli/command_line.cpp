#include "cli/command_line.h"

#include "cli/option_reader.h"
#include "cli/size_syntax.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <sstream>
#include <utility>

namespace mesher {

namespace {

namespace po = boost::program_options;

using Texts = std::vector<std::string>;

po::options_description meshingOptions()
{
    po::options_description options("Options of mesh and estimate", 100);
    auto add = options.add_options();
    add("dimension", po::value<std::string>(), "2: faces, 3: solids (default 3)");
    add("faces", po::value<std::string>(), "with --dimension 2: only these, e.g. Face1,Face6 (default all)");
    add("size", po::value<std::string>(), "mean edge on surfaces where nothing asks for less, model units");
    add("min-size", po::value<std::string>(), "no smaller size is asked for");
    add("curvature", po::value<std::string>(), "elements in a full turn of a curve (default 0: off)");
    add("sag", po::value<std::string>(), "largest distance of an edge from its curve (default 0: off)");
    add("refinement", po::value<std::string>(),
        "R: boundary size is local feature size / R, 1 or more (default 1 on plane faces, off in space)");
    add("grading", po::value<std::string>(), "G: sizes grow by at most distance / G (default 1)");
    add("local-size", po::value<Texts>()->composing(),
        "ENTITY=SIZE: size in a solid or on a face, edge or vertex, e.g. Face6=0.5; beyond it sizes grow by "
        "distance / G");
    add("size-distance", po::value<Texts>()->composing(),
        "ENTITY=SIZE,GROWTH[,PLATEAU]: size up to the distance PLATEAU (default 0) from a solid, face, edge "
        "or vertex, growing by GROWTH per unit of distance from there on");
    add("size-box", po::value<Texts>()->composing(),
        "X0,Y0,Z0,X1,Y1,Z1=SIZE[,GROWTH]: size in the box between two corners, growing outside of it "
        "(default "
        "GROWTH 1 / G)");
    add("size-ball", po::value<Texts>()->composing(), "X,Y,Z,RADIUS=SIZE[,GROWTH]: the same in a ball");
    add("size-formula", po::value<std::string>(),
        "size by x, y, z with + - * / ^ ( ) pi sqrt abs exp log sin cos tan min max, e.g. \"0.1 + 0.05*x\"");
    add("size-points", po::value<std::string>(),
        "text file with a line 'x y z size' for each point; sizes grow by distance / G from them");
    add("background", po::value<std::string>(), "mesh (.msh, .vtu) with the size at each node");
    add("min-angle", po::value<std::string>(),
        "of triangles, degrees, 0 to 45; above 33 it is seldom reached, and 30 is kept then (default 30)");
    add("max-turn", po::value<std::string>(), "of a curve along an edge, degrees, 30 to 90 (default 90)");
    add("measure", po::value<std::string>(), "of tetrahedra, q1 to q8 (default q2)");
    add("threshold", po::value<std::string>(), "score below which a tetrahedron is refined");
    add("max-dihedral", po::value<std::string>(),
        "angle above which a tetrahedron is refined whatever it scores, degrees, 120 to 180 (default 155; "
        "off for q1, q5, q7)");
    add("lambda", po::value<std::string>(),
        "how far below the sizes around them bad tetrahedra are refined before all else is done, 1 or more "
        "(default 5)");
    add("no-improve", po::bool_switch(), "leave out the improvement at the end");
    add("order", po::value<std::string>(), "of elements, 1 or 2 (default 1)");
    add("threads", po::value<std::string>(), "the mesh does not depend on it (default 1)");
    add("max-elements", po::value<std::string>(), "the run ends there (default 50000000)");
    add("overlap", po::value<std::string>(),
        "of solids: separate meshes each for itself, with a warning, refuse fails the run (default "
        "separate)");
    add("max-wall-elements", po::value<std::string>(),
        "that thin walls, gaps and cusps may take, and faces far narrower than the sizes; those that take "
        "more "
        "get flat ones (default: about as many as the sizes ask for)");
    add("timeout", po::value<std::string>(), "seconds after which the run ends");
    add("heal", po::bool_switch(), "let the CAD kernel repair the model first");
    return options;
}

po::options_description outputOptions()
{
    po::options_description options("Options of mesh", 100);
    auto add = options.add_options();
    add("output,o", po::value<Texts>()->composing(), "file to write; may be repeated");
    add("format", po::value<Texts>()->composing(),
        "of the first, second, … output; else that of its extension");
    add("groups", po::value<std::string>(),
        "in .msh and .unv: bounding for solids and faces (of faces: faces and edges), or all for edges and "
        "vertices too "
        "(default bounding)");
    add("report", po::value<std::string>(), "JSON file that tells what was done");
    add("curved-boundary", po::value<std::string>(),
        "JSON file with Gauss points on the exact boundary curves of plane faces");
    add("boundary-order", po::value<std::string>(), "order of accuracy they are for, 2 to 4 (default 4)");
    add("check", po::bool_switch(), "check the mesh as a whole before it is written");
    add("keep-partial", po::bool_switch(), "write what there is of a mesh when the run ends early or fails");
    return options;
}

void readMeshOptions(OptionReader& reader, MeshOptions& options)
{
    reader.read("dimension", options.dimension);
    std::string faces;
    reader.read("faces", faces);
    if (!faces.empty()) options.faces = splitAtCommas(faces);
    reader.read("size", options.size);
    reader.read("min-size", options.minSize);
    reader.read("curvature", options.curvature);
    reader.read("sag", options.sag);
    reader.read("refinement", options.refinement);
    reader.read("grading", options.grading);
    reader.readAll("local-size", options.localSizes, localSizeIn);
    reader.readAll("size-distance", options.distanceSizes, sizeByDistanceIn);
    reader.readAll("size-box", options.boxSizes, sizeInBoxIn);
    reader.readAll("size-ball", options.ballSizes, sizeInBallIn);
    reader.read("size-formula", options.sizeFormula);
    reader.read("size-points", options.sizePoints);
    reader.read("background", options.background);
    reader.read("min-angle", options.minAngle);
    reader.read("max-turn", options.maxTurn);
    std::string measure(infoOf(options.measure).key);
    reader.read("measure", measure);
    if (const std::optional<TetMeasure> known = tetMeasureOf(measure)) {
        options.measure = *known;
    } else {
        reader.fail(usageError("--measure wants one of q1 to q8, not '" + measure + "'"));
    }
    reader.read("threshold", options.threshold);
    reader.read("max-dihedral", options.maxDihedral);
    reader.read("lambda", options.lambda);
    options.isImproved = !reader.isSet("no-improve");
    reader.read("order", options.order);
    reader.read("threads", options.threads);
    reader.read("max-elements", options.maxElements);
    reader.read("max-wall-elements", options.maxWallElements);
    std::string overlap(nameOf(options.overlap));
    reader.read("overlap", overlap);
    const std::optional<OverlapChoice> choice = overlapChoiceOf(overlap);
    if (!choice) reader.fail(usageError("--overlap is separate or refuse, not '" + overlap + "'"));
    options.overlap = choice.value_or(OverlapChoice::Separate);
    reader.read("timeout", options.timeout);
}

void readOutputs(OptionReader& reader, MeshCommand& command)
{
    const Texts paths = reader.texts("output");
    const Texts formats = reader.texts("format");
    if (paths.empty()) reader.fail(usageError("the output is missing", "give at least one -o FILE"));
    if (formats.size() > paths.size()) {
        reader.fail(
            usageError("there are more --format than outputs", "give one for each -o, in their order"));
        return;
    }
    for (std::size_t i = 0; i < paths.size(); ++i) {
        command.outputs.push_back({paths[i], i < formats.size() ? formats[i] : std::string()});
    }
}

void readGroups(OptionReader& reader, WriteOptions& writing)
{
    std::string name = "bounding";
    reader.read("groups", name);
    const std::optional<GroupChoice> groups = groupChoiceOf(name);
    if (!groups) reader.fail(usageError("--groups is bounding or all, not '" + name + "'"));
    writing.groups = groups.value_or(GroupChoice::Bounding);
}

Error namedTwice(const std::filesystem::path& path)
{
    return {ErrorCode::InvalidArgument,
            "the file is named twice",
            path.string(),
            {},
            "give each file another name"};
}

/// Two files of the same name would overwrite each other, or the model.
void refuseSameFiles(OptionReader& reader, const MeshCommand& command)
{
    std::vector<std::filesystem::path> written;
    for (const OutputTarget& output : command.outputs) written.push_back(output.path);
    if (command.report) written.push_back(*command.report);
    if (command.curvedBoundary) written.push_back(*command.curvedBoundary);
    std::vector<std::filesystem::path> seen = {command.model.lexically_normal()};
    for (const std::filesystem::path& path : written) {
        for (const std::filesystem::path& other : seen) {
            std::error_code code;
            // Devices like /dev/null may well be named twice.
            const bool isDevice =
                std::filesystem::exists(path, code) && !std::filesystem::is_regular_file(path, code);
            const bool isSame =
                other == path.lexically_normal() || std::filesystem::equivalent(other, path, code);
            if (isSame && !isDevice) reader.fail(namedTwice(path));
        }
        seen.push_back(path.lexically_normal());
    }
}

/// What mesh and estimate have in common.
MeshCommand modelAndOptions(OptionReader& reader)
{
    MeshCommand command;
    command.model = reader.onlyInput("model");
    readMeshOptions(reader, command.options);
    command.heals = reader.isSet("heal");
    return command;
}

Result<MeshCommand> validated(const OptionReader& reader, MeshCommand command)
{
    if (reader.error()) return *reader.error();
    if (const Result<void> valid = validate(command.options); !valid) return valid.error();
    return command;
}

/// "no", or an axis with or without a coordinate.
void readCut(OptionReader& reader, const std::string& text, DrawingOptions& options)
{
    options.part = text == "no" ? DrawnPart::Surface : DrawnPart::Cut;
    if (text == "no") return;
    const std::size_t axis = std::string("xyz").find(text.front());
    const char* last = text.data() + text.size();
    double at = 0.0;
    const bool hasCoordinate = text.size() > 1;
    bool isSound = axis != std::string::npos;
    if (hasCoordinate) {
        const auto [end, code] =
            std::from_chars(text.data() + std::min<std::size_t>(2, text.size()), last, at);
        isSound = isSound && text[1] == '=' && code == std::errc() && end == last && std::isfinite(at);
        options.cutAt = at;
    }
    options.cutAxis = axis;
    if (!isSound)
        reader.fail(
            usageError("--cut wants no, x, y, z or an axis and a place, like x=2.5, not '" + text + "'"));
}

/// For the commands of few options.
template <class Command, class Read>
Result<Command> parseBy(std::span<const std::string> arguments, const po::options_description& options,
                        Read read)
{
    const Result<po::variables_map> found = parseArguments(arguments, options);
    if (!found) return found.error();
    OptionReader reader(found.value());
    Command command = read(reader);
    if (reader.error()) return *reader.error();
    return command;
}

}  // namespace

Result<MeshCommand> parseMeshCommand(std::span<const std::string> arguments)
{
    const Result<po::variables_map> found = parseArguments(arguments, meshingOptions().add(outputOptions()));
    if (!found) return found.error();
    OptionReader reader(found.value());
    MeshCommand command = modelAndOptions(reader);
    readOutputs(reader, command);
    readGroups(reader, command.writing);
    command.report = reader.path("report");
    command.curvedBoundary = reader.path("curved-boundary");
    reader.read("boundary-order", command.boundaryOrder);
    if (command.boundaryOrder < 2 || command.boundaryOrder > 4) {
        reader.fail(usageError("--boundary-order is 2, 3 or 4"));
    }
    if (command.curvedBoundary && command.options.dimension == 3) {
        reader.fail(usageError("--curved-boundary is of plane faces, not of solids",
                               "leave it out, or mesh plane faces with --dimension 2"));
    }
    command.options.isChecked = reader.isSet("check");
    command.keepsPartial = reader.isSet("keep-partial");
    refuseSameFiles(reader, command);
    return validated(reader, std::move(command));
}

Result<MeshCommand> parseEstimateCommand(std::span<const std::string> arguments)
{
    const Result<po::variables_map> found = parseArguments(arguments, meshingOptions());
    if (!found) return found.error();
    OptionReader reader(found.value());
    MeshCommand command = modelAndOptions(reader);
    return validated(reader, std::move(command));
}

Result<CheckCommand> parseCheckCommand(std::span<const std::string> arguments)
{
    po::options_description options;
    options.add_options()("model", po::value<std::string>())("report", po::value<std::string>());
    return parseBy<CheckCommand>(arguments, options, [](OptionReader& reader) {
        return CheckCommand{reader.onlyInput("mesh"), reader.path("model"), reader.path("report")};
    });
}

Result<InfoCommand> parseInfoCommand(std::span<const std::string> arguments)
{
    po::options_description options;
    options.add_options()("json", po::bool_switch());
    return parseBy<InfoCommand>(arguments, options, [](OptionReader& reader) {
        return InfoCommand{reader.onlyInput("model"), reader.isSet("json")};
    });
}

Result<DrawCommand> parseDrawCommand(std::span<const std::string> arguments)
{
    po::options_description options;
    options.add_options()("output,o", po::value<std::string>())("width", po::value<std::string>())(
        "cut", po::value<std::string>());
    return parseBy<DrawCommand>(arguments, options, [](OptionReader& reader) {
        DrawCommand command;
        command.mesh = reader.onlyInput("mesh");
        const std::optional<std::filesystem::path> picture = reader.path("output");
        if (!picture) reader.fail(usageError("the output is missing", "give -o PICTURE.png"));
        command.picture = picture.value_or(std::filesystem::path());
        reader.read("width", command.options.width);
        std::string cut;
        reader.read("cut", cut);
        if (!cut.empty()) readCut(reader, cut, command.options);
        return command;
    });
}

std::string usageText()
{
    std::ostringstream text;
    text << "mesher: Delaunay meshes of CAD models\n\n"
            "  mesher mesh MODEL -o FILE [-o FILE …] [options]   mesh a model (STEP, IGES, BREP)\n"
            "  mesher info MODEL [--json]                        what the model is made of\n"
            "  mesher check MESH [--model MODEL] [--report FILE] check a mesh (.msh, .vtu) independently\n"
            "  mesher estimate MODEL [options]                   elements, memory and time before meshing\n"
            "  mesher draw MESH -o PICTURE.png [--width PIXELS] [--cut no|AXIS[=PLACE]]\n"
            "                                                    picture of a mesh; --cut: the surface "
            "alone, or the\n"
            "                                                    elements beyond a plane (x, y=2.5) instead "
            "of both\n"
            "  mesher formats                                    the formats of -o and --format\n"
            "  mesher --version | --help\n\n"
         << meshingOptions() << '\n'
         << outputOptions()
         << "\nWhere several sizes are asked for the smallest holds. Lengths are in model units, and the "
            "options "
            "of the form\nENTITY=… or …=SIZE may be repeated.\n"
            "\nExit status: 0 done, 1 could not mesh or ran into a limit, 2 wrong usage, 130 cancelled.\n";
    return text.str();
}

}  // namespace mesher
