#include <grader/build/Build.h>

#include <grader/base/FileDescriptor.h>
#include <grader/build/Diagnostics.h>

#include <raytracer/base/Error.h>

#include <fmt/core.h>

#include <fcntl.h>
#include <sys/stat.h>

#include <csignal>
#include <utility>

namespace ticker::build {
namespace fs = std::filesystem;
namespace {

using sandbox::Outcome;
using Kind = BuildResult::Kind;

// The compiler driver's message about a failed linker: the code itself compiled.
constexpr std::string_view kLinkerFailed = "ld returned 1 exit status";

bool says(const Outcome& outcome, std::string_view words) {
    return outcome.output.find(words) != std::string::npos;
}

// If the kernel ends a compiler or linker for want of memory, the driver goes on, so only the
// driver's message shows it. A student can print the same message, but the kernel counts such an
// end (`machineRanOut`) only if the machine's memory was full.
bool lostItsCompiler(const Outcome& outcome, const sandbox::Limits& limits) {
    return outcome.machineRanOut &&
           sandbox::usedLittleMemory(outcome, limits, sandbox::Policy::compile) &&
           (says(outcome, "Killed signal terminated program") ||
            says(outcome, "ld terminated with signal 9"));
}

/// The result of one run of the compiler.
struct Attempt {
    BuildResult result;
    bool couldCompile = false;  ///< true if only the linker failed
};

/// Turns one file into a program.
class Job {
public:
    Job(const Kit& kit, const sandbox::Sandbox& sandbox, const sandbox::Limits& limits,
        std::string file, Purpose purpose)
        : kit_(kit),
          sandbox_(sandbox),
          limits_(limits),
          file_(std::move(file)),
          isSwitched_(purpose == Purpose::switched),
          kitPath_{kit.folder(), "/kit"},
          sourcePath_{sources_.path(), "/source"} {}

    void writeSource(std::string_view source) const { sources_.write(file_, source); }

    [[nodiscard]] Attempt compileAndLink(bool precompiled) const {
        sandbox::JobFolder folder;
        const fs::path target = folder.path() / "probe";
        // Must be closed before the program is run: the kernel does not execute a file that is open
        // for writing.
        FileDescriptor product{open(target.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0755)};
        if (!product.isOpen() || fchmod(product.get(), 0755) != 0)
            throw raytracer::Error("cannot write " + target.string());
        const Outcome outcome = sandbox_.run(command(precompiled, product.get()));
        product.reset();

        Attempt attempt;
        BuildResult& result = attempt.result;
        result.cpuMs = outcome.cpuMs;
        result.wallMs = outcome.wallMs;
        result.compilations = 1;
        result.kind = kindOf(outcome, limits_);
        result.diagnostics = explained(result.kind, outcome);
        if (result.kind == Kind::built) result.program.emplace(std::move(folder));
        attempt.couldCompile = says(outcome, kLinkerFailed);
        return attempt;
    }

private:
    [[nodiscard]] std::string inKit(const std::string& name) const {
        return (sandbox_.pathFor(kitPath_) / name).string();
    }

    [[nodiscard]] sandbox::Command command(bool precompiled, int product) const {
        sandbox::Command command;
        std::vector<std::string>& words = command.arguments;
        words.push_back(kit_.compiler());
        const std::vector<std::string>& flags =
            isSwitched_ ? kit_.quickFlags() : kit_.compileFlags();
        words.insert(words.end(), flags.begin(), flags.end());
        words.push_back("-I" + inKit("include"));
        if (precompiled)
            words.insert(words.end(), {"-Winvalid-pch", "-include",
                                       inKit(isSwitched_ ? "pch/Switched.h" : "pch/Framework.h")});
        // Warnings for thousands of edits would be more than a compiler may print.
        if (isSwitched_) words.push_back("-w");
        words.push_back((sandbox_.pathFor(sourcePath_) / file_).string());
        for (const std::string& other : kit_.files())
            if (other != file_) words.push_back(inKit(Kit::templateObject(other)));
        words.push_back(inKit(isSwitched_ ? "lib/switched.o" : "lib/probe.o"));
        words.insert(words.end(), {"-Wl,--whole-archive", inKit("lib/libkit.a"),
                                   "-Wl,--no-whole-archive", "-o", "probe"});
        words.insert(words.end(), kit_.linkFlags().begin(), kit_.linkFlags().end());
        command.folder = sandbox::kScratchFolder;
        command.readOnly = {{"/usr", "/usr"}, kitPath_, sourcePath_};
        command.wantsScratch = true;
        command.products = {{"probe", product}};
        command.policy = sandbox::Policy::compile;
        command.limits = limits_;
        return command;
    }

    [[nodiscard]] std::string explained(Kind kind, const Outcome& outcome) const {
        if (kind == Kind::built) return {};
        std::string text = readableDiagnostics(
            outcome.output,
            {sandbox_.pathFor(sourcePath_), sandbox_.pathFor(kitPath_), kit_.folder()}, file_);
        if (outcome.end == Outcome::End::wallLimit)
            text += fmt::format("the compiler was stopped after {:.0f} s\n", limits_.wallSeconds);
        if (outcome.end == Outcome::End::outputLimit)
            text += "the compiler was stopped because it printed too much\n";
        return text;
    }

    const Kit& kit_;
    const sandbox::Sandbox& sandbox_;
    const sandbox::Limits& limits_;
    std::string file_;
    bool isSwitched_;
    sandbox::JobFolder sources_;
    sandbox::ReadOnlyPath kitPath_;
    sandbox::ReadOnlyPath sourcePath_;
};

}  // namespace

// Only the driver's message, beside the student's text, shows that a compiler was stopped. A
// student can imitate it, which only changes the name of that student's own failure.
Kind kindOf(const Outcome& outcome, const sandbox::Limits& limits) {
    switch (outcome.end) {
        case Outcome::End::failed:
            return Kind::ourFault;
        case Outcome::End::wallLimit:
        case Outcome::End::outputLimit:
            return Kind::limit;
        case Outcome::End::signalled:
            return outcome.code == SIGSYS ? Kind::forbidden : Kind::limit;
        case Outcome::End::exited:
            break;
    }
    if (outcome.code == 0) return outcome.productsMissing ? Kind::ourFault : Kind::built;
    if (lostItsCompiler(outcome, limits)) return Kind::ourFault;
    if (says(outcome, "Bad system call signal terminated program")) return Kind::forbidden;
    for (const char* stopped :
         {"signal terminated program", "out of memory", "virtual memory exhausted",
          "cannot allocate memory", "File too large", "No space left on device"})
        if (says(outcome, stopped)) return Kind::limit;
    return says(outcome, "duplicate symbol:") || says(outcome, "multiple definition of")
               ? Kind::forbidden
               : Kind::failed;
}

BuildResult buildProgram(const Kit& kit, const sandbox::Sandbox& sandbox,
                         const sandbox::Limits& limits, const std::string& file,
                         std::string_view source, Purpose purpose) {
    const Job job{kit, sandbox, limits, file, purpose};
    job.writeSource(source);
    Attempt attempt = job.compileAndLink(true);
    BuildResult first = std::move(attempt.result);
    if (first.kind != Kind::failed || attempt.couldCompile || purpose == Purpose::switched)
        return first;
    BuildResult second = job.compileAndLink(false).result;
    second.cpuMs += first.cpuMs;
    second.wallMs += first.wallMs;
    second.compilations += first.compilations;
    return second;
}

}  // namespace ticker::build
