#include "compare/peer_process.h"

#include <algorithm>
#include <array>
#include <cstdio>
#include <cstdlib>
#include <string_view>

#include <sys/wait.h>
#include <unistd.h>

namespace compare {

namespace {

struct Program
{
    std::string_view name;
    const char* file;
    const char* option;  // before the point file, or null
    bool isTwoDimensional;
};

constexpr std::array kPrograms = {
    Program{"mesher", "delaunay_ours", nullptr, true},
    Program{"mesher_plain", "delaunay_ours", "--plain", false},
    Program{"cgal", "delaunay_peer_cgal", nullptr, true},
    Program{"tetgen", "delaunay_peer_tetgen", nullptr, false},
};

const Program* findProgram(std::string_view name)
{
    const auto* found = std::find_if(kPrograms.begin(), kPrograms.end(),
                                     [name](const Program& program) { return program.name == name; });
    return found == kPrograms.end() ? nullptr : found;
}

/// Everything the process prints, or none if it could not run or did not exit with 0.
std::optional<std::string> outputOf(const std::string& path, const char* option, const std::string& argument)
{
    std::array<int, 2> ends{};
    if (pipe(ends.data()) != 0) return std::nullopt;
    const pid_t child = fork();
    if (child < 0) return std::nullopt;
    if (child == 0) {
        dup2(ends[1], STDOUT_FILENO);
        close(ends[0]);
        close(ends[1]);
        if (option != nullptr) {
            execl(path.c_str(), path.c_str(), option, argument.c_str(), nullptr);
        } else {
            execl(path.c_str(), path.c_str(), argument.c_str(), nullptr);
        }
        std::perror(path.c_str());
        _exit(127);
    }
    close(ends[1]);
    std::string output;
    std::array<char, 4096> buffer{};
    for (ssize_t size = 0; (size = read(ends[0], buffer.data(), buffer.size())) > 0;) {
        output.append(buffer.data(), static_cast<std::size_t>(size));
    }
    close(ends[0]);
    int status = 0;
    if (waitpid(child, &status, 0) != child || !WIFEXITED(status) || WEXITSTATUS(status) != 0)
        return std::nullopt;
    return output;
}

/// The number behind a key of a flat JSON object.
bool readNumber(const std::string& json, const char* key, double& value)
{
    const std::string marker = std::string("\"") + key + "\": ";
    const std::size_t at = json.find(marker);
    if (at == std::string::npos) return false;
    const char* begin = json.c_str() + at + marker.size();
    char* end = nullptr;
    value = std::strtod(begin, &end);
    return end != begin;
}

}  // namespace

bool isKnownProgram(const std::string& program) { return findProgram(program) != nullptr; }

bool supportsDimension(const std::string& program, std::uint32_t dimension)
{
    const Program* found = findProgram(program);
    return found != nullptr && (dimension == 3 || found->isTwoDimensional);
}

std::optional<Report> runProgram(const std::filesystem::path& folder, const std::string& program,
                                 const std::string& pointFile)
{
    const Program* found = findProgram(program);
    if (found == nullptr) return std::nullopt;
    const std::optional<std::string> output =
        outputOf((folder / found->file).string(), found->option, pointFile);
    if (!output) return std::nullopt;
    Report report;
    const bool isComplete = readNumber(*output, "cpu_seconds", report.cpuSeconds) &&
                            readNumber(*output, "vertices", report.vertices) &&
                            readNumber(*output, "simplices", report.simplices) &&
                            readNumber(*output, "bytes_per_simplex", report.bytesPerSimplex) &&
                            readNumber(*output, "scaffold", report.scaffold);
    return isComplete ? std::optional<Report>(report) : std::nullopt;
}

}  // namespace compare
