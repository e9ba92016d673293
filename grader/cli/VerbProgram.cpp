#include <grader/base/ShellQuoted.h>
#include <grader/cli/CommandTree.h>
#include <grader/cli/VerbProgram.h>
#include <grader/cli/texts/Version.h>

#include <CLI/CLI.hpp>

#include <malloc.h>

#include <cstdio>
#include <cstdlib>
#include <exception>
#include <string>
#include <utility>
#include <vector>

namespace ticker::cli {
namespace {

using raytracer::ExitCode;
using raytracer::toInt;

// Bump maps and pictures take some megabytes each. With glibc's default limits their memory goes
// back to the kernel after each use, and every page has to be cleared anew for the next submission.
void keepFreedMemory() {
    constexpr int kLargestKept = 32 << 20;  // glibc takes no more
    constexpr int kMostKept = 64 << 20;     // free memory at the end of a heap
    mallopt(M_MMAP_THRESHOLD, kLargestKept);
    mallopt(M_TRIM_THRESHOLD, kMostKept);
}

int report(const CLI::App& app, const std::string& message, ExitCode code) {
    std::fprintf(stderr, "%s: %s\n", app.get_name().c_str(), message.c_str());
    return toInt(code);
}

/// Prints CLI11's error in one line, or the help text if help was requested.
int answer(const CLI::App& app, const CLI::ParseError& error) {
    if (error.get_exit_code() == 0) return app.exit(error);
    return report(app, error.what() + (" (" + app.get_name() + " --help tells all)"),
                  ExitCode::badInput);
}

std::string commandLine(const GlobalOptions& global, int argc, char** argv) {
    std::string line = global.command;
    for (int i = 1; i < argc; ++i)
        line += " " + shellQuoted(argv[i]);
    return line;
}

/// Prints a text that is made from the command line's description, and ends.
[[noreturn]] void print(const std::string& text) {
    std::fputs(text.c_str(), stdout);
    throw CLI::Success{};
}

void addTexts(CLI::App& app, const std::string& version) {
    const std::string usage = "Print the manual page: " + app.get_name() + " --manual | man -l -";
    app.add_flag_callback(
        "--manual", [&app, version] { print(manualPage(describe(app), version)); }, usage);
    app.add_option_function<std::string>(
           "--completion",
           [&app](const std::string& shell) { print(completionScript(describe(app), shell)); },
           "Print the completion script of a shell")
        ->check(CLI::IsMember({"bash", "zsh", "fish"}));
}

}  // namespace

int runProgram(const Program& program, const std::vector<AddVerb>& verbs, int argc, char** argv) {
    keepFreedMemory();
    CLI::App app{program.description, program.name};
    const std::string version = versionText();
    app.set_version_flag("--version", version);
    app.require_subcommand(1);
    app.fallthrough();
    GlobalOptions global;
    // The script tick runs this program under another name.
    const char* command = std::getenv("TICKER_COMMAND");
    global.command = shellQuoted(command != nullptr ? command : argv[0]);
    global.commandLine = commandLine(global, argc, argv);
    app.add_flag("--quiet", global.quiet, "Say nothing but errors");
    app.add_flag("--verbose", global.verbose, "Say more");
    addTexts(app, version);

    std::vector<Run> runs;
    for (const AddVerb add : verbs)
        runs.push_back(add(app, global));
    try {
        app.parse(argc, argv);
        const std::vector<CLI::App*> known = app.get_subcommands(nullptr);
        for (std::size_t i = 0; i < known.size(); ++i)
            if (known[i]->parsed()) return toInt(runs.at(i)());
    } catch (const CLI::ParseError& error) {
        return answer(app, error);
    } catch (const raytracer::Error& error) {
        return report(app, error.what(), error.exitCode());
    } catch (const std::exception& error) {
        return report(app, std::string{"unexpected: "} + error.what(), ExitCode::notGradable);
    }
    return toInt(ExitCode::badInput);
}

}  // namespace ticker::cli
