#include <grader/base/WholeFile.h>
#include <grader/build/Kit.h>
#include <grader/cli/Home.h>
#include <grader/cli/verbs/GradeOptions.h>
#include <grader/exercise/Exercise.h>
#include <grader/pipeline/InputDigests.h>

#include <raytracer/base/Error.h>

#include <fmt/core.h>
#include <CLI/CLI.hpp>

#include <random>
#include <vector>

namespace ticker::cli {
namespace {

constexpr const char* kAllOptions = "auto";
constexpr const char* kBestLevel = "auto";

/// @throws raytracer::InputError where the exercise has no such option.
std::string chosenOption(const std::string& option, const Exercise& exercise) {
    if (option == kAllOptions) return "";
    std::vector<std::string> names;
    for (const OptionEntry& known : exercise.options) {
        if (known.name == option) return option;
        names.push_back(known.name);
    }
    names.emplace_back(kAllOptions);
    throw raytracer::InputError("", 0,
                                fmt::format("--option {}: {} has no such option; expected {}",
                                            option, exercise.name, enumerated(names, "or")));
}

}  // namespace

sandbox::Sandbox openSandbox(const std::string& level) {
    for (const sandbox::Level known : {sandbox::Level::namespaces, sandbox::Level::ownUser,
                                       sandbox::Level::sameUser, sandbox::Level::none})
        if (sandbox::toString(known) == level) return sandbox::Sandbox::at(known);
    if (level == kBestLevel) return sandbox::Sandbox::best();
    throw raytracer::InputError(
        "", 0,
        fmt::format("--sandbox {}: there is no such level; expected A, B, C, none or auto", level));
}

std::vector<std::string> exerciseNames() {
    std::vector<std::string> names;
    for (const Exercise& exercise : knownExercises())
        names.push_back(exercise.name);
    return names;
}

void addExerciseOption(CLI::App& verb, std::string& name) {
    name = defaultExercise().name;
    verb.add_option("--exercise", name, "Which exercise: " + enumerated(exerciseNames(), "or"))
        ->envname("TICKER_EXERCISE")
        ->check(CLI::IsMember(exerciseNames()));
}

void addGradeOptions(CLI::App& verb, GradeOptions& options) {
    addExerciseOption(verb, options.exercise);
    verb.add_option("--seed", options.seed,
                    "Whole number that the hidden questions are drawn from");
    addJudgingOptions(verb, options);
}

void addJudgingOptions(CLI::App& verb, GradeOptions& options) {
    verb.add_option("--option", options.option,
                    "Which option of the exercise to judge, or auto: all of them");
    verb.add_option("--sandbox", options.sandbox, "Level A, B or C, auto (the best), or none")
        ->check(CLI::IsMember({kBestLevel, "A", "B", "C", "none"}));
    verb.add_option("--rubric", options.rubric, "Another rubric than the kit's own");
}

pipeline::Grader makeGrader(const GradeOptions& options) {
    const Home home = Home::find();
    const Exercise& exercise =
        options.exercise.empty() ? defaultExercise() : exerciseNamed(options.exercise);
    const std::filesystem::path rubric = options.rubric.empty()
                                             ? home.data / exercise.rubric
                                             : std::filesystem::path{options.rubric};
    pipeline::Grader grader{
        .kit = build::Kit::besideProgram(exercise),
        .sandbox = openSandbox(options.sandbox),
        .policy = sandbox::defaultPolicy(),
        .rubric = rubric::readRubric(rubric, exercise),
        .toolVersion = TICKER_VERSION,
        .option = chosenOption(options.option, exercise),
        .scenes = pipeline::readSpecScenes(home.scenes(), home.assets(), exercise),
        .exercise = &exercise};
    grader.build = pipeline::toolBuild(grader.kit, {home.scenes(), home.assets()});
    grader.rubricText = readIfThere(rubric).value_or("");
    return grader;
}

std::uint64_t seedOf(const GradeOptions& options) {
    if (options.seed) return *options.seed;
    std::random_device system;
    return (static_cast<std::uint64_t>(system()) << 32U) | system();
}

}  // namespace ticker::cli
