#include <grader/build/Kit.h>
#include <grader/cli/Home.h>
#include <grader/cli/verbs/Verb.h>
#include <grader/sandbox/LevelDiagnosis.h>
#include <grader/sandbox/Obstacle.h>
#include <grader/sandbox/RunAt.h>

#include <raytracer/base/Error.h>

#include <CLI/CLI.hpp>

#include <fmt/core.h>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>
#include <system_error>
#include <thread>

namespace ticker::cli {
namespace {

void row(const std::string& what, bool good, const std::string& detail) {
    fmt::print("{:<12} {:<4} {}\n", what, good ? "ok" : "--", detail);
}

bool showCompiler() {
    try {
        const build::Kit kit = build::Kit::besideProgram();
        row("compiler", true, fmt::format("{}, kit in {}", kit.compiler(), kit.folder().string()));
        return true;
    } catch (const raytracer::Error& error) {
        row("compiler", false, error.what());
        return false;
    }
}

/// Says which level `--sandbox auto` takes, and the command that makes a better one possible.
void showBest(const std::string& best) {
    std::string text = best.empty() ? "no level confines submissions here"
                                    : fmt::format("--sandbox auto takes level {}", best);
    const std::string command = sandbox::commandForNamespaces(sandbox::namespaceSettings());
    if (best != sandbox::toString(sandbox::Level::namespaces))
        text += command.empty() ? "; level A needs what is said above"
                                : fmt::format("; for level A: {}", command);
    row("sandbox", !best.empty(), text);
}

/// True if some level confines submissions.
bool showSandbox() {
    std::string best;
    for (const sandbox::Diagnosis& level : sandbox::diagnose()) {
        const std::string advice = level.advice.empty() ? "" : "; " + level.advice;
        row("sandbox " + sandbox::toString(level.level), level.available, level.reason + advice);
        if (level.available && level.level != sandbox::Level::none && best.empty())
            best = sandbox::toString(level.level);
    }
    showBest(best);
    return !best.empty();
}

void showProcessor() {
    std::ifstream stream{"/proc/cpuinfo"};
    std::string flags;
    for (std::string line; std::getline(stream, line) && flags.empty();)
        if (line.rfind("flags", 0) == 0 || line.rfind("Features", 0) == 0) flags = line + " ";
    std::string known;
    for (const char* flag : {"avx512f", "avx2", "sse4_1", "asimd"})
        if (flags.find(" " + std::string{flag} + " ") != std::string::npos)
            known += fmt::format(" {}", flag);
    row("processor", true,
        fmt::format("{} threads,{}", std::thread::hardware_concurrency(),
                    known.empty() ? " no vector unit that the oracle knows" : known));
}

/// Prints what is wrong with the disk. @return  False.
bool showNoDisk(const std::string& why) {
    row("disk", false, why);
    return false;
}

/// Looks at the folder that the sandbox uses. It takes another one than TMPDIR where that will not
/// do, and other variables than TMPDIR mean nothing to it.
bool showDisk(const std::filesystem::path& folder) {
    constexpr std::uintmax_t kEnough = 1U << 30U;
    std::error_code error;
    // NOLINTNEXTLINE(concurrency-mt-unsafe): no other thread runs
    const char* const chosen = std::getenv("TMPDIR");
    if (chosen != nullptr && !std::filesystem::is_directory(chosen, error))
        return showNoDisk(
            fmt::format("TMPDIR is {}, which is no folder; set TMPDIR to a folder, or unset it",
                        *chosen == '\0' ? "empty" : chosen));
    const bool isUnused = chosen != nullptr && !std::filesystem::equivalent(chosen, folder, error);
    const auto space = std::filesystem::space(folder, error);
    const bool enough = !error && space.available >= kEnough;
    const std::string found =
        error ? error.message()
              : fmt::format("{:.1f} GB free", static_cast<double>(space.available) / 1e9);
    row("disk", enough,
        fmt::format("{} for temporary files in {}{}{}", found, folder.string(),
                    isUnused ? fmt::format(", not in TMPDIR ({}): not writable, not reachable by "
                                           "every user, or mounted noexec",
                                           chosen)
                             : "",
                    enough ? ""
                           : fmt::format("; {:.1f} GB are enough: free some, or set TMPDIR to a "
                                         "folder of another disk",
                                         static_cast<double>(kEnough) / 1e9)));
    return enough;
}

bool showDisk() {
    try {
        return showDisk(sandbox::staging().path().parent_path());
    } catch (const raytracer::Error& error) {
        return showNoDisk(error.what());
    }
}

raytracer::ExitCode examine() {
    row("data", true, Home::find().data.string());
    const bool compiler = showCompiler();
    const bool sandbox = showSandbox();
    showProcessor();
    const bool disk = showDisk();
    return compiler && sandbox && disk ? raytracer::ExitCode::success
                                       : raytracer::ExitCode::checkFailed;
}

}  // namespace

Run addDoctor(CLI::App& app, const GlobalOptions& /*global*/) {
    app.add_subcommand("doctor", "What this machine offers: compiler, sandbox, processor, disk");
    return [] { return examine(); };
}

}  // namespace ticker::cli
