#include <grader/result/GeneralFindings.h>
#include <grader/rubric/Rubric.h>

#include <algorithm>

namespace ticker::rubric {
namespace {

bool anyFails(const TaskReport& task) {
    return std::any_of(task.findings.begin(), task.findings.end(),
                       [](const Finding& finding) { return finding.severity == Severity::fail; });
}

void applySeverities(const Rubric& rubric, TaskReport& task) {
    const bool failedBefore = anyFails(task);
    for (Finding& finding : task.findings) {
        const auto wanted = rubric.severities.find(finding.id);
        if (wanted != rubric.severities.end()) finding.severity = wanted->second;
    }
    const bool fails = anyFails(task);
    if (task.state == TaskState::failed && failedBefore && !fails) task.state = TaskState::passed;
    if (task.state == TaskState::passed && fails) task.state = TaskState::failed;
}

const TaskReport* findTask(const SubmissionResult& result, const std::string& id) {
    const auto found = std::find_if(result.tasks.begin(), result.tasks.end(),
                                    [&](const TaskReport& task) { return task.id == id; });
    return found == result.tasks.end() ? nullptr : &*found;
}

bool passes(const SubmissionResult& result, const Option& option) {
    return std::all_of(option.tasks.begin(), option.tasks.end(), [&](const std::string& id) {
        const TaskReport* task = findTask(result, id);
        return task != nullptr && task->state == TaskState::passed;
    });
}

/// An option that needs no review: all tasks pass and none asks for review.
bool passesForSure(const SubmissionResult& result, const Option& option) {
    return passes(result, option) &&
           std::none_of(option.tasks.begin(), option.tasks.end(),
                        [&](const std::string& id) { return findTask(result, id)->needsReview; });
}

/// The tasks of the exercise, without the screenshot's.
template <typename Predicate>
bool anyExercise(const Rubric& rubric, const SubmissionResult& result, Predicate predicate) {
    return std::any_of(result.tasks.begin(), result.tasks.end(), [&](const TaskReport& task) {
        return task.id != rubric.screenshotTask && predicate(task);
    });
}

Verdict verdictOf(const Rubric& rubric, const SubmissionResult& result) {
    const auto any = [&](auto predicate) {
        return std::any_of(rubric.options.begin(), rubric.options.end(),
                           [&](const Option& option) { return predicate(result, option); });
    };
    if (any(passes)) {
        const TaskReport* screenshot = findTask(result, rubric.screenshotTask);
        const bool pictureFits =
            rubric.screenshotTask.empty() ||
            (screenshot != nullptr && !screenshot->needsReview &&
             (screenshot->state == TaskState::passed || isNotChecked(*screenshot)));
        return any(passesForSure) && pictureFits ? Verdict::awarded : Verdict::needsReview;
    }
    if (anyExercise(rubric, result,
                    [](const TaskReport& task) { return task.state == TaskState::notGraded; }))
        return Verdict::notGraded;
    if (anyExercise(rubric, result, [](const TaskReport& task) { return task.needsReview; }))
        return Verdict::needsReview;
    return Verdict::notAwarded;
}

double scoreOf(const Rubric& rubric, const SubmissionResult& result) {
    if (result.verdict != Verdict::awarded) return 0.0;
    double score = 0.0;
    for (const Option& option : rubric.options)
        if (passes(result, option)) score += option.points;
    return std::min(score, rubric.maxScore);
}

/// A missing file blocks its tasks, but does not count as an attempt.
bool isAttempt(const TaskReport& task) {
    return task.state != TaskState::notAttempted &&
           std::none_of(task.findings.begin(), task.findings.end(),
                        [](const Finding& finding) { return is(finding, kIntakeMissingFile); });
}

bool attempted(const SubmissionResult& result, const Option& option) {
    return std::any_of(option.tasks.begin(), option.tasks.end(), [&](const std::string& id) {
        const TaskReport* task = findTask(result, id);
        return task != nullptr && isAttempt(*task);
    });
}

std::string optionOf(const Rubric& rubric, const SubmissionResult& result) {
    std::string name = "none";
    for (const Option& option : rubric.options)
        if (attempted(result, option))
            name = name == "none" ? option.name : std::string{kSeveralOptions};
    return name;
}

}  // namespace

SubmissionResult applyRubric(const Rubric& rubric, SubmissionResult result) {
    for (TaskReport& task : result.tasks)
        applySeverities(rubric, task);
    result.maxScore = rubric.maxScore;
    result.option = optionOf(rubric, result);
    result.options = rubric.options;
    result.verdict = verdictOf(rubric, result);
    result.score = scoreOf(rubric, result);
    return result;
}

}  // namespace ticker::rubric
