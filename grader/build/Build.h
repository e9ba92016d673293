#ifndef TICKER_BUILD_BUILD_H
#define TICKER_BUILD_BUILD_H

#include <grader/build/Kit.h>
#include <grader/build/Program.h>
#include <grader/sandbox/Sandbox.h>

#include <optional>
#include <string>
#include <string_view>

namespace ticker::build {

/// What became of one submitted file.
struct BuildResult {
    enum class Kind {
        built,      ///< `program` is there
        failed,     ///< the file has errors: `diagnostics`
        limit,      ///< the compiler ran out of time, memory or output: `diagnostics` says which
        forbidden,  ///< replaces a part of the framework, or asks the system for what it must not
        ourFault    ///< could not be compiled for reasons that are ours: `diagnostics`
    };
    Kind kind = Kind::ourFault;
    std::optional<Program> program;
    /// The compiler's words: the student's own file name and line numbers, no path of this machine,
    /// valid UTF-8, at most 16 KiB. They hold the student's text: escape them.
    std::string diagnostics;
    double cpuMs = 0.0;
    double wallMs = 0.0;
    int compilations = 0;  ///< how often the compiler was run
};

/// Compiles one submitted file and links it with the kit and the template's other file.
///
/// It is compiled alone, so that it can only spoil its own task, with nothing of the submission
/// around it. A file that does not compile with the kit's precompiled header is compiled again
/// without it, since that header names more things than the file asked for; the errors told are
/// those of the second time. What compiled and could not be linked is not compiled again.
[[nodiscard]] BuildResult buildProgram(const Kit& kit, const sandbox::Sandbox& sandbox,
                                       const sandbox::Limits& limits, SourceFile file,
                                       std::string_view source);

}  // namespace ticker::build

#endif
