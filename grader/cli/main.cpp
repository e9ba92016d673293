#include <grader/cli/verbs/Verb.h>

#include <CLI/CLI.hpp>

#include <cstdio>
#include <cstdlib>
#include <exception>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace {

using raytracer::ExitCode;
using raytracer::toInt;

int report(const std::string& message, ExitCode code) {
    std::fprintf(stderr, "ticker: %s\n", message.c_str());
    return toInt(code);
}

/// Says what CLI11 found wrong, in one line, or prints the help that was asked for.
int answer(const CLI::App& app, const CLI::ParseError& error) {
    if (error.get_exit_code() == 0) return app.exit(error);
    return report(std::string{error.what()} + " (ticker --help tells all)", ExitCode::badInput);
}

std::string quoted(const std::string& word) {
    constexpr std::string_view kPlain =
        "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789-_./=,:+@%";
    if (!word.empty() && word.find_first_not_of(kPlain) == std::string::npos) return word;
    std::string text = "'";
    for (const char c : word)
        text += c == '\'' ? "'\\''" : std::string{c};
    return text + "'";
}

std::string commandLine(const ticker::cli::Voice& voice, int argc, char** argv) {
    std::string line = voice.command;
    for (int i = 1; i < argc; ++i)
        line += " " + quoted(argv[i]);
    return line;
}

}  // namespace

// Before the try block only CLI11 could throw, at options that are declared wrongly.
// NOLINTNEXTLINE(bugprone-exception-escape)
int main(int argc, char** argv) {
    using namespace ticker::cli;
    CLI::App app{"Grades a ray-tracing exercise: bump mapping, soft shadows, depth of field.",
                 "ticker"};
    app.set_version_flag("--version", TICKER_VERSION);
    app.require_subcommand(1);
    app.fallthrough();
    Voice voice;
    // The script tick hands over to this program under another name.
    const char* command = std::getenv("TICKER_COMMAND");
    voice.command = quoted(command != nullptr ? command : argv[0]);
    voice.commandLine = commandLine(voice, argc, argv);
    app.add_flag("--quiet", voice.quiet, "Say nothing but errors");
    app.add_flag("--verbose", voice.verbose, "Say more");

    const std::vector<Run> verbs{
        addGrade(app, voice),   addCheck(app, voice),    addRender(app, voice),
        addReport(app, voice),  addDoctor(app, voice),   addCompare(app, voice),
        addRefs(app, voice),    addSelftest(app, voice), addPackage(app, voice),
        addCollect(app, voice), addSession(app, voice),  addCalibrate(app, voice)};
    try {
        app.parse(argc, argv);
        const std::vector<CLI::App*> known = app.get_subcommands(nullptr);
        for (std::size_t i = 0; i < known.size(); ++i)
            if (known[i]->parsed()) return toInt(verbs.at(i)());
    } catch (const CLI::ParseError& error) {
        return answer(app, error);
    } catch (const raytracer::Error& error) {
        return report(error.what(), error.exitCode());
    } catch (const std::exception& error) {
        return report(std::string{"unexpected: "} + error.what(), ExitCode::notGradable);
    }
    return toInt(ExitCode::badInput);
}
