#include <grader/base/WholeFile.h>
#include <grader/cli/Home.h>
#include <grader/cli/Progress.h>
#include <grader/cli/verbs/GradeOptions.h>
#include <grader/cli/verbs/Verb.h>
#include <grader/exercise/Exercise.h>
#include <grader/lab/LabVerbs.h>
#include <grader/lab/selftest/BumpTables.h>
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
    bool screenshots = false;
    double fraction = 1.0;
    int rounds = 1;
    std::vector<std::string> cases;
    GradeOptions grade;
};

void printTable(const std::string& title, const std::string& table) {
    fmt::print("{}\n{}\n", title, cleanText(table));
    std::fflush(stdout);
}

bool testBump(const SelftestOptions& options, bool draw) {
    const Countdown counter{"T1", 0, draw};
    const selftest::BumpSelfTest result =
        selftest::runBumpSelfTest(options.fraction, {1}, [&](int done, int total) {
            counter.show(static_cast<std::size_t>(done), static_cast<std::size_t>(total));
        });
    printTable("T1: readings that must pass, mistakes in every reading that must be named",
               result.table());
    return result.passed();
}

/// Both reference solutions and the right samples.
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

/// The catalogue of an exercise, with what was written unseen where that is in the same form.
std::vector<corpus::Entry> catalogueOf(const Home& home, const Exercise& exercise) {
    if (&exercise == &defaultExercise()) return corpus::readCatalogue(home.data);
    std::vector<std::string> collections;
    for (const char* collection : {"/accepted", "/mistakes", "/unseen"})
        collections.push_back(exercise.name + collection);
    return corpus::readEntries(home.data, collections);
}

/// The catalogue's entries of T1 or T2 (both without a task), or the requested entries.
bool testMistakes(const SelftestOptions& options, const std::string& task,
                  const pipeline::Grader& grader, bool draw) {
    const Home home = Home::find();
    const Countdown counter{task.empty() ? "mistakes" : task, 0, draw};
    std::vector<corpus::Entry> entries =
        selftest::mistakesOf(catalogueOf(home, *grader.exercise), task);
    if (!options.cases.empty()) entries = selftest::mistakesCalled(entries, options.cases);
    selftest::MistakeRun run;
    run.fraction = options.cases.empty() ? options.fraction : 1.0;
    run.seed = seedOf(options.grade);
    run.exercise = grader.exercise;
    run.progress = [&](std::size_t done, std::size_t of) { counter.show(done, of); };
    const auto rows = selftest::runMistakes(entries, grader.kit, grader.sandbox, run);
    printTable((task.empty() ? "" : task + ": ") + "the catalogue of mistakes, compiled and judged",
               selftest::tableOf(rows));
    return std::ranges::all_of(rows, &selftest::MistakeRow::asExpected);
}

/// The whole corpus, or the requested entries.
std::vector<corpus::Entry> hostileCases(const Home& home, const std::vector<std::string>& wanted) {
    auto corpus = corpus::readEntries(home.data, {"hostile"});
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

bool testHostile(const SelftestOptions& options, pipeline::Grader grader, bool draw) {
    const Home home = Home::find();
    const Countdown counter{"hostile", 0, draw};
    grader.policy = sandbox::readPolicy(home.data / "grader/corpus/hostile/limits.json");
    selftest::HostileRun run;
    run.fraction = options.fraction;
    run.rounds = options.rounds;
    run.seed = seedOf(options.grade);
    run.progress = [&](std::size_t done, std::size_t of) { counter.show(done, of); };
    const selftest::HostileTables tables =
        selftest::runHostileTables(hostileCases(home, options.cases), grader, run);
    printTable("Hostile submissions at sandbox level " + sandbox::toString(grader.sandbox.level()),
               tables.table());
    return tables.passed();
}

bool testScreenshots(const SelftestOptions& options, const pipeline::Grader& grader, bool draw) {
    const Countdown counter{"screenshots", 0, draw};
    selftest::ScreenshotRun run;
    run.fraction = options.fraction;
    run.seed = seedOf(options.grade);
    run.progress = [&](std::size_t done, std::size_t of) { counter.show(done, of); };
    const selftest::ScreenshotSelfTest result = selftest::runScreenshotTables(
        {grader.scenes, grader.kit, grader.sandbox, rightSources(Home::find())}, run);
    printTable("Screenshots: honest ones, and others of every kind", result.table());
    return result.passed();
}

bool runTables(const SelftestOptions& options, bool draw) {
    const pipeline::Grader grader = makeGrader(options.grade);
    const bool isOther = grader.exercise != &defaultExercise();
    if (isOther || (!options.cases.empty() && !options.hostile))
        return testMistakes(options, options.task, grader, draw);
    const bool all = options.task.empty() && !options.hostile && !options.screenshots;
    bool good = true;
    for (const char* task : {"T1", "T2"})
        if (all || options.task == task) good = testMistakes(options, task, grader, draw) && good;
    if (all || options.task == "T1") good = testBump(options, draw) && good;
    if (all || options.hostile) good = testHostile(options, grader, draw) && good;
    if (all || options.screenshots) good = testScreenshots(options, grader, draw) && good;
    return good;
}

raytracer::ExitCode selftest(const SelftestOptions& options, const GlobalOptions& global) {
    return runTables(options, mayDraw(global.quiet)) ? raytracer::ExitCode::success
                                                     : raytracer::ExitCode::checkFailed;
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
    verb->add_option("--task", options->task, "Only the tables of T1, or of T2")
        ->check(CLI::IsMember({"T1", "T2"}));
    addExerciseOption(*verb, options->grade.exercise);
    verb->add_flag("--hostile", options->hostile, "Only the hostile submissions");
    verb->add_flag("--screenshots", options->screenshots, "Only the screenshots");
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
