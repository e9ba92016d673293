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

bool hasPassed(const TaskReport& task) {
    return task.state == TaskState::passed;
}

bool hasPassedForSure(const TaskReport& task) {
    return hasPassed(task) && !task.needsReview;
}

bool needsReview(const TaskReport& task) {
    return task.needsReview;
}

bool isNotGraded(const TaskReport& task) {
    return task.state == TaskState::notGraded;
}

/// A person, or the grader's next attempt, may still find that it is right.
bool mayPass(const TaskReport& task) {
    return hasPassed(task) || needsReview(task) || isNotGraded(task);
}

using OfTask = bool (*)(const TaskReport&);

/// True if `is` holds for all tasks of an option.
bool holds(OfTask is, const SubmissionResult& result, const Option& option) {
    return std::all_of(option.tasks.begin(), option.tasks.end(), [&](const std::string& id) {
        const TaskReport* task = findTask(result, id);
        return task != nullptr && is(*task);
    });
}

bool holdsForAny(OfTask is, const Rubric& rubric, const SubmissionResult& result) {
    return std::any_of(rubric.options.begin(), rubric.options.end(),
                       [&](const Option& option) { return holds(is, result, option); });
}

/// The points of all options for which `is` holds.
double pointsIf(OfTask is, const Rubric& rubric, const SubmissionResult& result) {
    double points = 0.0;
    for (const Option& option : rubric.options)
        if (holds(is, result, option)) points += option.points;
    return std::min(points, rubric.maxScore);
}

/// True if `is` holds for a task of the exercise. The screenshot does not count.
bool anyExercise(OfTask is, const Rubric& rubric, const SubmissionResult& result) {
    return std::any_of(result.tasks.begin(), result.tasks.end(), [&](const TaskReport& task) {
        return task.id != rubric.screenshotTask && is(task);
    });
}

bool pictureFits(const Rubric& rubric, const SubmissionResult& result) {
    if (rubric.screenshotTask.empty()) return true;
    const TaskReport* screenshot = findTask(result, rubric.screenshotTask);
    return screenshot != nullptr && !screenshot->needsReview &&
           (hasPassed(*screenshot) || isNotChecked(*screenshot));
}

/// Whether undecided options could add points to the sure ones, which may have all there are.
bool mayGain(const Rubric& rubric, const SubmissionResult& result) {
    return pointsIf(mayPass, rubric, result) > pointsIf(hasPassedForSure, rubric, result);
}

Verdict verdictOf(const Rubric& rubric, const SubmissionResult& result) {
    if (holdsForAny(hasPassed, rubric, result)) {
        const bool isSure =
            holdsForAny(hasPassedForSure, rubric, result) && pictureFits(rubric, result);
        if (!isSure) return Verdict::needsReview;
        // An award gives its points at once, so that it waits for a task that may add to them.
        if (!mayGain(rubric, result)) return Verdict::awarded;
    }
    if (anyExercise(isNotGraded, rubric, result)) return Verdict::notGraded;
    if (anyExercise(needsReview, rubric, result)) return Verdict::needsReview;
    return Verdict::notAwarded;
}

double scoreOf(const Rubric& rubric, const SubmissionResult& result) {
    return result.verdict == Verdict::awarded ? pointsIf(hasPassedForSure, rubric, result) : 0.0;
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
