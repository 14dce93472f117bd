#include "compare/compare_options.h"

#include "compare/peer_process.h"

#include <charconv>
#include <cstdio>
#include <sstream>

namespace compare {

namespace {

constexpr const char* kUsage =
    "usage: compare_delaunay [--points N] [--repeats R] [--dimension 2|3|2,3] [--sets NAME,...]\n"
    "                        [--programs mesher,mesher_plain,cgal,tetgen] [--seed S]\n"
    "mesher adds scaffold points to samples of surfaces, mesher_plain never does.\n";

std::vector<std::string> splitAtCommas(const std::string& list)
{
    std::vector<std::string> parts;
    std::istringstream stream(list);
    for (std::string part; std::getline(stream, part, ',');) parts.push_back(part);
    return parts;
}

template <class Number>
bool parseNumber(const std::string& text, Number least, Number& value)
{
    const char* end = text.data() + text.size();
    const std::from_chars_result read = std::from_chars(text.data(), end, value);
    return read.ec == std::errc() && read.ptr == end && value >= least;
}

bool parseDimensions(const std::string& text, std::vector<std::uint32_t>& dimensions)
{
    dimensions.clear();
    for (const std::string& part : splitAtCommas(text)) {
        if (part != "2" && part != "3") return false;
        dimensions.push_back(part == "2" ? 2 : 3);
    }
    return !dimensions.empty();
}

bool parsePrograms(const std::string& text, std::vector<std::string>& programs)
{
    programs = splitAtCommas(text);
    for (const std::string& program : programs) {
        if (!isKnownProgram(program)) return false;
    }
    return !programs.empty();
}

bool parseOption(const std::string& name, const std::string& value, Options& options)
{
    if (name == "--points") return parseNumber(value, std::size_t{1}, options.points);
    if (name == "--repeats") return parseNumber(value, std::size_t{1}, options.repeats);
    if (name == "--seed") return parseNumber(value, std::uint64_t{0}, options.seed);
    if (name == "--dimension") return parseDimensions(value, options.dimensions);
    if (name == "--programs") return parsePrograms(value, options.programs);
    if (name == "--sets") {
        options.sets = splitAtCommas(value);
        return !options.sets.empty();
    }
    return false;
}

}  // namespace

std::vector<std::string> Options::setsOf(std::uint32_t dimension) const
{
    if (!sets.empty()) return sets;
    if (dimension == 2) return {"uniform", "grid"};
    return {"uniform", "torus"};
}

std::optional<Options> parseOptions(const std::vector<std::string>& arguments)
{
    Options options;
    for (std::size_t i = 0; i < arguments.size(); i += 2) {
        if (i + 1 == arguments.size() || !parseOption(arguments[i], arguments[i + 1], options)) {
            std::fprintf(stderr, "compare_delaunay: '%s' is no option or has a wrong value\n%s",
                         arguments[i].c_str(), kUsage);
            return std::nullopt;
        }
    }
    return options;
}

}  // namespace compare
