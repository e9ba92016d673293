#ifndef TICKER_CLI_GRADEOPTIONS_H
#define TICKER_CLI_GRADEOPTIONS_H

#include <grader/pipeline/Grade.h>

#include <cstdint>
#include <optional>
#include <string>

namespace CLI {
class App;
}

namespace ticker::cli {

/// What `grade` and `check` have in common.
struct GradeOptions {
    std::optional<std::uint64_t> seed;
    std::string option = "auto";
    std::string sandbox = "auto";
    std::string rubric;  ///< empty: the kit's own
};

/// Adds --seed, --option, --sandbox and --rubric to a verb.
void addGradeOptions(CLI::App& verb, GradeOptions& options);

/// @param level  "A", "B", "C", "none", or "auto": the best that there is.
/// @throws raytracer::Error where this machine does not offer it.
[[nodiscard]] sandbox::Sandbox openSandbox(const std::string& level);

/// Everything that judging needs, as the options say.
/// @throws raytracer::Error where the kit, the rubric or the sandbox level is not to be had.
[[nodiscard]] pipeline::Grader makeGrader(const GradeOptions& options);

/// The seed that was given, or a fresh one from the system.
[[nodiscard]] std::uint64_t seedOf(const GradeOptions& options);

}  // namespace ticker::cli

#endif
