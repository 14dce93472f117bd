#pragma once

namespace mesher {

/// What the program tells its caller.
enum class ExitStatus
{
    Done = 0,
    Failed = 1,      ///< could not mesh, or ran into a limit
    Usage = 2,       ///< the command line makes no sense
    Cancelled = 130  ///< as of a program ended by SIGINT
};

}  // namespace mesher
