#include "cli/command_line.h"

#include "mesh/classified_mesh.h"

#include <boost/program_options.hpp>

#include <charconv>
#include <sstream>

namespace mesher {

namespace {

namespace po = boost::program_options;

using Texts = std::vector<std::string>;

Error usageError(const std::string& message, const std::string& remedy = "see mesher --help")
{
    return {ErrorCode::InvalidArgument, message, {}, {}, remedy};
}

/// Numbers are read by from_chars, whatever the locale: "1,5" and "1.5x" are refused.
template <class Number>
Result<Number> numberIn(const std::string& option, const std::string& text)
{
    Number value{};
    const char* last = text.data() + text.size();
    const auto [end, code] = std::from_chars(text.data(), last, value);
    if (code != std::errc() || end != last || text.empty()) {
        return usageError(
            std::string("--").append(option).append(" wants a number, not '").append(text).append("'"));
    }
    return value;
}

po::options_description meshingOptions()
{
    po::options_description options("Options of mesh and estimate", 100);
    auto add = options.add_options();
    add("dimension", po::value<std::string>(), "2: plane faces, 3: solids (default 3)");
    add("size", po::value<std::string>(), "largest edge length, model units");
    add("min-size", po::value<std::string>(), "no smaller size is asked for");
    add("curvature", po::value<std::string>(), "elements in a full turn of a curve (default 0: off)");
    add("sag", po::value<std::string>(), "largest distance of an edge from its curve (default 0: off)");
    add("refinement", po::value<std::string>(),
        "R: boundary size is local feature size / R, 1 or more (default 1)");
    add("grading", po::value<std::string>(), "G: sizes grow by at most distance / G (default 1)");
    add("local-size", po::value<Texts>()->composing(), "size of one entity, e.g. Face6=0.5; may be repeated");
    add("background", po::value<std::string>(), "mesh (.msh, .vtu) with the size at each node");
    add("min-angle", po::value<std::string>(), "of triangles, degrees, 0 to 45 (default 30)");
    add("max-turn", po::value<std::string>(), "of a curve along an edge, degrees, 30 to 90 (default 90)");
    add("measure", po::value<std::string>(), "of tetrahedra, q1 to q8 (default q2)");
    add("threshold", po::value<std::string>(), "score below which a tetrahedron is refined");
    add("no-improve", po::bool_switch(), "leave out the improvement at the end");
    add("order", po::value<std::string>(), "of elements, 1 or 2 (default 1)");
    add("threads", po::value<std::string>(), "the mesh does not depend on it (default 1)");
    add("max-elements", po::value<std::string>(), "the run ends there (default 50000000)");
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
    add("report", po::value<std::string>(), "JSON file that tells what was done");
    add("curved-boundary", po::value<std::string>(),
        "JSON file with Gauss points on the exact boundary curves");
    add("boundary-order", po::value<std::string>(), "order of accuracy they are for, 2 to 4 (default 4)");
    add("check", po::bool_switch(), "check the mesh as a whole before it is written");
    add("keep-partial", po::bool_switch(), "write what there is when a limit ends the run");
    return options;
}

/// Parses, with one positional argument under the name `input`.
Result<po::variables_map> parse(std::span<const std::string> arguments, po::options_description visible)
{
    visible.add_options()("input", po::value<Texts>()->composing());
    po::positional_options_description positional;
    positional.add("input", -1);
    po::variables_map found;
    try {
        const auto style = po::command_line_style::default_style & ~po::command_line_style::allow_guessing;
        const Texts texts(arguments.begin(), arguments.end());
        po::store(po::command_line_parser(texts).options(visible).positional(positional).style(style).run(),
                  found);
        po::notify(found);
    } catch (const po::error& error) {
        return usageError(error.what());
    }
    return found;
}

Result<std::filesystem::path> onlyInput(const po::variables_map& found, const std::string& what)
{
    const Texts inputs = found.count("input") != 0 ? found["input"].as<Texts>() : Texts();
    if (inputs.empty()) return usageError(std::string("the ").append(what).append(" is missing"));
    if (inputs.size() > 1)
        return usageError(std::string("one ")
                              .append(what)
                              .append(" is expected, '")
                              .append(inputs[1])
                              .append("' is too much"));
    if (inputs.front().empty())
        return usageError(std::string("the name of the ").append(what).append(" is empty"));
    return std::filesystem::path(inputs.front());
}

/// Reads the values of options into variables; the first error is kept.
class ValueReader
{
public:
    explicit ValueReader(const po::variables_map& found) : found_(found) {}

    template <class Number>
    void read(const char* option, Number& target)
    {
        if (std::optional<Number> value = numberOf<Number>(option)) target = *value;
    }
    template <class Number>
    void read(const char* option, std::optional<Number>& target)
    {
        if (std::optional<Number> value = numberOf<Number>(option)) target = *value;
    }
    void read(const char* option, std::string& target)
    {
        if (found_.count(option) != 0) target = found_[option].as<std::string>();
    }
    [[nodiscard]] bool isSet(const char* option) const { return found_[option].as<bool>(); }
    [[nodiscard]] std::optional<std::filesystem::path> path(const char* option)
    {
        if (found_.count(option) == 0) return std::nullopt;
        return std::filesystem::path(found_[option].as<std::string>());
    }
    [[nodiscard]] Texts texts(const char* option) const
    {
        return found_.count(option) != 0 ? found_[option].as<Texts>() : Texts();
    }
    void fail(Error error)
    {
        if (!error_) error_ = std::move(error);
    }
    [[nodiscard]] const std::optional<Error>& error() const { return error_; }

private:
    template <class Number>
    std::optional<Number> numberOf(const char* option)
    {
        if (found_.count(option) == 0) return std::nullopt;
        const Result<Number> number = numberIn<Number>(option, found_[option].as<std::string>());
        if (number) return number.value();
        fail(number.error());
        return std::nullopt;
    }

    const po::variables_map& found_;
    std::optional<Error> error_;
};

void readLocalSizes(ValueReader& reader, MeshOptions& options)
{
    for (const std::string& text : reader.texts("local-size")) {
        const std::size_t equals = text.find('=');
        const std::string entity = text.substr(0, equals);
        if (equals == std::string::npos || !entityNamed(entity)) {
            reader.fail(
                usageError("--local-size wants an entity and a size like Face6=0.5, not '" + text + "'"));
            return;
        }
        const Result<double> size = numberIn<double>("local-size", text.substr(equals + 1));
        if (!size) {
            reader.fail(size.error());
            return;
        }
        options.localSizes.push_back({entity, size.value()});
    }
}

void readMeshOptions(ValueReader& reader, MeshOptions& options)
{
    reader.read("dimension", options.dimension);
    reader.read("size", options.size);
    reader.read("min-size", options.minSize);
    reader.read("curvature", options.curvature);
    reader.read("sag", options.sag);
    reader.read("refinement", options.refinement);
    reader.read("grading", options.grading);
    readLocalSizes(reader, options);
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
    options.isImproved = !reader.isSet("no-improve");
    reader.read("order", options.order);
    reader.read("threads", options.threads);
    reader.read("max-elements", options.maxElements);
    reader.read("timeout", options.timeout);
}

void readOutputs(ValueReader& reader, MeshCommand& command)
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

Error namedTwice(const std::filesystem::path& path)
{
    return {ErrorCode::InvalidArgument,
            "the file is named twice",
            path.string(),
            {},
            "give each file another name"};
}

/// Two files of the same name would overwrite each other, or the model.
void refuseSameFiles(ValueReader& reader, const MeshCommand& command)
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

}  // namespace

Result<MeshCommand> parseMeshCommand(std::span<const std::string> arguments)
{
    const Result<po::variables_map> found = parse(arguments, meshingOptions().add(outputOptions()));
    if (!found) return found.error();
    const Result<std::filesystem::path> model = onlyInput(found.value(), "model");
    if (!model) return model.error();
    ValueReader reader(found.value());
    MeshCommand command;
    command.model = model.value();
    readMeshOptions(reader, command.options);
    readOutputs(reader, command);
    command.report = reader.path("report");
    command.curvedBoundary = reader.path("curved-boundary");
    reader.read("boundary-order", command.boundaryOrder);
    if (command.boundaryOrder < 2 || command.boundaryOrder > 4) {
        reader.fail(usageError("--boundary-order is 2, 3 or 4"));
    }
    command.options.isChecked = reader.isSet("check");
    command.keepsPartial = reader.isSet("keep-partial");
    command.heals = reader.isSet("heal");
    refuseSameFiles(reader, command);
    if (reader.error()) return *reader.error();
    if (const Result<void> valid = validate(command.options); !valid) return valid.error();
    return command;
}

Result<MeshCommand> parseEstimateCommand(std::span<const std::string> arguments)
{
    const Result<po::variables_map> found = parse(arguments, meshingOptions());
    if (!found) return found.error();
    const Result<std::filesystem::path> model = onlyInput(found.value(), "model");
    if (!model) return model.error();
    ValueReader reader(found.value());
    MeshCommand command;
    command.model = model.value();
    readMeshOptions(reader, command.options);
    command.heals = reader.isSet("heal");
    if (reader.error()) return *reader.error();
    if (const Result<void> valid = validate(command.options); !valid) return valid.error();
    return command;
}

Result<CheckCommand> parseCheckCommand(std::span<const std::string> arguments)
{
    po::options_description options;
    options.add_options()("model", po::value<std::string>())("report", po::value<std::string>());
    const Result<po::variables_map> found = parse(arguments, options);
    if (!found) return found.error();
    const Result<std::filesystem::path> mesh = onlyInput(found.value(), "mesh");
    if (!mesh) return mesh.error();
    ValueReader reader(found.value());
    return CheckCommand{mesh.value(), reader.path("model"), reader.path("report")};
}

Result<InfoCommand> parseInfoCommand(std::span<const std::string> arguments)
{
    po::options_description options;
    options.add_options()("json", po::bool_switch());
    const Result<po::variables_map> found = parse(arguments, options);
    if (!found) return found.error();
    const Result<std::filesystem::path> model = onlyInput(found.value(), "model");
    if (!model) return model.error();
    return InfoCommand{model.value(), found.value()["json"].as<bool>()};
}

Result<DrawCommand> parseDrawCommand(std::span<const std::string> arguments)
{
    po::options_description options;
    options.add_options()("output,o", po::value<std::string>())("width", po::value<std::string>());
    const Result<po::variables_map> found = parse(arguments, options);
    if (!found) return found.error();
    const Result<std::filesystem::path> mesh = onlyInput(found.value(), "mesh");
    if (!mesh) return mesh.error();
    ValueReader reader(found.value());
    DrawCommand command;
    command.mesh = mesh.value();
    const std::optional<std::filesystem::path> picture = reader.path("output");
    if (!picture) return usageError("the output is missing", "give -o PICTURE.png");
    command.picture = *picture;
    reader.read("width", command.width);
    if (reader.error()) return *reader.error();
    return command;
}

std::string usageText()
{
    std::ostringstream text;
    text << "mesher: Delaunay meshes of CAD models\n\n"
            "  mesher mesh MODEL -o FILE [-o FILE …] [options]   mesh a model (STEP, IGES, BREP)\n"
            "  mesher info MODEL [--json]                        what the model is made of\n"
            "  mesher check MESH [--model MODEL] [--report FILE] check a mesh (.msh, .vtu) independently\n"
            "  mesher estimate MODEL [options]                   elements, memory and time before meshing\n"
            "  mesher draw MESH -o PICTURE.png [--width PIXELS]  picture of a mesh\n"
            "  mesher formats                                    the formats of -o and --format\n"
            "  mesher --version | --help\n\n"
         << meshingOptions() << '\n'
         << outputOptions()
         << "\nExit status: 0 done, 1 could not mesh or ran into a limit, 2 wrong usage, 130 cancelled.\n";
    return text.str();
}

}  // namespace mesher
