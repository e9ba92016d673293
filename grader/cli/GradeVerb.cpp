#include <grader/cli/Batch.h>
#include <grader/cli/Formats.h>
#include <grader/cli/GradeOptions.h>
#include <grader/cli/Output.h>
#include <grader/cli/Progress.h>
#include <grader/cli/Verb.h>
#include <grader/report/Escape.h>
#include <grader/result/Names.h>

#include <CLI/CLI.hpp>

#include <fmt/core.h>
#include <algorithm>
#include <atomic>
#include <csignal>
#include <cstdio>
#include <map>
#include <memory>
#include <string>
#include <thread>
#include <vector>

namespace ticker::cli {
namespace {

// The one thing that a signal handler may touch.
std::atomic<bool> stopAsked{false};

extern "C" void askToStop(int /*signal*/) {
    stopAsked = true;
}

struct BatchOptions {
    std::vector<std::string> paths;
    std::string out;
    int workers = 0;
    bool expectFolders = false;
    bool single = false;
    GradeOptions grade;
    FormatOptions formats;
};

/// A path that is one submission, whatever is in it: a platform says so.
std::vector<intake::Located> wholePath(const std::string& path) {
    const std::filesystem::path whole = std::filesystem::absolute(path).lexically_normal();
    const std::string name = (whole.has_filename() ? whole : whole.parent_path()).filename();
    return {{name.empty() ? "submission" : name, whole}};
}

/// The submissions below all paths; a name that comes twice gets a number.
std::vector<intake::Located> locate(const BatchOptions& options) {
    std::vector<intake::Located> all;
    std::map<std::string, int> seen;
    for (const std::string& path : options.paths)
        for (intake::Located located :
             options.single ? wholePath(path) : intake::findSubmissions(path)) {
            const int before = seen[located.name]++;
            if (before > 0) located.name += fmt::format("-{}", before + 1);
            all.push_back(std::move(located));
        }
    if (all.empty())
        throw raytracer::InputError(options.paths.front(), 0,
                                    "no submission here; expected BumpySphere.cpp or Renderer.cpp "
                                    "in a folder, a zip, or a folder of such");
    return all;
}

/// For the sample class, whose folders are named after the verdicts they must get.
bool asItsFolderSays(const intake::Located& located, const SubmissionResult& result) {
    return located.path.parent_path().filename() == toString(result.verdict);
}

std::string closingLine(const std::vector<SubmissionResult>& results, const std::string& out) {
    std::map<Verdict, int> counts;
    for (const SubmissionResult& result : results)
        ++counts[result.verdict];
    std::string line = fmt::format("{} submissions:", results.size());
    for (const auto& [verdict, count] : counts)
        line += fmt::format(" {} {}", count, toString(verdict));
    return line + fmt::format("\nopen {}/index.html", out);
}

raytracer::ExitCode exitCodeOf(const std::vector<SubmissionResult>& results,
                               std::size_t unexpected) {
    if (stopAsked) return raytracer::ExitCode::interrupted;
    const bool ours = std::any_of(
        results.begin(), results.end(),
        [](const SubmissionResult& result) { return result.verdict == Verdict::notGraded; });
    if (ours) return raytracer::ExitCode::notGradable;
    return unexpected > 0 ? raytracer::ExitCode::checkFailed : raytracer::ExitCode::success;
}

raytracer::ExitCode grade(const BatchOptions& options, const Voice& voice) {
    const std::vector<intake::Located> submissions = locate(options);
    const pipeline::Grader grader = makeGrader(options.grade);
    const int cores = static_cast<int>(std::thread::hardware_concurrency());
    const int workers = options.workers > 0 ? options.workers : std::max(1, cores);
    std::signal(SIGINT, askToStop);
    std::signal(SIGTERM, askToStop);

    std::vector<SubmissionResult> results;
    std::size_t unexpected = 0;
    {
        Progress progress{submissions.size(), mayDraw(voice.quiet)};
        gradeAll(submissions, grader, seedOf(options.grade), workers, stopAsked,
                 [&](const intake::Located& located, const SubmissionResult& result) {
                     writeSubmission(options.out, result);
                     std::string line = tableLine(result);
                     if (options.expectFolders && !asItsFolderSays(located, result)) {
                         ++unexpected;
                         line += fmt::format("  [expected {}]",
                                             located.path.parent_path().filename().string());
                     }
                     progress.print(line);
                     progress.finished(result.verdict);
                     results.push_back(result);
                 });
    }
    std::ranges::sort(results, {}, &SubmissionResult::submission);
    writeClass(options.out, results);
    writeFormats(options.out, results, options.formats);
    if (!voice.quiet) fmt::print(stderr, "{}\n", closingLine(results, options.out));
    if (unexpected > 0)
        fmt::print(stderr, "ticker: {} of {} got another verdict than their folder says\n",
                   unexpected, results.size());
    return exitCodeOf(results, unexpected);
}

}  // namespace

Run addGrade(CLI::App& app, const Voice& voice) {
    auto options = std::make_shared<BatchOptions>();
    CLI::App* verb = app.add_subcommand("grade", "Judge submissions and write results and pages");
    verb->add_option("path", options->paths, "Folders with the files, zips, or folders of such")
        ->required();
    verb->add_option("-o,--output", options->out, "Folder for the results")->required();
    verb->add_option("--jobs", options->workers, "Submissions at a time; all cores if not given")
        ->check(CLI::PositiveNumber);
    verb->add_flag("--expect-folders", options->expectFolders,
                   "Exit 1 unless each verdict is the name of the folder that it lies in");
    verb->add_flag("--single", options->single,
                   "The path is one submission, whatever folders it holds");
    verb->add_option("--format", options->formats.names,
                     "Write these formats, too, as ticker report does")
        ->delimiter(',')
        ->check(CLI::IsMember(formatNames()));
    addFormatOptions(*verb, options->formats);
    addGradeOptions(*verb, options->grade);
    return [options, &voice] { return grade(*options, voice); };
}

}  // namespace ticker::cli
