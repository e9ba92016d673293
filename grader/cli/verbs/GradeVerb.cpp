#include <grader/base/ShellQuoted.h>
#include <grader/cli/Batch.h>
#include <grader/cli/ClassPaths.h>
#include <grader/cli/ClassRun.h>
#include <grader/cli/Explained.h>
#include <grader/cli/Formats.h>
#include <grader/cli/Interrupt.h>
#include <grader/cli/Output.h>
#include <grader/cli/ProgressLine.h>
#include <grader/cli/verbs/GradeOptions.h>
#include <grader/cli/verbs/StudentPages.h>
#include <grader/cli/verbs/Verb.h>
#include <grader/report/ReportWords.h>
#include <grader/result/Names.h>
#include <grader/store/ClassFolder.h>

#include <CLI/CLI.hpp>

#include <fmt/core.h>
#include <sys/resource.h>
#include <algorithm>
#include <atomic>
#include <cstdint>
#include <cstdio>
#include <memory>
#include <optional>
#include <string>
#include <thread>
#include <utility>
#include <vector>

namespace ticker::cli {
namespace {

struct BatchOptions {
    ClassPaths from;
    std::string out;
    int workers = 0;
    bool expectFolders = false;
    bool resume = false;
    bool resultsOnly = false;
    std::string share;
    std::vector<std::string> regrade;
    std::string explain;
    GradeOptions grade;
    FormatOptions formats;

    [[nodiscard]] bool keepsResults() const { return resume || !regrade.empty(); }
};

/// Whether the verdict is the one in the folder's name, as in the sample class.
bool asItsFolderSays(const intake::Located& located, const SubmissionResult& result) {
    return located.path.parent_path().filename() == toString(result.verdict);
}

/// Whether a repeated command grades again what this run has graded: "older" alone concerns no
/// result of today's ticker.
bool gradesAgain(const BatchOptions& options) {
    return std::ranges::any_of(options.regrade,
                               [](const std::string& word) { return word != "older"; });
}

/// The command that continues a stopped run. Without a store the seed is stored nowhere, so that
/// the command names it.
std::string commandToGoOn(const BatchOptions& options, const GlobalOptions& global,
                          std::uint64_t seed) {
    const bool needsSeed = options.resultsOnly && !options.grade.seed;
    return global.commandLine + (needsSeed ? fmt::format(" --seed {}", seed) : "") +
           (options.resume ? "" : " --resume");
}

void report(const RunCounts& counts, std::size_t total, const BatchOptions& options,
            const GlobalOptions& global, bool stopped, std::uint64_t seed) {
    if (!global.quiet) fmt::print(stderr, "{}\n", closingLine(counts));
    if (!global.quiet && !options.resultsOnly)
        fmt::print(stderr, "open {}, or decide in a browser: {} session {}\n",
                   shellQuoted(options.out + "/index.html"), global.command,
                   shellQuoted(options.out));
    if (counts.unexpected > 0)
        fmt::print(stderr, "ticker: {} of {} got another verdict than their folder says\n",
                   counts.unexpected, counts.all());
    if (!counts.notAnew.empty()) fmt::print(stderr, "ticker: {}\n", notAnewLine(counts));
    if (stopped && counts.all() == total)
        fmt::print(stderr, "ticker: stopped, but everything was graded: nothing is left to do\n");
    else if (stopped)
        fmt::print(stderr, "ticker: stopped after {} of {}; they are kept{}. Go on with\n  {}\n",
                   counts.all(), total,
                   gradesAgain(options) ? ", but --regrade grades those that it names again" : "",
                   commandToGoOn(options, global, seed));
}

/// The first reason of the grader's own in a result.
std::string whyNotGraded(const SubmissionResult& result) {
    for (const TaskReport& task : result.tasks)
        if (task.state == TaskState::notGraded) return task.reason;
    return "";
}

/// Prints and counts one result.
void take(const intake::Located& located, const SubmissionResult& result, Stored stored,
          const BatchOptions& options, Progress& progress, RunCounts& counts) {
    const bool isKept = stored == Stored::kept;
    std::string line = tableLine(result);
    if (isKept) line += "  [kept]";
    if (stored == Stored::before) {
        line += "  [the earlier result stays]";
        if (counts.notAnew.empty()) counts.whyNotAnew = whyNotGraded(result);
        counts.notAnew.push_back(result.submission);
    }
    if (options.expectFolders && !asItsFolderSays(located, result)) {
        ++counts.unexpected;
        line += fmt::format("  [expected {}]", located.path.parent_path().filename().string());
    }
    progress.print(line);
    progress.finished(result.verdict, isKept);
    ++counts.verdicts[result.verdict];
    if (isKept) ++counts.kept;
}

/// Peak memory of this process, without children.
long peakMegabytes() {
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    return usage.ru_maxrss / 1024;
}

int workersOf(const BatchOptions& options) {
    const int cores = static_cast<int>(std::thread::hardware_concurrency());
    return options.workers > 0 ? options.workers : std::max(1, cores);
}

void warnOfStore(const ClassRun& run, const BatchOptions& options, const GlobalOptions& global) {
    if (!run.notice().empty()) fmt::print(stderr, "ticker: {}\n", run.notice());
    const std::size_t earlier = run.size();
    if (!global.quiet && earlier > 0 && !options.keepsResults() && !options.grade.seed)
        fmt::print(stderr,
                   "ticker: {} holds {}; all are made anew with a fresh seed (--resume "
                   "keeps them)\n",
                   options.out, report::counted(earlier, "result"));
}

/// What a batch does with each submission. All arguments outlive the batch.
BatchHooks hooksOf(ClassRun& run, const pipeline::Grader& grader, const BatchOptions& options,
                   Progress& progress, RunCounts& counts) {
    return {.known = [&](const intake::Located& located,
                         const Inputs& inputs) -> std::optional<SubmissionResult> {
                auto known = run.known(located.name, inputs);
                const bool isWhole = options.explain.empty() || (known && !wantsRepairs(*known));
                return isWhole ? std::move(known) : std::nullopt;
            },
            .complete =
                [&](const intake::Submission& submission, SubmissionResult& result) {
                    if (!options.explain.empty()) addRepairs(submission, grader, result);
                },
            .write = [&](const SubmissionResult& result) { run.write(result); },
            .take =
                [&](const intake::Located& located, const SubmissionResult& result, bool isKept) {
                    take(located, result, run.index(result, isKept), options, progress, counts);
                }};
}

/// Writes what is made of the whole class: the tables and the students' pages, for which a store is
/// needed, and the formats.
void writeWhole(const ClassRun& run, const BatchOptions& options) {
    const bool hasClass = run.size() > 0;
    const bool hasFormats = !options.formats.names.empty();
    if (!hasClass && !hasFormats) return;
    const std::vector<store::ClassEntry> entries = store::readClass(options.out);
    if (hasClass) {
        writeClass(options.out, entries);
        writeStudentPages(options.out, entries, options.formats.studentView);
    }
    if (hasFormats)
        writeFormats(options.out, entries, options.formats);
    else
        warnOfStale(entries, options.formats.decidedOnly);
}

raytracer::ExitCode grade(const BatchOptions& options, const GlobalOptions& global) {
    std::vector<intake::Located> submissions = locate(options.from);
    expectOneExercise(options.from, submissions);
    if (!options.share.empty()) submissions = shareOf(std::move(submissions), options.share);
    const std::string skipped = skippedLine(options.from);
    pipeline::Grader grader = makeGrader(options.grade);
    grader.isAlone = submissions.size() == 1;
    ClassRun run{
        options.out, *grader.exercise, {options.regrade, grader.build}, !options.resultsOnly};
    run.checkRegrade(submissions);
    warnOfStore(run, options, global);
    const std::uint64_t seed =
        run.settleSeed(options.grade.seed, options.keepsResults(), seedOf(options.grade));
    const std::atomic<bool>& stop = catchInterrupts();

    RunCounts counts;
    {
        Progress progress{submissions.size(), mayDraw(global.quiet)};
        gradeAll(submissions, grader, seed, workersOf(options), stop,
                 hooksOf(run, grader, options, progress, counts));
    }
    writeWhole(run, options);
    report(counts, submissions.size(), options, global, stop, seed);
    if (!skipped.empty()) fmt::print(stderr, "ticker: {}\n", skipped);
    if (global.verbose) fmt::print(stderr, "peak memory {} MB\n", peakMegabytes());
    return exitCodeOf(counts, stop);
}

}  // namespace

Run addGrade(CLI::App& app, const GlobalOptions& global) {
    auto options = std::make_shared<BatchOptions>();
    CLI::App* verb = app.add_subcommand("grade", "Judge submissions and write results and pages");
    verb->add_option("path", options->from.paths,
                     "Folders with the files, zips, folders of such, or a Moodle export")
        ->required();
    verb->add_option("-o,--output", options->out, "Folder for the results")->required();
    verb->add_option("--jobs", options->workers, "Submissions at a time; all cores if not given")
        ->check(CLI::PositiveNumber);
    verb->add_flag("--expect-folders", options->expectFolders,
                   "Exit 1 unless each verdict is the name of the folder that it lies in");
    verb->add_flag("--resume", options->resume,
                   "Keep the results in OUT whose inputs have not changed; grade the rest");
    verb->add_option("--regrade", options->regrade,
                     "Keep what is in OUT, but grade again: all, older (graded by another ticker "
                     "than this), a submission, or all with a finding");
    verb->add_option("--explain", options->explain,
                     "failed: look for edits that are proven to mend failed tasks")
        ->check(CLI::IsMember({"failed"}));
    verb->add_flag("--results-only", options->resultsOnly,
                   "Write the submissions' folders alone, for a node of a cluster; ticker collect "
                   "takes them in");
    verb->add_option("--share", options->share,
                     "I/N: every N-th submission alone, beginning with the I-th, for a task of a "
                     "cluster");
    verb->add_flag("--single", options->from.single,
                   "The path is one submission, whatever folders it holds");
    verb->add_option("--format", options->formats.names,
                     "Write these formats, too, as ticker report does")
        ->delimiter(',')
        ->check(CLI::IsMember(formatNames()));
    addFormatOptions(*verb, options->formats);
    addGradeOptions(*verb, options->grade);
    return [options, &global] {
        options->from.exercise = &exerciseNamed(options->grade.exercise);
        options->from.out = options->out;
        return grade(*options, global);
    };
}

}  // namespace ticker::cli
