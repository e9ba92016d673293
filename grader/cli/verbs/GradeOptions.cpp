#include <grader/base/WholeFile.h>
#include <grader/build/Kit.h>
#include <grader/cli/Home.h>
#include <grader/cli/verbs/GradeOptions.h>
#include <grader/exercise/Exercise.h>
#include <grader/pipeline/Inputs.h>

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include <random>
#include <vector>

namespace ticker::cli {
namespace {

constexpr const char* kAllOptions = "auto";

std::vector<std::string> optionNames() {
    std::vector<std::string> names;
    for (const OptionEntry& option : theExercise().options)
        names.push_back(option.name);
    return names;
}

std::vector<std::string> choices() {
    std::vector<std::string> names = optionNames();
    names.insert(names.begin(), kAllOptions);
    return names;
}

}  // namespace

sandbox::Sandbox openSandbox(const std::string& level) {
    for (const sandbox::Level known : {sandbox::Level::namespaces, sandbox::Level::ownUser,
                                       sandbox::Level::sameUser, sandbox::Level::none})
        if (sandbox::toString(known) == level) return sandbox::Sandbox::at(known);
    return sandbox::Sandbox::best();
}

void addGradeOptions(CLI::App& verb, GradeOptions& options) {
    verb.add_option("--seed", options.seed,
                    "Whole number that the hidden questions are drawn from");
    verb.add_option("--option", options.option,
                    "Which option to judge: " + fmt::format("{}", fmt::join(optionNames(), ", ")) +
                        " or auto (both)")
        ->check(CLI::IsMember(choices()));
    verb.add_option("--sandbox", options.sandbox, "Level A, B or C, auto (the best), or none")
        ->check(CLI::IsMember({"auto", "A", "B", "C", "none"}));
    verb.add_option("--rubric", options.rubric, "Another rubric than the kit's own");
}

pipeline::Grader makeGrader(const GradeOptions& options) {
    const Home home = Home::find();
    const std::filesystem::path rubric =
        options.rubric.empty() ? home.rubric() : std::filesystem::path{options.rubric};
    pipeline::Grader grader{.kit = build::Kit::besideProgram(),
                            .sandbox = openSandbox(options.sandbox),
                            .policy = sandbox::defaultPolicy(),
                            .rubric = rubric::readRubric(rubric),
                            .toolVersion = TICKER_VERSION,
                            .option = options.option == kAllOptions ? "" : options.option,
                            .scenes = pipeline::readSpecScenes(home.scenes(), home.assets())};
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
