#include <grader/pipeline/Grade.h>

#include <grader/pipeline/DrawRasters.h>
#include <grader/pipeline/FileWork.h>
#include <grader/pipeline/InputDigests.h>
#include <grader/pipeline/Questioning.h>
#include <grader/pipeline/Screenshot.h>

#include <raytracer/base/Error.h>

#include <algorithm>
#include <chrono>
#include <future>
#include <iterator>
#include <utility>

namespace ticker::pipeline {
namespace {

using Clock = std::chrono::steady_clock;

double millisecondsSince(Clock::time_point start) {
    return std::chrono::duration<double, std::milli>(Clock::now() - start).count();
}

/// Judges the tasks of a file that are still open.
void judge(FileWork& work, const Grader& grader, Questioning& questioning, std::uint64_t seed) {
    std::vector<std::pair<TaskReport*, std::future<TaskJudgement>>> begun;
    for (TaskReport& report : work.tasks) {
        if (!awaitsJudge(report)) continue;
        const Task& task = codeOf(grader, report.id);
        begun.emplace_back(&report, questioning.begin([task, seed](probe::Examinee& examinee) {
            TaskJudgement judgement = task.judge(examinee, seed);
            if (task.draw) task.draw(examinee, judgement);
            return judgement;
        }));
    }
    // Without parallel runs the last task is asked first. The order matters once the time budget is
    // spent.
    for (auto each = begun.rbegin(); each != begun.rend(); ++each)
        settle(*each->first, each->second.get());
}

void doubt(std::vector<TaskReport>& tasks, const Grader& grader, const RenderEvidence& renders) {
    for (const TaskReport& task : tasks)
        if (const auto check = codeOf(grader, task.id).doubt) check(tasks, renders);
}

auto isIn(TaskState state) {
    return [state](const TaskReport& task) { return task.state == state; };
}

TaskReport refused(const Finding& refusal, const Exercise& exercise) {
    TaskReport report = blankReport(std::string{kScreenshotTask}, exercise);
    report.state = TaskState::blocked;
    report.reason = refusal.message;
    report.findings = {refusal};
    report.needsReview = true;
    return report;
}

/// A forbidden call blocks the file's tasks, even if every question before it was answered.
void blockForbidden(std::vector<TaskReport>& tasks) {
    for (TaskReport& task : tasks) {
        if (task.state != TaskState::passed && task.state != TaskState::failed) continue;
        task.state = TaskState::blocked;
        task.needsReview = false;  // the kernel's report is certain
        task.findings.insert(task.findings.begin(), forbiddenCallFinding());
        task.reason = task.findings.front().message;
    }
}

/// Grades each file, then the picture, into one result.
class Grading {
public:
    Grading(const intake::Submission& submission, const Grader& grader, std::uint64_t seed)
        : submission_(submission),
          grader_(grader),
          seed_(questionSeed(submission, seed, *grader.exercise)),
          budget_(grader.policy.submission) {
        if (grader.exercise->hasScreenshot() && submission.refusalOf(kScreenshotPart) == nullptr)
            picture_ = beginDecoding(submission.part(kScreenshotPart), grader);
    }

    void file(const std::string& file, SubmissionResult& result) {
        std::future<void> expectations;
        if (grader_.isAlone && submission_.part(file))
            expectations =
                std::async(std::launch::async, [&] { prepareExpectations(grader_.scenes, file); });
        FileWork work = prepareFile(submission_, file, grader_);
        result.timing.compileMs += work.compileMs;
        JudgedFile judged{file, false, std::nullopt, {}, {}};
        if (work.program) ask(work, judged, result);
        judged.isAttempted = !std::ranges::all_of(work.tasks, isIn(TaskState::notAttempted));
        files_.push_back(std::move(judged));
        std::ranges::move(work.tasks, std::back_inserter(result.tasks));
        if (work.diagnostics) result.diagnostics.push_back(std::move(*work.diagnostics));
    }

    void screenshot(SubmissionResult& result) {
        if (!grader_.exercise->hasScreenshot()) return;
        if (const Finding* refusal = submission_.refusalOf(kScreenshotPart))
            return result.tasks.push_back(refused(*refusal, *grader_.exercise));
        TaskReport report =
            judgeScreenshotFile(std::move(picture_), files_, grader_, budget_, seed_, result);
        if ((report.state == TaskState::failed || isNotChecked(report)) &&
            std::ranges::all_of(result.tasks, isIn(TaskState::notAttempted))) {
            report = blankReport(std::string{kScreenshotTask}, *grader_.exercise);
            report.state = TaskState::notAttempted;
            report.reason = "no task was attempted";
        }
        result.tasks.push_back(std::move(report));
    }

    /// Everything that the questions depend on, so that they can be asked again.
    void handIn(SubmissionResult& result) const {
        for (const std::string& part : grader_.exercise->files())
            if (const auto& bytes = submission_.part(part))
                result.sources.push_back({part, *bytes});
        result.screenshot = submission_.part(kScreenshotPart);
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
    /// Asks a file's program all that can be asked without the other files.
    void ask(FileWork& work, JudgedFile& judged, SubmissionResult& result) {
        Questioning questioning{*work.program, grader_, budget_};
        Questioning pictures{*work.program, grader_, budget_};
        const bool isUsable = judgeAndRender(work, judged, questioning, pictures, result);
        result.timing.probeMs += questioning.wallMs() + pictures.wallMs();
        // In a class no picture is rendered where a task is blocked: it must not count alone.
        if (questioning.madeForbiddenCall() || (isUsable && pictures.madeForbiddenCall()))
            blockForbidden(work.tasks);
        if (isUsable) judged.program = std::move(work.program);
    }

    /// @return  Whether the program may be asked again, and its pictures count: code that crashed
    ///          or looped would do so again.
    bool judgeAndRender(FileWork& work, JudgedFile& judged, Questioning& questioning,
                        Questioning& pictures, SubmissionResult& result) {
        const auto render = [&](Rays rays) {
            return [this, &judged, rays](probe::Examinee& examinee) {
                return renderSpecScenes(grader_.scenes, judged.file, examinee, rays);
            };
        };
        // Whichever way this function ends, it waits for these two, if they have begun.
        std::future<Gallery> gallery = pictures.begin(render(Rays::few));
        std::future<AskedAhead> ahead = beginScreenshot(judged.file, *work.program);
        judge(work, grader_, questioning, seed_);
        if (std::ranges::any_of(work.tasks, isIn(TaskState::blocked))) return false;
        Gallery rendered = gallery.get();
        if (!rendered.isClear && std::ranges::all_of(work.tasks, isIn(TaskState::passed)))
            rendered = pictures.run(render(Rays::handout));
        if (!grader_.scenes.empty())
            doubt(work.tasks, grader_, {rendered.misfits, rendered.bumpMisfit});
        judged.renders = std::move(rendered).moveTo(result);
        if (ahead.valid()) judged.ahead = ahead.get();
        return true;
    }

    /// Starts what the screenshot's judgement asks first, if this submission is graded alone.
    std::future<AskedAhead> beginScreenshot(const std::string& file,
                                            const build::Program& program) {
        if (!grader_.isAlone) return {};
        std::vector<probe::Question> questions = firstQuestions(submission_, file, grader_, seed_);
        if (questions.empty()) return {};
        return std::async(std::launch::async, [this, &program, asked = std::move(questions)] {
            return askAhead(asked, program, grader_, budget_);
        });
    }

    const intake::Submission& submission_;
    const Grader& grader_;
    std::uint64_t seed_;  ///< source of the questions
    build::TimeBudget budget_;
    std::future<picture::Decoded> picture_;
    std::vector<JudgedFile> files_;
};

/// Sorts reports by the exercise's order of tasks.
void inOrderOf(const std::vector<std::string>& ids, std::vector<TaskReport>& tasks) {
    std::ranges::stable_sort(tasks, {}, [&](const TaskReport& task) {
        return std::ranges::find(ids, task.id) - ids.begin();
    });
}

SubmissionResult blankResult(const std::string& name, const Grader& grader, std::uint64_t seed) {
    SubmissionResult result;
    result.submission = name;
    result.exercise = grader.exercise->name;
    result.seed = seed;
    result.sandboxLevel = sandbox::toString(grader.sandbox.level());
    result.toolVersion = grader.toolVersion;
    return result;
}

}  // namespace

const Task& codeOf(const Grader& grader, const std::string& id) {
    const auto found = std::ranges::find(grader.tasks, id, &Task::id);
    if (found == grader.tasks.end())
        throw raytracer::Error("the exercise names task " + id + ", which has no code");
    return *found;
}

SubmissionResult gradeSubmission(const intake::Submission& submission, const Grader& grader,
                                 std::uint64_t seed) {
    const Clock::time_point start = Clock::now();
    Grading grading{submission, grader, seed};
    SubmissionResult result = blankResult(submission.name, grader, seed);
    for (const std::string& file : grader.exercise->files())
        grading.file(file, result);
    inOrderOf(grader.exercise->reported(), result.tasks);
    grading.screenshot(result);
    grading.handIn(result);
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
    for (const std::string& task : grader.exercise->reported()) {
        result.tasks.push_back(blankReport(task, *grader.exercise));
        result.tasks.back().reason = reason;
    }
    return rubric::applyRubric(grader.rubric, std::move(result));
}

}  // namespace ticker::pipeline
