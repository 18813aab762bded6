// How the tool fails: always one line on stderr, and an exit code that says whose fault it was.
#pragma once

#include <stdexcept>
#include <string>

namespace gp::tool {

enum ExitCode : int {
    kExitSuccess = 0,
    kExitFailure = 1,       // something went wrong while running; a threshold was passed
    kExitUsage = 2,         // the command line was not understood
    kExitInterrupted = 130  // ended by SIGINT or SIGTERM, as shells say it
};

// The command line asks for something that does not exist.
struct UsageError : std::runtime_error {
    using std::runtime_error::runtime_error;
};

// A file is missing or bad, memory is short, ...
struct RunError : std::runtime_error {
    using std::runtime_error::runtime_error;
};

}  // namespace gp::tool
