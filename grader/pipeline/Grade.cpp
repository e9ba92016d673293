#include <grader/pipeline/Grade.h>

#include <grader/build/SandboxedExaminee.h>
#include <grader/decision/bump/JudgeBump.h>
#include <grader/decision/distributed/JudgeDistributed.h>
#include <grader/pipeline/FileWork.h>
#include <grader/pipeline/Inputs.h>
#include <grader/pipeline/Screenshot.h>

#include <algorithm>
#include <chrono>
#include <iterator>
#include <utility>

namespace ticker::pipeline {
namespace {

using build::SourceFile;
using decision::TaskJudgement;

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
}

void judge(FileWork& work, SourceFile file, probe::Examinee& examinee, std::uint64_t seed) {
    if (file == SourceFile::bumpySphere)
        return settle(work.tasks.at(0), decision::judgeBump(examinee, seed));
    const decision::DistributedAttempt attempt{isOpen(work.tasks.at(0)), isOpen(work.tasks.at(1))};
    decision::DistributedJudgement judgement = decision::judgeDistributed(examinee, attempt, seed);
    settle(work.tasks.at(0), std::move(judgement.softShadows));
    settle(work.tasks.at(1), std::move(judgement.depthOfField));
}

bool isBlocked(const TaskReport& task) {
    return task.state == TaskState::blocked;
}

/// Grades one file after the other into one result.
class Grading {
public:
    Grading(const intake::Submission& submission, const Grader& grader, std::uint64_t seed)
        : submission_(submission), grader_(grader), seed_(seed) {}

    void file(SourceFile file, SubmissionResult& result) const {
        FileWork work = prepareFile(submission_, file, grader_);
        result.timing.compileMs += work.compileMs;
        if (work.program) {
            build::SandboxedExaminee examinee{*work.program, grader_.sandbox, grader_.policy.run};
            judge(work, file, examinee, seed_);
            // Code that crashed or loops would do so again.
            if (std::ranges::none_of(work.tasks, isBlocked))
                addRenders(result, grader_.scenes, file == SourceFile::bumpySphere, examinee);
            result.timing.probeMs += examinee.wallMs();
        }
        std::move(work.tasks.begin(), work.tasks.end(), std::back_inserter(result.tasks));
        if (work.diagnostics) result.diagnostics.push_back(std::move(*work.diagnostics));
    }

    void screenshot(SubmissionResult& result) const {
        const bool nothingToShow = std::ranges::all_of(result.tasks, [](const TaskReport& task) {
            return task.state == TaskState::notAttempted;
        });
        const Finding* refusal = submission_.refusalOf(intake::Part::screenshot);
        TaskReport report = judgeScreenshotFile(submission_.part(intake::Part::screenshot));
        if (refusal != nullptr) {
            report.state = TaskState::blocked;
            report.reason = refusal->message;
            report.findings = {*refusal};
            report.needsReview = true;
        } else if (nothingToShow && report.state == TaskState::failed) {
            report.state = TaskState::notAttempted;
            report.reason = "no task was attempted";
            report.findings.clear();
        }
        if (report.state == TaskState::passed) showScreenshot(result);
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
    void showScreenshot(SubmissionResult& result) const {
        result.pictures.push_back({"images/screenshot.png", "screenshot.png as handed in",
                                   *submission_.part(intake::Part::screenshot)});
    }

    const intake::Submission& submission_;
    const Grader& grader_;
    std::uint64_t seed_;
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
    const Grading grading{submission, grader, seed};
    SubmissionResult result = blankResult(submission.name, grader, seed);
    grading.file(SourceFile::bumpySphere, result);
    grading.file(SourceFile::renderer, result);
    grading.screenshot(result);
    grading.sources(result);
    grading.notices(result);
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
