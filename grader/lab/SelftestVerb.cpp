#include <grader/base/WholeFile.h>
#include <grader/cli/Explained.h>
#include <grader/cli/Home.h>
#include <grader/cli/ProgressLine.h>
#include <grader/cli/verbs/GradeOptions.h>
#include <grader/cli/verbs/Verb.h>
#include <grader/exercise/Exercise.h>
#include <grader/lab/LabVerbs.h>
#include <grader/lab/selftest/BumpTables.h>
#include <grader/lab/selftest/Combinations.h>
#include <grader/lab/selftest/HostileTables.h>
#include <grader/lab/selftest/MistakeTables.h>
#include <grader/lab/selftest/ScreenshotTables.h>
#include <grader/report/Escape.h>

#include <CLI/CLI.hpp>

#include <fmt/core.h>
#include <algorithm>
#include <cstdio>
#include <memory>
#include <string>
#include <vector>

namespace ticker::cli {
namespace {

struct SelftestOptions {
    std::string task;
    bool hostile = false;
    bool explain = false;
    bool screenshots = false;
    std::size_t combinations = 0;
    double fraction = 1.0;
    int rounds = 1;
    std::vector<std::string> cases;
    GradeOptions grade;
};

/// What became of a table, or of several.
struct Tables {
    std::size_t rows = 0;
    bool good = true;

    Tables& operator+=(const Tables& more) {
        rows += more.rows;
        good = more.good && good;
        return *this;
    }
};

void printTable(const std::string& title, const std::string& table) {
    fmt::print("{}\n{}\n", title, cleanText(table));
    std::fflush(stdout);
}

Tables testBump(const SelftestOptions& options, const std::string& option, bool draw) {
    const Countdown counter{option, 0, draw};
    const selftest::BumpSelfTest result =
        selftest::runBumpSelfTest(options.fraction, {1}, [&](int done, int total) {
            counter.show(static_cast<std::size_t>(done), static_cast<std::size_t>(total));
        });
    printTable(option + ": readings that must pass, mistakes in every reading that must be named",
               result.table());
    return {result.accepted.size() + result.refused.size(), result.passed()};
}

/// The reference solution's files of the default exercise, and some right samples.
std::vector<selftest::RightSource> rightSources(const Home& home) {
    std::vector<selftest::RightSource> sources;
    for (const char* folder :
         {"reference_solution/exercise", "grader/corpus/samples/awarded/bump-bilinear",
          "grader/corpus/samples/awarded/bump-z-up",
          "grader/corpus/samples/awarded/distributed-half-width",
          "grader/corpus/samples/awarded/distributed-phong-per-sample"})
        for (const std::string& file : defaultExercise().files())
            if (const auto path = home.data / folder / file; std::filesystem::exists(path))
                sources.push_back({folder, file, readWhole(path)});
    return sources;
}

/// The catalogue of an exercise. For other exercises than the default one it includes the unseen
/// solutions.
std::vector<corpus::Entry> catalogueOf(const Exercise& exercise) {
    std::vector<std::string> collections{"accepted", "mistakes"};
    if (&exercise != &defaultExercise()) collections.emplace_back("unseen");
    return corpus::readEntries(Home::find().data, collections, exercise);
}

/// The catalogue's entries about an option's tasks.
std::vector<corpus::Entry> entriesOf(const OptionEntry& option, const Exercise& exercise) {
    return selftest::mistakesOf(catalogueOf(exercise), option.tasks);
}

/// @param what  Title of the table; may be empty.
Tables testMistakes(const std::vector<corpus::Entry>& entries, const std::string& what,
                    const SelftestOptions& options, const pipeline::Grader& grader, bool draw) {
    const Countdown counter{what.empty() ? "mistakes" : what, 0, draw};
    selftest::MistakeRun run;
    run.exercise = grader.exercise;
    run.fraction = options.cases.empty() ? options.fraction : 1.0;
    run.seed = seedOf(options.grade);
    run.progress = [&](std::size_t done, std::size_t of) { counter.show(done, of); };
    const auto rows = selftest::runMistakes(entries, grader.kit, grader.sandbox, run);
    printTable((what.empty() ? "" : what + ": ") + "the catalogue of mistakes, compiled and judged",
               selftest::tableOf(rows));
    return {rows.size(), std::ranges::all_of(rows, &selftest::MistakeRow::asExpected)};
}

/// The whole corpus, or the requested entries.
std::vector<corpus::Entry> hostileCases(const Exercise& exercise,
                                        const std::vector<std::string>& wanted) {
    auto corpus = corpus::readEntries(Home::find().data, {"hostile"}, exercise);
    if (wanted.empty()) return corpus;
    std::vector<corpus::Entry> picked;
    for (const std::string& name : wanted) {
        const auto found = std::ranges::find(corpus, name, &corpus::Entry::name);
        if (found == corpus.end())
            throw raytracer::InputError("--case " + name, 0,
                                        "is no entry of grader/corpus/hostile/cases");
        picked.push_back(*found);
    }
    return picked;
}

Tables testHostile(const SelftestOptions& options, pipeline::Grader grader, bool draw) {
    const Home home = Home::find();
    const Countdown counter{"hostile", 0, draw};
    grader.policy = sandbox::readPolicy(home.data / "grader/corpus/hostile/limits.json");
    selftest::HostileRun run;
    run.fraction = options.fraction;
    run.rounds = options.rounds;
    run.seed = seedOf(options.grade);
    if (options.explain)
        run.complete = [&](const intake::Submission& submission, SubmissionResult& result) {
            addRepairs(submission, grader, result);
        };
    run.progress = [&](std::size_t done, std::size_t of) { counter.show(done, of); };
    const selftest::HostileTables tables =
        selftest::runHostileTables(hostileCases(*grader.exercise, options.cases), grader, run);
    printTable("Hostile submissions at sandbox level " + sandbox::toString(grader.sandbox.level()),
               tables.table());
    return {tables.rows.size(), tables.passed()};
}

Tables testScreenshots(const SelftestOptions& options, const pipeline::Grader& grader, bool draw) {
    const Countdown counter{"screenshots", 0, draw};
    selftest::ScreenshotRun run;
    run.fraction = options.fraction;
    run.seed = seedOf(options.grade);
    run.progress = [&](std::size_t done, std::size_t of) { counter.show(done, of); };
    const selftest::ScreenshotSelfTest result = selftest::runScreenshotTables(
        {grader.scenes, grader.kit, grader.sandbox, rightSources(Home::find())}, run);
    printTable("Screenshots: honest ones, and others of every kind", result.table());
    return {result.honest.size() + result.bad.size(), result.passed()};
}

/// Whether the exercise has the tables that exist for the default exercise only: models of its
/// first option, and pictures.
bool hasModels(const Exercise& exercise) {
    return &exercise == &defaultExercise();
}

Tables testCombinations(const SelftestOptions& options, const pipeline::Grader& grader, bool draw) {
    const auto accepted = corpus::readEntries(Home::find().data, {"accepted"}, *grader.exercise);
    return testMistakes(
        selftest::drawCombinations(accepted, options.combinations, seedOf(options.grade)),
        "accepted readings together", options, grader, draw);
}

Tables runTables(const SelftestOptions& options, bool draw) {
    const pipeline::Grader grader = makeGrader(options.grade);
    const Exercise& exercise = *grader.exercise;
    if (options.combinations > 0) return testCombinations(options, grader, draw);
    if (!options.cases.empty() && !options.hostile) {
        const auto catalogue = catalogueOf(exercise);
        return testMistakes(selftest::mistakesCalled(catalogue, options.cases), options.task,
                            options, grader, draw);
    }
    const bool all = options.task.empty() && !options.hostile && !options.screenshots;
    Tables tables;
    for (const OptionEntry& option : exercise.options)
        if (all || options.task == option.name)
            tables += testMistakes(entriesOf(option, exercise), option.name, options, grader, draw);
    const std::string first = exercise.options.front().name;
    if (hasModels(exercise) && (all || options.task == first))
        tables += testBump(options, first, draw);
    if ((hasModels(exercise) && all) || options.hostile)
        tables += testHostile(options, grader, draw);
    if (hasModels(exercise) && (all || options.screenshots))
        tables += testScreenshots(options, grader, draw);
    return tables;
}

/// @throws raytracer::InputError where the exercise has no such option.
void checkTask(const SelftestOptions& options) {
    std::vector<std::string> names;
    for (const OptionEntry& option : exerciseNamed(options.grade.exercise).options)
        names.push_back(option.name);
    if (!options.task.empty() && std::ranges::find(names, options.task) == names.end())
        throw raytracer::InputError(
            "--task " + options.task, 0,
            "expected an option of the exercise: " + enumerated(names, "or"));
}

raytracer::ExitCode selftest(const SelftestOptions& options, const GlobalOptions& global) {
    checkTask(options);
    const Tables tables = runTables(options, mayDraw(global.quiet));
    if (tables.rows == 0)
        throw raytracer::InputError("", 0,
                                    "nothing of the exercise fits --task, --hostile, "
                                    "--screenshots and the other options; nothing was tested");
    return tables.good ? raytracer::ExitCode::success : raytracer::ExitCode::checkFailed;
}

}  // namespace

Run addSelftest(CLI::App& app, const GlobalOptions& global) {
    auto options = std::make_shared<SelftestOptions>();
    // A fixed seed, so that a passing test passes again; `calibrate` measures rare events.
    constexpr std::uint64_t kUsualSeed = 1;
    options->grade.seed = kUsualSeed;
    CLI::App* verb = app.add_subcommand("selftest",
                                        "Mistakes, accepted readings, hostile submissions and "
                                        "screenshots, against what is expected");
    addExerciseOption(*verb, options->grade.exercise);
    verb->add_option("--task", options->task, "Only the tables of this option of the exercise");
    verb->add_flag("--hostile", options->hostile, "Only the hostile submissions");
    verb->add_flag(
        "--explain", options->explain,
        "Also looks for edits that mend the hostile submissions, as grade --explain does");
    verb->add_flag("--screenshots", options->screenshots, "Only the screenshots");
    verb->add_option("--combinations", options->combinations,
                     "Instead of the tables: this many random combinations of accepted readings");
    verb->add_option("--fraction", options->fraction, "Share of each table to run")
        ->check(CLI::Range(0.0, 1.0));
    verb->add_option("--repeat", options->rounds, "How often to run the hostile submissions")
        ->check(CLI::Range(1, 1000));
    verb->add_option("--case", options->cases,
                     "Only these mistakes of the catalogue; with --hostile, these submissions")
        ->delimiter(',');
    verb->add_option("--sandbox", options->grade.sandbox, "Level A, B or C; auto: the best")
        ->check(CLI::IsMember({"auto", "A", "B", "C"}));
    verb->add_option("--seed", options->grade.seed,
                     "Whole number that the hidden questions are drawn from; 1 unless told");
    return [options, &global] { return selftest(*options, global); };
}

}  // namespace ticker::cli
