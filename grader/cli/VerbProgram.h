#ifndef TICKER_CLI_VERBPROGRAM_H
#define TICKER_CLI_VERBPROGRAM_H

#include <grader/cli/verbs/Verb.h>

#include <string>
#include <vector>

namespace ticker::cli {

/// Name and description of a program.
struct Program {
    std::string name;
    std::string description;
};

/// Adds one verb to the command line and returns the function that runs it.
using AddVerb = Run (*)(CLI::App& app, const GlobalOptions& global);

/// Reads the command line, runs its verb, and reports errors in one line on stderr.
/// @return  The exit status.
[[nodiscard]] int runProgram(const Program& program, const std::vector<AddVerb>& verbs, int argc,
                             char** argv);

}  // namespace ticker::cli

#endif
