#ifndef TICKER_BUILD_BUILD_H
#define TICKER_BUILD_BUILD_H

#include <grader/build/Kit.h>
#include <grader/build/Program.h>
#include <grader/sandbox/Sandbox.h>

#include <optional>
#include <string>
#include <string_view>

namespace ticker::build {

/// Result of building one submitted file.
struct BuildResult {
    enum class Kind {
        built,      ///< `program` is there
        failed,     ///< the file has errors: `diagnostics`
        limit,      ///< the compiler ran out of time, memory or output: `diagnostics` says which
        forbidden,  ///< replaces a part of the framework, or makes a forbidden request to the
                    ///< system
        ourFault    ///< could not be compiled because of an error of the grader: see `diagnostics`
    };
    Kind kind = Kind::ourFault;
    std::optional<Program> program;
    /// The compiler's messages: the student's own file name and line numbers, no path of this
    /// machine, valid UTF-8, at most 16 KiB. They quote the student's text: escape them.
    std::string diagnostics;
    double cpuMs = 0.0;
    double wallMs = 0.0;
    int compilations = 0;  ///< how often the compiler was run
};

/// The kind of result that a finished run of the compiler stands for.
[[nodiscard]] BuildResult::Kind kindOf(const sandbox::Outcome& outcome,
                                       const sandbox::Limits& limits);

/// What a program is for.
enum class Purpose {
    graded,   ///< to be judged: as a submission is compiled and asked
    switched  ///< carries many edits (grader/repair): compiled quickly, asked by switched.o
};

/// Compiles one submitted file and links it with the kit and the template's other files.
///
/// The file is compiled alone, with nothing else of the submission around it, so that it can only
/// break its own task. If it does not compile with the kit's precompiled header, it is compiled
/// again without: that header declares more names than the file asked for. The diagnostics are
/// those of the second run. A file that compiled but did not link is not compiled again.
[[nodiscard]] BuildResult buildProgram(const Kit& kit, const sandbox::Sandbox& sandbox,
                                       const sandbox::Limits& limits, const std::string& file,
                                       std::string_view source, Purpose purpose = Purpose::graded);

}  // namespace ticker::build

#endif
