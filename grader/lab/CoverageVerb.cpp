#include <grader/base/WholeFile.h>
#include <grader/cli/Home.h>
#include <grader/cli/ProgressLine.h>
#include <grader/cli/verbs/GradeOptions.h>
#include <grader/lab/LabVerbs.h>
#include <grader/lab/coverage/CoverageTables.h>

#include <CLI/CLI.hpp>

#include <fmt/core.h>

#include <memory>
#include <string>

namespace ticker::cli {
namespace {

struct CoverageOptions {
    std::string exercise;
    std::string only;
    std::string write;
    double fraction = 1.0;
    int jobs = 2;
};

/// Writes the text between the marks of a Markdown file.
void writeBetweenMarks(const std::string& text, const std::string& file) {
    const std::string begin = "<!-- public_coverage begin -->\n";
    const std::string end = "<!-- public_coverage end -->";
    std::string page = readWhole(file);
    const std::size_t from = page.find(begin);
    const std::size_t to = page.find(end);
    if (from == std::string::npos || to == std::string::npos || to < from)
        throw raytracer::InputError(file, 0, "expected the lines " + begin + " and " + end);
    writeAtomically(page.replace(from + begin.size(), to - from - begin.size(), text), file);
}

raytracer::ExitCode coverage(const CoverageOptions& options, const GlobalOptions& global) {
    const Countdown counter{"public tests", 0, mayDraw(global.quiet)};
    ticker::coverage::CoverageRun run;
    run.exercise = &exerciseNamed(options.exercise);
    run.only = options.only;
    run.fraction = options.fraction;
    run.jobs = options.jobs;
    run.progress = [&](std::size_t done, std::size_t of) { counter.show(done, of); };
    const ticker::coverage::Coverage found = ticker::coverage::measure(Home::find().data, run);
    if (options.write.empty())
        fmt::print("{}", found.text);
    else
        writeBetweenMarks(found.text, options.write);
    for (const std::string& line : found.refused)
        fmt::print(stderr, "{}\n", line);
    return found.refused.empty() ? raytracer::ExitCode::success : raytracer::ExitCode::checkFailed;
}

}  // namespace

Run addCoverage(CLI::App& app, const GlobalOptions& global) {
    auto options = std::make_shared<CoverageOptions>();
    CLI::App* verb = app.add_subcommand(
        "coverage", "Which known mistakes the public tests notice; all right solutions must pass");
    addExerciseOption(*verb, options->exercise);
    verb->add_option("--only", options->only, "Cases whose name contains it");
    verb->add_option("--fraction", options->fraction, "Share of the cases to run")
        ->check(CLI::Range(0.0, 1.0));
    verb->add_option("--jobs", options->jobs, "Threads")->check(CLI::Range(1, 256));
    verb->add_option("--write", options->write, "Markdown file with marks for the tables");
    return [options, &global] { return coverage(*options, global); };
}

}  // namespace ticker::cli
