// Shrinks a replay log that breaks the 2D kernel, or any program.
//     reduce_replay --check LOG            replays; 1 if a check fails, 0 if all is well, 2 if the log is unreadable
//     reduce_replay LOG REDUCED            leaves out operations as long as `reduce_replay --check` fails or crashes
//     reduce_replay LOG REDUCED COMMAND    the same with `COMMAND FILE`, for other kernels and other properties

#include "base/reduce_sequence.h"
#include "delaunay/replay2d.h"

#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <sstream>
#include <string>
#include <vector>

namespace {

using mesher::ReplayLog;
using mesher::ReplayOperation;

mesher::Result<ReplayLog> readLog(const std::string& path)
{
    std::ifstream file(path);
    std::stringstream text;
    text << file.rdbuf();
    if (file) return ReplayLog::fromText(text.str());
    mesher::Error error;
    error.code = mesher::ErrorCode::Unreadable;
    error.message = "the file cannot be read";
    error.entity = path;
    return error;
}

bool writeLog(const ReplayLog& log, const std::string& path)
{
    std::ofstream file(path);
    file << log.toText();
    return static_cast<bool>(file.flush());
}

int check(const std::string& path)
{
    const auto log = readLog(path);
    if (!log) {
        std::cerr << describe(log.error()) << '\n';
        return 2;
    }
    const mesher::Replay2dResult result = mesher::replay2d(*log, 1);
    if (result.report.isValid()) return 0;
    std::cerr << "after operation " << result.operationsDone << ": " << result.report.problem << '\n';
    return 1;
}

/// For the shell. Put together by appending: where a literal is put in front of a temporary, GCC 12 warns of an overlap that
/// there is not (-Wrestrict).
std::string quoted(const std::string& word)
{
    std::string result("'");
    result.append(word).append("'");
    return result;
}

int reduce(const std::string& from, const std::string& to, const std::string& command)
{
    const auto log = readLog(from);
    if (!log) {
        std::cerr << describe(log.error()) << '\n';
        return 2;
    }
    const std::string candidate = to + ".candidate";
    const auto fails = [&](const std::vector<ReplayOperation>& operations) {
        if (!writeLog(ReplayLog(operations), candidate)) return false;
        // A crash counts: the shell tells it as a status beyond 128.
        return std::system((command + " " + quoted(candidate) + " >/dev/null 2>&1").c_str()) != 0;
    };
    const auto reduced = mesher::reduceSequence(log->operations(), fails);
    std::remove(candidate.c_str());
    std::cout << log->operations().size() << " operations reduced to " << reduced.size() << '\n';
    if (reduced.size() == log->operations().size()) {
        std::cerr << "nothing could be left out: does the whole log fail?\n";
    }
    return writeLog(ReplayLog(reduced), to) ? 0 : 2;
}

}  // namespace

int main(int count, char** words)
{
    const std::vector<std::string> arguments(words + 1, words + count);
    if (arguments.size() == 2 && arguments[0] == "--check") return check(arguments[1]);
    if (arguments.size() == 2) return reduce(arguments[0], arguments[1], quoted(words[0]) + " --check");
    if (arguments.size() == 3) return reduce(arguments[0], arguments[1], arguments[2]);
    std::cerr << "usage: reduce_replay --check LOG | reduce_replay LOG REDUCED [COMMAND]\n";
    return 2;
}
