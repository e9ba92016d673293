#include <grader/cli/Home.h>
#include <grader/cli/verbs/GradeOptions.h>
#include <grader/cli/verbs/Verb.h>
#include <grader/intake/Intake.h>
#include <grader/report/Escape.h>
#include <grader/report/ReportWords.h>
#include <grader/report/student/StudentView.h>
#include <grader/result/Names.h>

#include <CLI/CLI.hpp>

#include <fmt/core.h>
#include <algorithm>
#include <memory>
#include <string>

namespace ticker::cli {
namespace {

struct CheckOptions {
    std::string folder;
    std::string audience = "staff";
    GradeOptions grade;
};

void print(const Finding& finding) {
    fmt::print("  {} {}\n    {}\n", toString(finding.severity), finding.id,
               report::escapeLine(finding.message));
    if (!finding.hint.empty()) fmt::print("    Hint: {}\n", report::escapeLine(finding.hint));
    if (!finding.section.empty()) fmt::print("    Handout: {}\n", finding.section);
}

void print(const SubmissionResult& result) {
    for (const TaskReport& task : result.tasks) {
        fmt::print("{}: {}{}\n", report::taskName(task), report::wordsFor(task),
                   task.reason.empty() ? "" : ": " + report::escapeLine(task.reason));
        for (const Finding& finding : task.findings)
            print(finding);
    }
    for (const Diagnostics& said : result.diagnostics)
        if (!said.text.empty())
            fmt::print("\nWhat the compiler said about {}:\n{}\n", said.file, cleanText(said.text));
    for (const std::string& notice : result.notices)
        fmt::print("note: {}\n", report::escapeLine(notice));
    fmt::print("\n{}: {}\n", report::escapeLine(result.submission),
               report::wordsFor(result.verdict));
}

/// Prints what the course's policy shows to a student.
void printForStudent(const SubmissionResult& result) {
    const report::StudentPolicy policy = report::readStudentPolicy(Home::find().studentView());
    fmt::print("{}\n", report::wholeText(report::StudentView{result, policy}));
}

raytracer::ExitCode check(const CheckOptions& options, const GlobalOptions& global) {
    pipeline::Grader grader = makeGrader(options.grade);
    grader.isAlone = true;
    const auto found = intake::findSubmissions(options.folder, *grader.exercise);
    if (found.size() != 1)
        throw raytracer::InputError(
            options.folder, 0,
            fmt::format("{} here; check takes one ({} grade takes many)",
                        report::counted(found.size(), "submission"), global.command));
    const SubmissionResult result = pipeline::gradeSubmission(
        intake::readSubmission(found.front(), {.exercise = grader.exercise}), grader,
        seedOf(options.grade));
    if (options.audience == "student")
        printForStudent(result);
    else
        print(result);
    if (result.verdict == Verdict::notGraded) return raytracer::ExitCode::notGradable;
    const bool allGood =
        std::all_of(result.tasks.begin(), result.tasks.end(), [](const TaskReport& task) {
            return task.state == TaskState::passed || task.state == TaskState::notAttempted ||
                   isNotChecked(task);
        });
    return allGood ? raytracer::ExitCode::success : raytracer::ExitCode::checkFailed;
}

}  // namespace

Run addCheck(CLI::App& app, const GlobalOptions& global) {
    auto options = std::make_shared<CheckOptions>();
    CLI::App* verb = app.add_subcommand("check", "The full diagnosis of one submission, as text");
    verb->add_option("folder", options->folder, "Folder or zip with the files")->required();
    verb->add_option("--audience", options->audience,
                     "Who reads it; student: what the policy in student-view.json allows")
        ->check(CLI::IsMember({"staff", "student"}));
    addGradeOptions(*verb, options->grade);
    return [options, &global] { return check(*options, global); };
}

}  // namespace ticker::cli
