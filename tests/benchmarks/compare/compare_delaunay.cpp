// Times Delaunay triangulations of the same points by this project and by its peers, each a program of its own beside
// this one. One JSON object per line and program on stdout; the programs take turns within each repeat, so that a
// change of the machine's speed meets all of them.

#include "compare/compare_options.h"
#include "compare/peer_process.h"
#include "compare/point_file.h"
#include "support/degenerate_points.h"
#include "support/temp_dir.h"

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <optional>

namespace {

using compare::Options;
using compare::Report;

std::vector<double> flat(const std::vector<mesher::Vec2>& points)
{
    std::vector<double> coordinates;
    coordinates.reserve(2 * points.size());
    for (const mesher::Vec2& p : points) coordinates.insert(coordinates.end(), {p.x, p.y});
    return coordinates;
}

std::vector<double> flat(const std::vector<mesher::Vec3>& points)
{
    std::vector<double> coordinates;
    coordinates.reserve(3 * points.size());
    for (const mesher::Vec3& p : points) coordinates.insert(coordinates.end(), {p.x, p.y, p.z});
    return coordinates;
}

template <class Point>
std::optional<std::vector<double>> generate(const std::vector<mesher::test::PointFamily<Point>>& families,
                                            const std::string& set, const Options& options)
{
    for (const mesher::test::PointFamily<Point>& family : families) {
        if (family.name == set) return flat(family.make(options.points, options.seed));
    }
    return std::nullopt;
}

double medianOf(std::vector<double> values)
{
    std::sort(values.begin(), values.end());
    const std::size_t middle = values.size() / 2;
    return values.size() % 2 == 1 ? values[middle] : 0.5 * (values[middle - 1] + values[middle]);
}

struct Series
{
    std::string program;
    std::vector<double> seconds;
    Report last;
};

void print(const Series& series, const std::string& set, std::uint32_t dimension, const Options& options)
{
    const auto [least, most] = std::minmax_element(series.seconds.begin(), series.seconds.end());
    const double median = medianOf(series.seconds);
    std::printf(
        "{\"set\": \"%s\", \"dimension\": %u, \"points\": %zu, \"program\": \"%s\", \"cpu_seconds\": %.6f, "
        "\"cpu_seconds_min\": %.6f, \"cpu_seconds_max\": %.6f, \"repeats\": %zu, "
        "\"points_per_second\": %.0f, \"vertices\": %.0f, \"simplices\": %.0f, "
        "\"bytes_per_simplex\": %.2f, \"scaffold\": %.0f}\n",
        set.c_str(), dimension, options.points, series.program.c_str(), median, *least, *most,
        series.seconds.size(), median > 0.0 ? static_cast<double>(options.points) / median : 0.0,
        series.last.vertices, series.last.simplices, series.last.bytesPerSimplex, series.last.scaffold);
    std::fflush(stdout);
}

/// False if a program failed; the others are reported all the same.
bool compareOn(const std::string& set, std::uint32_t dimension, const Options& options,
               const std::string& pointFile, const std::filesystem::path& programFolder)
{
    std::vector<Series> all;
    for (const std::string& program : options.programs) {
        if (compare::supportsDimension(program, dimension)) all.push_back({program, {}, {}});
    }
    std::vector<std::string> failed;
    for (std::size_t repeat = 0; repeat < options.repeats; ++repeat) {
        for (Series& series : all) {
            if (std::count(failed.begin(), failed.end(), series.program) > 0) continue;
            const std::optional<Report> report =
                compare::runProgram(programFolder, series.program, pointFile);
            if (report) {
                series.seconds.push_back(report->cpuSeconds);
                series.last = *report;
            } else {
                std::fprintf(stderr, "compare_delaunay: %s failed on %s (%uD)\n", series.program.c_str(),
                             set.c_str(), dimension);
                failed.push_back(series.program);
            }
        }
    }
    for (const Series& series : all) {
        if (std::count(failed.begin(), failed.end(), series.program) == 0)
            print(series, set, dimension, options);
    }
    return failed.empty();
}

bool compareInDimension(std::uint32_t dimension, const Options& options,
                        const std::filesystem::path& programFolder)
{
    const mesher::test::TempDir folder;
    const std::string pointFile = (folder.path() / "points.bin").string();
    bool isSound = true;
    for (const std::string& set : options.setsOf(dimension)) {
        const std::optional<std::vector<double>> coordinates =
            dimension == 2 ? generate(mesher::test::pointFamilies2d(), set, options)
                           : generate(mesher::test::pointFamilies3d(), set, options);
        if (!coordinates) {
            std::fprintf(stderr, "compare_delaunay: there is no %uD point set '%s'\n", dimension,
                         set.c_str());
            isSound = false;
        } else if (!compare::writePointFile(pointFile, dimension, *coordinates)) {
            std::fprintf(stderr, "compare_delaunay: cannot write %s\n", pointFile.c_str());
            return false;
        } else {
            isSound = compareOn(set, dimension, options, pointFile, programFolder) && isSound;
        }
    }
    return isSound;
}

}  // namespace

int main(int argumentCount, char** arguments)
{
    const std::optional<Options> options = compare::parseOptions({arguments + 1, arguments + argumentCount});
    if (!options) return 2;
    const std::filesystem::path programFolder = std::filesystem::read_symlink("/proc/self/exe").parent_path();
    bool isSound = true;
    for (const std::uint32_t dimension : options->dimensions) {
        isSound = compareInDimension(dimension, *options, programFolder) && isSound;
    }
    return isSound ? 0 : 1;
}
