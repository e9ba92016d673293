#include <grader/base/WholeFile.h>
#include <grader/cli/Output.h>
#include <grader/cli/verbs/GradeOptions.h>
#include <grader/cli/verbs/Verb.h>
#include <grader/intake/Intake.h>
#include <grader/report/ReportWords.h>
#include <grader/result/AppealNumber.h>
#include <grader/store/ClassFolder.h>

#include <raytracer/base/Error.h>

#include <CLI/CLI.hpp>

#include <fmt/core.h>

#include <filesystem>
#include <memory>
#include <string>
#include <system_error>

namespace ticker::cli {
namespace {

namespace fs = std::filesystem;

struct AppealOptions {
    std::string number;
    std::string out;
    std::string sandbox = "auto";
};

SubmissionResult resultWith(const std::string& number, const fs::path& out) {
    std::vector<SubmissionResult> found = readResults(out);
    std::erase_if(found, [&](const SubmissionResult& one) { return appealNumber(one) != number; });
    if (found.size() == 1) return std::move(found.front());
    throw raytracer::InputError(
        out.string(), 0,
        fmt::format("{} of its results have the number {}; expected one, as the student's page "
                    "shows it (\"1234-5678\")",
                    found.size(), number));
}

/// The files of a result as they were handed in, in a folder of their own.
fs::path handedIn(const fs::path& folder, const fs::path& appeal) {
    const fs::path copy = appeal / "handed-in";
    std::error_code ignored;
    fs::remove_all(copy, ignored);
    fs::create_directories(copy, ignored);
    fs::copy(folder / "code", copy, ignored);
    const fs::path picture = folder / std::string{report::kScreenshotFile};
    if (fs::is_regular_file(picture, ignored)) fs::copy_file(picture, copy / "screenshot.png");
    return copy;
}

raytracer::ExitCode appeal(const AppealOptions& options) {
    const SubmissionResult first = resultWith(options.number, options.out);
    const fs::path appeal = fs::path{options.out} / first.submission / "appeal";
    const fs::path folder = handedIn(appeal.parent_path(), appeal);
    GradeOptions grade;
    grade.exercise = exerciseOf(first).name;
    grade.sandbox = options.sandbox;
    pipeline::Grader grader = makeGrader(grade);
    grader.isAlone = true;
    auto located = intake::findSubmissions(folder, *grader.exercise);
    if (located.size() != 1)
        throw raytracer::InputError(folder.string(), 0, "holds no files that could be graded");
    located.front().name = first.submission;
    fmt::print("first            {}\n", tableLine(first));
    bool isGraded = true;
    for (const bool isFresh : {false, true}) {
        const SubmissionResult again = pipeline::gradeSubmission(
            intake::readSubmission(located.front(), {.exercise = grader.exercise}), grader,
            isFresh ? seedOf({}) : first.seed);
        const fs::path target = appeal / (isFresh ? "fresh-questions" : "same-questions");
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
    verb->add_option("--sandbox", options->sandbox, "A, B, C or auto: the best of this machine");
    return [options] { return appeal(*options); };
}

}  // namespace ticker::cli
