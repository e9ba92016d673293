#ifndef TICKER_CLI_GRADEOPTIONS_H
#define TICKER_CLI_GRADEOPTIONS_H

#include <grader/pipeline/Grade.h>

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace ticker::cli {

/// The options that `grade` and `check` share.
struct GradeOptions {
    std::string exercise = {};  ///< its name; empty: the default one
    std::optional<std::uint64_t> seed = {};
    std::string option = "auto";
    std::string sandbox = "auto";
    std::string rubric = {};  ///< empty: the exercise's own
};

/// Of the known exercises, the default one first.
[[nodiscard]] std::vector<std::string> exerciseNames();

/// Adds --exercise to a verb: a known exercise's name; the environment's TICKER_EXERCISE or the
/// default one where it is not given.
void addExerciseOption(CLI::App& verb, std::string& name);

/// Adds --option, --sandbox and --rubric to a verb.
void addJudgingOptions(CLI::App& verb, GradeOptions& options);

/// Adds --exercise, --seed and the judging options to a verb.
void addGradeOptions(CLI::App& verb, GradeOptions& options);

/// @param level  "A", "B", "C", "none", or "auto": the best available level.
/// @throws raytracer::InputError for any other word, raytracer::Error if this machine does not
///         offer the level.
[[nodiscard]] sandbox::Sandbox openSandbox(const std::string& level);

/// Everything that judging needs, according to the options.
/// @throws raytracer::Error if the kit, the rubric or the sandbox level is not available.
[[nodiscard]] pipeline::Grader makeGrader(const GradeOptions& options);

/// The given seed, or a fresh one from the system.
[[nodiscard]] std::uint64_t seedOf(const GradeOptions& options);

}  // namespace ticker::cli

#endif
