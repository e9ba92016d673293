#ifndef TICKER_CLI_VERB_H
#define TICKER_CLI_VERB_H

#include <raytracer/base/Error.h>

#include <functional>
#include <string>

namespace CLI {
class App;
}

namespace ticker::cli {

/// Options of every verb.
struct GlobalOptions {
    bool quiet = false;              ///< nothing on stderr but errors
    bool verbose = false;            ///< more on stderr
    std::string command = "ticker";  ///< name of this program on the command line
    std::string commandLine = {};    ///< the whole command line
};

/// Runs a verb after the command line was read.
using Run = std::function<raytracer::ExitCode()>;

// Each function adds one verb to the command line and returns the function that runs it. `global`
// outlives the program.
Run addGrade(CLI::App& app, const GlobalOptions& global);
Run addCheck(CLI::App& app, const GlobalOptions& global);
Run addExplain(CLI::App& app, const GlobalOptions& global);
Run addRender(CLI::App& app, const GlobalOptions& global);
Run addCompare(CLI::App& app, const GlobalOptions& global);
Run addRefs(CLI::App& app, const GlobalOptions& global);
Run addCollect(CLI::App& app, const GlobalOptions& global);
Run addAppeal(CLI::App& app, const GlobalOptions& global);
Run addSession(CLI::App& app, const GlobalOptions& global);
Run addSimilar(CLI::App& app, const GlobalOptions& global);
Run addReport(CLI::App& app, const GlobalOptions& global);
Run addDoctor(CLI::App& app, const GlobalOptions& global);
Run addPackage(CLI::App& app, const GlobalOptions& global);

}  // namespace ticker::cli

#endif
