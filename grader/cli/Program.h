#ifndef TICKER_CLI_PROGRAM_H
#define TICKER_CLI_PROGRAM_H

#include <grader/cli/verbs/Verb.h>

#include <string>
#include <vector>

namespace ticker::cli {

/// How a program calls itself.
struct Program {
    std::string name;
    std::string description;
};

/// Adds one verb to the command line and gives back what runs it.
using AddVerb = Run (*)(CLI::App& app, const GlobalOptions& global);

/// Reads the command line, runs the verb that it names, and reports errors in one line on stderr.
/// @return the exit status.
[[nodiscard]] int runProgram(const Program& program, const std::vector<AddVerb>& verbs, int argc,
                             char** argv);

}  // namespace ticker::cli

#endif
