#include <grader/pipeline/Grade.h>

#include <grader/pipeline/DrawRasters.h>
#include <grader/pipeline/FileWork.h>
#include <grader/pipeline/Inputs.h>
#include <grader/pipeline/Questioning.h>
#include <grader/pipeline/Screenshot.h>
#include <grader/tasks/bump/BumpPicture.h>
#include <grader/tasks/bump/JudgeBump.h>
#include <grader/tasks/lens/JudgeLens.h>
#include <grader/tasks/lens/PictureDoubt.h>
#include <grader/tasks/shadows/JudgeShadows.h>

#include <algorithm>
#include <chrono>
#include <future>
#include <iterator>
#include <utility>

namespace ticker::pipeline {
namespace {

using build::SourceFile;
using tasks::TaskJudgement;

using Clock = std::chrono::steady_clock;

double millisecondsSince(Clock::time_point start) {
    return std::chrono::duration<double, std::milli>(Clock::now() - start).count();
}

void settle(TaskReport& task, TaskJudgement judgement) {
    if (!isOpen(task)) return;
    task.state = judgement.state;
    task.reason = std::move(judgement.reason);
    task.findings = std::move(judgement.findings);
    task.needsReview = judgement.needsReview;
    task.plots = std::move(judgement.plots);
    task.rasters = std::move(judgement.rasters);
}

/// @return  What option 2's answers show of the aperture, see `TaskJudgement`.
std::optional<double> judge(FileWork& work, SourceFile file, Questioning& questioning,
                            std::uint64_t seed) {
    if (file == SourceFile::bumpySphere) {
        settle(work.tasks.at(0), questioning.run([&](probe::Examinee& examinee) {
            return tasks::judgeBump(examinee, seed);
        }));
        return std::nullopt;
    }
    auto shadows = questioning.begin([seed, open = isOpen(work.tasks.at(0))](auto& examinee) {
        return open ? tasks::judgeShadows(examinee, seed) : TaskJudgement{};
    });
    auto lens = questioning.run([&](probe::Examinee& examinee) {
        return isOpen(work.tasks.at(1)) ? tasks::judgeLens(examinee, seed) : TaskJudgement{};
    });
    settle(work.tasks.at(0), shadows.get());
    const std::optional<double> aperture = lens.apertureFactor;
    settle(work.tasks.at(1), std::move(lens));
    return aperture;
}

void doubt(std::vector<TaskReport>& tasks, bool isT1, const Gallery& rendered,
           const std::optional<double>& aperture) {
    if (isT1)
        tasks::doubtBumps(tasks.at(0), rendered.bumpMisfit);
    else
        tasks::doubtPicture(tasks, rendered.misfits, aperture);
}

bool isBlocked(const TaskReport& task) {
    return task.state == TaskState::blocked;
}

bool isNotAttempted(const TaskReport& task) {
    return task.state == TaskState::notAttempted;
}

TaskReport refused(const Finding& refusal) {
    TaskReport report = blankReport("screenshot");
    report.state = TaskState::blocked;
    report.reason = refusal.message;
    report.findings = {refusal};
    report.needsReview = true;
    return report;
}

/// A forbidden call blocks the file's tasks, also where every question was answered before it.
void blockForbidden(std::vector<TaskReport>& tasks) {
    for (TaskReport& task : tasks) {
        if (task.state != TaskState::passed && task.state != TaskState::failed) continue;
        task.state = TaskState::blocked;
        task.needsReview = false;  // the kernel's word leaves no doubt
        task.findings.insert(task.findings.begin(), forbiddenCallFinding());
        task.reason = task.findings.front().message;
    }
}

/// Grades one file after the other, then the picture, into one result.
class Grading {
public:
    Grading(const intake::Submission& submission, const Grader& grader, std::uint64_t seed)
        : submission_(submission),
          grader_(grader),
          seed_(questionSeed(submission, seed)),
          budget_(grader.policy.submission) {}

    void file(SourceFile file, SubmissionResult& result) {
        const bool isT1 = file == SourceFile::bumpySphere;
        std::future<void> expectations;
        if (grader_.isAlone && hasFile(file))
            expectations =
                std::async(std::launch::async, [&] { prepareExpectations(grader_.scenes, isT1); });
        FileWork work = prepareFile(submission_, file, grader_);
        JudgedFile judged{file, false, std::nullopt, {}};
        result.timing.compileMs += work.compileMs;
        if (work.program) {
            Questioning questioning{*work.program, grader_, budget_};
            auto gallery = questioning.begin([&](probe::Examinee& examinee) {
                return renderSpecScenes(grader_.scenes, isT1, examinee);
            });
            const std::optional<double> aperture = judge(work, file, questioning, seed_);
            // Code that crashed or loops would do so again.
            const bool isUsable = std::ranges::none_of(work.tasks, isBlocked);
            if (isUsable) {
                Gallery rendered = gallery.get();
                if (!grader_.scenes.empty()) doubt(work.tasks, isT1, rendered, aperture);
                judged.renders = std::move(rendered).moveTo(result);
            }
            gallery = {};
            result.timing.probeMs += questioning.wallMs();
            if (questioning.madeForbiddenCall()) blockForbidden(work.tasks);
            if (isUsable) judged.program = std::move(work.program);
        }
        judged.isAttempted = !std::ranges::all_of(work.tasks, isNotAttempted);
        files_.push_back(std::move(judged));
        std::move(work.tasks.begin(), work.tasks.end(), std::back_inserter(result.tasks));
        if (work.diagnostics) result.diagnostics.push_back(std::move(*work.diagnostics));
    }

    void screenshot(SubmissionResult& result) {
        if (const Finding* refusal = submission_.refusalOf(intake::Part::screenshot))
            return result.tasks.push_back(refused(*refusal));
        TaskReport report = judgeScreenshotFile(submission_.part(intake::Part::screenshot), files_,
                                                grader_, budget_, seed_, result);
        if ((report.state == TaskState::failed || isNotChecked(report)) &&
            std::ranges::all_of(result.tasks, isNotAttempted)) {
            report = blankReport("screenshot");
            report.state = TaskState::notAttempted;
            report.reason = "no task was attempted";
        }
        result.tasks.push_back(std::move(report));
    }

    void sources(SubmissionResult& result) const {
        for (const intake::Part part : {intake::Part::bumpySphere, intake::Part::renderer})
            if (const auto& bytes = submission_.part(part))
                result.sources.push_back({nameOf(part), *bytes});
    }

    void notices(SubmissionResult& result) const {
        if (!submission_.ignored.empty()) {
            std::string text = "Ignored:";
            constexpr std::size_t kMostNames = 20;
            for (std::size_t i = 0; i < submission_.ignored.size() && i < kMostNames; ++i)
                text += (i == 0 ? " " : ", ") + submission_.ignored[i];
            if (submission_.ignored.size() > kMostNames) text += ", ...";
            result.notices.push_back(std::move(text));
        }
        if (grader_.sandbox.level() == sandbox::Level::none)
            result.notices.emplace_back(
                "Run without a sandbox: nothing kept this code from reaching the machine.");
    }

private:
    [[nodiscard]] bool hasFile(SourceFile file) const {
        return submission_
            .part(file == SourceFile::bumpySphere ? intake::Part::bumpySphere
                                                  : intake::Part::renderer)
            .has_value();
    }

    const intake::Submission& submission_;
    const Grader& grader_;
    std::uint64_t seed_;  ///< of the questions
    build::TimeBudget budget_;
    std::vector<JudgedFile> files_;
};

SubmissionResult blankResult(const std::string& name, const Grader& grader, std::uint64_t seed) {
    SubmissionResult result;
    result.submission = name;
    result.seed = seed;
    result.sandboxLevel = sandbox::toString(grader.sandbox.level());
    result.toolVersion = grader.toolVersion;
    return result;
}

}  // namespace

SubmissionResult gradeSubmission(const intake::Submission& submission, const Grader& grader,
                                 std::uint64_t seed) {
    const Clock::time_point start = Clock::now();
    Grading grading{submission, grader, seed};
    SubmissionResult result = blankResult(submission.name, grader, seed);
    grading.file(SourceFile::bumpySphere, result);
    grading.file(SourceFile::renderer, result);
    grading.screenshot(result);
    grading.sources(result);
    grading.notices(result);
    drawRasters(result);
    result = rubric::applyRubric(grader.rubric, std::move(result));
    result.inputs = inputsOf(submission, grader, seed);
    result.timing.totalMs = millisecondsSince(start);
    return result;
}

SubmissionResult notGradedResult(const std::string& name, const std::string& reason,
                                 const Grader& grader, std::uint64_t seed) {
    SubmissionResult result = blankResult(name, grader, seed);
    for (const char* task : {"T1", "T2.1", "T2.2", "screenshot"}) {
        result.tasks.push_back(blankReport(task));
        result.tasks.back().reason = reason;
    }
    return rubric::applyRubric(grader.rubric, std::move(result));
}

}  // namespace ticker::pipeline
