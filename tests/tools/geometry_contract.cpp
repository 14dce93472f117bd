// Runs the contract of the geometry over model files: geometry_contract [--brief] MODEL…
// One line per model: "ok" with what was tried, "refused" with the reason, or "BROKEN" with the promises that do not hold.
// Exit 0 if no promise is broken, 1 if one is, 2 wrong usage.

#include "brep/occt/read_model.h"
#include "support/model_contract.h"

#include <chrono>
#include <cstdio>
#include <string_view>

namespace {

struct Tally
{
    int kept = 0;
    int refused = 0;
    int broken = 0;
};

double secondsSince(std::chrono::steady_clock::time_point start)
{
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

void tryModel(const char* path, std::size_t mostLines, Tally& tally)
{
    const auto start = std::chrono::steady_clock::now();
    const mesher::Result<mesher::ReadModel> read = mesher::readModel(path);
    if (!read) {
        ++tally.refused;
        std::printf("refused  %s\n", mesher::describe(read.error()).c_str());
        return;
    }
    const double readSeconds = secondsSince(start);
    const mesher::test::ContractReport report = mesher::test::checkModelContract(read->model);
    ++(report.broken.empty() ? tally.kept : tally.broken);
    std::printf("%s  %s: %zu faces, %zu edges, %zu notes, gap %.2g, %zu broken, read %.2f s, tried %.2f s\n",
                report.broken.empty() ? "ok     " : "BROKEN ", path, report.faces, report.edges, read->model.notes.size(),
                report.largestGap, report.broken.size(), readSeconds, secondsSince(start) - readSeconds);
    for (std::size_t i = 0; i < report.broken.size() && i < mostLines; ++i) {
        std::printf("         %s\n", report.broken[i].c_str());
    }
    std::fflush(stdout);
}

}  // namespace

int main(int count, char** arguments)
{
    const bool isBrief = count > 1 && std::string_view(arguments[1]) == "--brief";
    if (count < 2 + (isBrief ? 1 : 0)) {
        std::fputs("usage: geometry_contract [--brief] MODEL…\n", stderr);
        return 2;
    }
    Tally tally;
    for (int i = isBrief ? 2 : 1; i < count; ++i) tryModel(arguments[i], isBrief ? 3 : 1000, tally);
    std::printf("%d kept the contract, %d refused, %d broke it\n", tally.kept, tally.refused, tally.broken);
    return tally.broken == 0 ? 0 : 1;
}
