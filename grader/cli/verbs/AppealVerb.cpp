#include <grader/base/WholeFile.h>
#include <grader/cli/Output.h>
#include <grader/cli/verbs/GradeOptions.h>
#include <grader/cli/verbs/Verb.h>
#include <grader/intake/Submission.h>
#include <grader/pipeline/InputDigests.h>
#include <grader/report/Escape.h>
#include <grader/result/AppealNumber.h>
#include <grader/store/ClassFolder.h>

#include <raytracer/base/Error.h>

#include <CLI/CLI.hpp>

#include <fmt/core.h>

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <system_error>
#include <vector>

namespace ticker::cli {
namespace {

namespace fs = std::filesystem;

struct AppealOptions {
    std::string number;
    std::string out;
    std::string submission;  ///< empty: the one that has the number
    GradeOptions grade;
};

std::string namesOf(const std::vector<SubmissionResult>& results) {
    std::string names;
    for (const SubmissionResult& result : results)
        names += (names.empty() ? "" : ", ") + report::escapeLine(result.submission);
    return names;
}

/// Eight digits are few: in a class of thousands two results may have the same.
SubmissionResult resultWith(const AppealOptions& options) {
    std::vector<SubmissionResult> found = readResults(options.out);
    std::erase_if(found, [&](const SubmissionResult& one) {
        return appealNumber(one) != options.number ||
               (!options.submission.empty() && one.submission != options.submission);
    });
    if (found.size() == 1) return std::move(found.front());
    const std::string of =
        options.submission.empty() ? "" : " of " + report::escapeLine(options.submission);
    throw raytracer::InputError(
        options.out, 0,
        found.empty()
            ? fmt::format("0 of its results{} have the number {}; expected one, as the student's "
                          "page shows it (\"1234-5678\")",
                          of, options.number)
            : fmt::format("{} of its results have the number {}: {}; --submission NAME says which "
                          "one is meant",
                          found.size(), options.number, namesOf(found)));
}

/// Verdicts can only be compared if they were made in the same way. The level of the sandbox does
/// not change a verdict, so that it may differ: the digest is made with the first grading's level.
void expectSameWay(const SubmissionResult& first, const pipeline::Grader& grader,
                   const fs::path& folder) {
    if (first.inputs.how != pipeline::howDigest(grader, first.sandboxLevel, first.seed))
        throw raytracer::InputError((folder / "result.json").string(), 0,
                                    "was graded with another --rubric or --option than these; give "
                                    "the ones of its grading");
    if (first.inputs.tool != grader.build)
        fmt::print(stderr,
                   "ticker: another build of ticker graded {}; the questions of this one may "
                   "differ\n",
                   report::escapeLine(first.submission));
}

std::optional<std::string> keptBytes(const fs::path& file) {
    std::error_code ignored;  // readWhole reports a file that cannot be looked at
    const bool isMissing = fs::status(file, ignored).type() == fs::file_type::not_found;
    return isMissing ? std::nullopt : std::optional{readWhole(file)};
}

/// Intake's refusals in the first grading. A refused file was not stored: its tasks are blocked,
/// and the part is missing here.
std::vector<intake::IntakeFinding> refusalsIn(const SubmissionResult& first,
                                              const intake::Submission& kept,
                                              const Exercise& exercise) {
    std::vector<intake::IntakeFinding> refusals;
    for (const TaskReport& task : first.tasks) {
        const std::string part{task.id == kScreenshotTask ? kScreenshotPart
                                                          : exercise.fileOf(task.id)};
        if (task.state == TaskState::blocked && !task.findings.empty() && !kept.part(part))
            refusals.push_back({part, task.findings.front()});
    }
    return refusals;
}

/// The submission as intake had read it: the questions depend on its bytes.
intake::Submission handedIn(const SubmissionResult& first, const fs::path& folder,
                            const Exercise& exercise) {
    const fs::path picture = keptScreenshot(folder);
    std::error_code ignored;
    if (!first.inputs.areKnown() || !fs::is_directory(folder / "code", ignored) ||
        !fs::is_directory(picture.parent_path(), ignored))
        throw raytracer::InputError(
            folder.string(), 0,
            fmt::format("does not hold all that was handed in: it was not graded, or by an older "
                        "ticker. Grade the hand-in itself, with --seed {} for the same questions "
                        "and another -o",
                        first.seed));
    intake::Submission submission;
    submission.name = first.submission;
    for (const std::string& file : exercise.files())
        submission.parts[file] = keptBytes(folder / "code" / file);
    if (exercise.hasScreenshot())
        submission.parts[std::string{kScreenshotPart}] = keptBytes(picture);
    submission.findings = refusalsIn(first, submission, exercise);
    return submission;
}

raytracer::ExitCode appeal(const AppealOptions& options) {
    const SubmissionResult first = resultWith(options);
    const fs::path folder = fs::path{options.out} / first.submission;
    GradeOptions grade = options.grade;
    grade.exercise = exerciseOf(first).name;
    pipeline::Grader grader = makeGrader(grade);
    grader.isAlone = true;
    const intake::Submission submission = handedIn(first, folder, *grader.exercise);
    expectSameWay(first, grader, folder);
    fmt::print("first            {}\n", tableLine(first));
    bool isGraded = true;
    for (const bool isFresh : {false, true}) {
        const SubmissionResult again =
            pipeline::gradeSubmission(submission, grader, isFresh ? seedOf({}) : first.seed);
        const fs::path target =
            folder / "appeal" / (isFresh ? "fresh-questions" : "same-questions");
        writeSubmission(target, again);
        fmt::print("{} {}\n  {}\n", isFresh ? "fresh questions " : "same questions  ",
                   tableLine(again), (target / first.submission / "report.html").string());
        isGraded = isGraded && again.verdict != Verdict::notGraded;
    }
    return isGraded ? raytracer::ExitCode::success : raytracer::ExitCode::notGradable;
}

}  // namespace

Run addAppeal(CLI::App& app, const GlobalOptions& /*global*/) {
    auto options = std::make_shared<AppealOptions>();
    CLI::App* verb = app.add_subcommand(
        "appeal", "Grade a result again, with the same questions and with fresh ones");
    verb->add_option("number", options->number, "The number on the student's page")->required();
    verb->add_option("out", options->out, "Folder that ticker grade wrote")->required();
    verb->add_option("--submission", options->submission,
                     "Name of the submission, where more than one has the number");
    addJudgingOptions(*verb, options->grade);
    return [options] { return appeal(*options); };
}

}  // namespace ticker::cli
