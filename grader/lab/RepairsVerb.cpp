#include <grader/base/Workers.h>
#include <grader/build/Kit.h>
#include <grader/cli/Home.h>
#include <grader/cli/Progress.h>
#include <grader/cli/verbs/GradeOptions.h>
#include <grader/cli/verbs/Verb.h>
#include <grader/corpus/Entry.h>
#include <grader/lab/LabVerbs.h>
#include <grader/lab/repairs/RepairTables.h>

#include <CLI/CLI.hpp>

#include <fmt/core.h>
#include <fstream>
#include <memory>
#include <string>

namespace ticker::cli {
namespace {

struct RepairsOptions {
    std::string task;
    double fraction = 1.0;
    std::string write;
    GradeOptions grade;
};

raytracer::ExitCode repairs(const RepairsOptions& options, const GlobalOptions& global) {
    const Home home = Home::find();
    pipeline::Grader grader = makeGrader(options.grade);
    const Countdown counter{"repairs", 0, mayDraw(global.quiet)};
    lab::RepairRun run;
    run.fraction = options.fraction;
    run.seed = seedOf(options.grade);
    run.progress = [&](std::size_t done, std::size_t of) { counter.show(done, of); };
    const auto rows =
        lab::runRepairs(corpus::readEntries(home.data, {"mistakes", "unseen", "samples"}),
                        options.task, grader, run);
    fmt::print("{}\n{}", lab::listOf(rows), lab::tableOf(rows));
    if (!options.write.empty()) std::ofstream{options.write} << lab::documentOf(rows);
    return raytracer::ExitCode::success;
}

}  // namespace

Run addRepairsLab(CLI::App& app, const GlobalOptions& global) {
    auto options = std::make_shared<RepairsOptions>();
    constexpr std::uint64_t kUsualSeed = 1;
    options->grade.seed = kUsualSeed;
    CLI::App* verb = app.add_subcommand(
        "repairs", "How many mistakes of the corpus are explained by a proven edit, and where");
    verb->add_option("--task", options->task, "Only mistakes of this task");
    verb->add_option("--fraction", options->fraction, "Share of the entries to run")
        ->check(CLI::Range(0.0, 1.0));
    verb->add_option("--write", options->write, "Writes the tables as a document");
    addGradeOptions(*verb, options->grade);
    return [options, &global] { return repairs(*options, global); };
}

}  // namespace ticker::cli
