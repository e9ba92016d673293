#include <grader/repair/Explain.h>

#include <grader/repair/Clock.h>
#include <grader/repair/TaskExplanation.h>
#include <grader/repair/TaskLookup.h>
#include <grader/repair/Workbench.h>
#include <grader/result/GeneralFindings.h>

#include <algorithm>
#include <iterator>
#include <optional>
#include <string>
#include <utility>

namespace ticker::repair {
namespace {

/// The failed tasks whose code was handed in.
std::vector<const TaskReport*> explainable(const intake::Submission& submission,
                                           const Exercise& exercise,
                                           const SubmissionResult& result) {
    std::vector<const TaskReport*> tasks;
    for (const TaskReport& task : result.tasks) {
        const std::string file{exercise.fileOf(task.id)};
        if (!file.empty() && submission.part(file) && isExplainable(task)) tasks.push_back(&task);
    }
    return tasks;
}

/// Functions in which only tasks without a failure are solved, separated by commas. They are not
/// edited.
std::string solvedFunctions(const pipeline::Grader& grader,
                            const std::vector<const TaskReport*>& open, const std::string& file) {
    std::string names;
    for (const TaskEntry& task : grader.exercise->tasks) {
        const bool isOpen = std::ranges::any_of(open, [&](const TaskReport* report) {
            return grader.exercise->task(report->id)->functionName() == task.functionName();
        });
        if (task.file == file && !isOpen) names += task.functionName() + ",";
    }
    return names;
}

}  // namespace

bool isExplainable(const TaskReport& task) {
    const std::string finding = firstFailure(task);
    if (finding.empty() || task.id == kScreenshotTask) return false;
    return task.state == TaskState::failed ||
           (task.state == TaskState::blocked && isRunEnd(finding));
}

Explanation explain(const intake::Submission& submission, const pipeline::Grader& grader,
                    const SubmissionResult& result, std::uint64_t seed,
                    const SearchLimits& limits) {
    Explanation explanation;
    const std::vector<const TaskReport*> open = explainable(submission, *grader.exercise, result);
    if (open.empty()) return explanation;
    Clock clock{limits.all};
    const Setting setting{result, grader, limits, seed, clock};
    auto waiting = static_cast<double>(open.size());
    for (const std::string& file : grader.exercise->files()) {
        const std::optional<std::string>& source = submission.part(file);
        const bool isOpen = std::ranges::any_of(open, [&](const TaskReport* task) {
            return grader.exercise->fileOf(task->id) == file;
        });
        if (!isOpen) continue;
        Workbench workbench{file, *source, solvedFunctions(grader, open, file), grader, clock};
        for (const TaskReport* task : open) {
            if (grader.exercise->fileOf(task->id) != file) continue;
            const double nowMs = clock.cpuMs();
            const double endMs = nowMs + (1000.0 * limits.all.cpuSeconds - nowMs) / waiting;
            waiting -= 1.0;
            TaskRepairs found = TaskExplanation{workbench, *task, setting, endMs}.run();
            if (found.repairs.empty() && found.wasCutOff)
                explanation.cutOff.push_back(task->id);
            else if (workbench.bench(Reach::simple) == nullptr)
                explanation.notSearched.push_back(task->id);
            std::ranges::move(found.repairs, std::back_inserter(explanation.repairs));
            explanation.tried += found.asked;
        }
    }
    explanation.cpuMs = clock.cpuMs();
    for (const Work work : {Work::parse, Work::compile, Work::ask, Work::prove})
        explanation.workMs[work] = clock.cpuMs(work);
    return explanation;
}

}  // namespace ticker::repair
