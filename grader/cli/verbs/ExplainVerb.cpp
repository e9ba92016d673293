#include <grader/cli/Explained.h>
#include <grader/cli/verbs/GradeOptions.h>
#include <grader/cli/verbs/Verb.h>
#include <grader/intake/Intake.h>
#include <grader/repair/Explain.h>
#include <grader/report/Escape.h>
#include <grader/report/ReportWords.h>
#include <grader/store/ClassFolder.h>

#include <CLI/CLI.hpp>

#include <fmt/core.h>
#include <algorithm>
#include <filesystem>
#include <memory>
#include <set>
#include <string>
#include <system_error>
#include <vector>

namespace ticker::cli {
namespace {

struct ExplainOptions {
    std::string folder;
    GradeOptions grade;
};

constexpr const char* kNothingToMend =
    "No task failed in a way that an edit of its code could mend.\n";

void printLines(char mark, const std::string& text) {
    for (std::size_t at = 0; at <= text.size();) {
        const std::size_t end = std::min(text.find('\n', at), text.size());
        fmt::print("    {} {}\n", mark, report::escapeLine(text.substr(at, end - at)));
        at = end + 1;
    }
}

void print(const Repair& repair) {
    for (const RepairEdit& edit : repair.edits) {
        fmt::print("  {}, line {}\n", repair.file, edit.line);
        printLines('-', edit.from);
        if (!edit.to.empty()) printLines('+', edit.to);
    }
    if (repair.next.empty())
        fmt::print("  proven: passes all questions under three seeds\n");
    else
        fmt::print("  proven: with this, the next finding is {}\n", repair.next);
}

void print(const TaskReport& task, const SubmissionResult& result) {
    fmt::print("{} {}: {}\n", task.id, task.title,
               task.findings.empty() ? "" : task.findings.front().id);
    bool isFirst = true;
    for (const Repair& repair : result.repairs.value_or(std::vector<Repair>{})) {
        if (repair.task != task.id || !repair.proven) continue;
        if (!isFirst) fmt::print("  or\n");
        print(repair);
        isFirst = false;
    }
    if (isFirst && result.repairs)
        fmt::print("  no small edit of the code was found that mends this\n");
}

// A reason that several tasks share is printed once.
void printBlocked(const SubmissionResult& result, const std::string& command) {
    std::set<std::string> said;
    for (const TaskReport& task : result.tasks)
        if (task.state == TaskState::blocked && said.insert(task.reason).second)
            fmt::print("{}: {}: {}\n", task.id, report::wordsFor(task),
                       report::escapeLine(task.reason));
    if (!said.empty()) fmt::print("{} check shows the whole diagnosis.\n", command);
}

void printRepairs(const SubmissionResult& result, const std::string& command) {
    bool anyFailed = false;
    for (const TaskReport& task : result.tasks) {
        if (!repair::isExplainable(task)) continue;
        anyFailed = true;
        print(task, result);
    }
    if (!anyFailed) fmt::print(kNothingToMend);
    printBlocked(result, command);
    for (const std::string& notice : result.notices)
        fmt::print("note: {}\n", report::escapeLine(notice));
}

/// What a class's results say.
void printClass(const std::filesystem::path& out, const std::string& command) {
    const std::vector<store::ClassEntry> entries = store::readClass(out);
    bool anyPrinted = false;
    std::size_t unsearched = 0;
    for (const store::ClassEntry& entry : entries) {
        if (wantsRepairs(entry.result)) ++unsearched;
        if (!entry.result.repairs) continue;
        anyPrinted = true;
        fmt::print("{}\n", report::escapeLine(entry.result.submission));
        printRepairs(entry.result, command);
    }
    if (unsearched > 0)
        fmt::print(stderr,
                   "no edits were looked for in {} of {}; {} grade with --explain failed --resume "
                   "looks for them\n",
                   unsearched, report::counted(entries.size(), "submission"), command);
    else if (!anyPrinted)
        fmt::print(kNothingToMend);
}

raytracer::ExitCode explain(const ExplainOptions& options, const std::string& command) {
    std::error_code ignored;
    if (std::filesystem::exists(std::filesystem::path{options.folder} / "results.sqlite",
                                ignored)) {
        printClass(options.folder, command);
        return raytracer::ExitCode::success;
    }
    pipeline::Grader grader = makeGrader(options.grade);
    grader.isAlone = true;
    const auto found = intake::findSubmissions(options.folder, *grader.exercise);
    if (found.size() != 1)
        throw raytracer::InputError(
            options.folder, 0,
            fmt::format("{} here; explain takes one ({} grade --explain failed takes many)",
                        report::counted(found.size(), "submission"), command));
    const intake::Submission submission =
        intake::readSubmission(found.front(), {.exercise = grader.exercise});
    SubmissionResult result = pipeline::gradeSubmission(submission, grader, seedOf(options.grade));
    addRepairs(submission, grader, result);
    printRepairs(result, command);
    return result.verdict == Verdict::notGraded ? raytracer::ExitCode::notGradable
                                                : raytracer::ExitCode::success;
}

}  // namespace

Run addExplain(CLI::App& app, const GlobalOptions& global) {
    auto options = std::make_shared<ExplainOptions>();
    CLI::App* verb = app.add_subcommand(
        "explain", "The lines of a failing submission, with edits that are proven to mend it");
    verb->add_option("folder", options->folder,
                     "Folder or zip with the files; or the OUT of a class that was graded with "
                     "--explain failed")
        ->required();
    addGradeOptions(*verb, options->grade);
    return [options, &global] { return explain(*options, global.command); };
}

}  // namespace ticker::cli
