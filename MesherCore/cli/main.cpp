#include "cli/supervisor.h"

#include <unistd.h>

#include <csignal>
#include <iostream>
#include <string>
#include <vector>

int main(int argumentCount, char** arguments)
{
    // A file that grows too large and a pipe that is closed are errors of writing, which are told.
    std::signal(SIGXFSZ, SIG_IGN);
    std::signal(SIGPIPE, SIG_IGN);
    const std::vector<std::string> texts(arguments + (argumentCount > 0 ? 1 : 0), arguments + argumentCount);
    const mesher::Console console = {std::cout, std::cerr, isatty(STDERR_FILENO) == 1};
    mesher::ExitStatus status = mesher::runSupervised(texts, console);
    std::cout.flush();
    if (!std::cout && status == mesher::ExitStatus::Done) {
        std::cerr << "mesher: the standard output cannot be written.\n";
        status = mesher::ExitStatus::Failed;
    }
    return static_cast<int>(status);
}
