#include <grader/report/student/StudentView.h>

#include <grader/report/RepairSection.h>
#include <grader/result/AppealNumber.h>

#include <algorithm>
#include <utility>

namespace ticker::report {
namespace {

bool isShown(const Finding& finding, const StudentPolicy& policy) {
    switch (finding.severity) {
        case Severity::fail:
            return true;
        case Severity::warn:
            return policy.warnings;
        case Severity::note:
            return policy.notes;
    }
    return false;
}

/// Leaves at most what the student's code did at one question: a drawing without the rays that were
/// expected and without the expected normals, and no points.
void withhold(std::vector<ScatterPlot>& plots, const StudentPolicy& policy) {
    std::erase_if(plots, [&](const ScatterPlot& plot) { return !policy.rays || !plot.drawing; });
    for (ScatterPlot& plot : plots) {
        std::erase_if(plot.drawing->rays, [](const RayDrawing::Ray& ray) {
            return ray.kind == RayDrawing::Kind::expected;
        });
        for (RayDrawing::Normal& normal : plot.drawing->normals)
            normal.expected.reset();
        plot.points.clear();
        plot.expectedHalfWidth = plot.otherHalfWidth = 0.0;
    }
}

/// @param isAllowed  Its hint is shown even if the policy withholds hints.
void withhold(Finding& finding, const StudentPolicy& policy, bool isAllowed) {
    withhold(finding.plots, policy);
    finding.rasters.clear();
    if (!policy.hints && !isAllowed) finding.hint.clear();
    std::erase_if(finding.evidence, [&](const auto& entry) {
        return std::ranges::find(policy.evidence, entry.first) == policy.evidence.end();
    });
}

/// The line that mends a task, in the words of its first failure. @param whole  Everything known.
void sayLine(TaskReport& task, const SubmissionResult& whole, const StudentPolicy& policy) {
    if (policy.repairs == StudentPolicy::Repairs::off) return;
    const std::string line = agreedLine(whole, task.id);
    const auto said = std::ranges::find(task.findings, Severity::fail, &Finding::severity);
    if (!line.empty() && said != task.findings.end()) said->message += " " + line;
}

/// @param isMended  The report names a line that mends the task, so that its hint may be shown.
void withhold(TaskReport& task, const StudentPolicy& policy, bool isMended) {
    // The reason of a notGraded task may describe this machine.
    if (task.state == TaskState::notGraded)
        task.reason = "could not be graded, for reasons that are not yours";
    std::erase_if(task.findings, [&](const Finding& finding) { return !isShown(finding, policy); });
    for (Finding& finding : task.findings)
        withhold(finding, policy, isMended && finding.severity == Severity::fail);
    withhold(task.plots, policy);
    task.rasters.clear();
}

bool hasBytes(const SubmissionResult& result, const std::string& file) {
    return std::ranges::any_of(result.pictures, [&](const ResultPicture& picture) {
        return picture.file == file && !picture.png.empty();
    });
}

void withholdPictures(SubmissionResult& result, const StudentPolicy& policy) {
    // Students' pages are stored elsewhere: pictures are embedded or left out.
    std::erase_if(result.renders, [&](const RenderScore& render) {
        return !policy.ownPictures || !hasBytes(result, render.image);
    });
    for (RenderScore& render : result.renders) {
        render.reference.clear();
        render.errorMap.clear();
        render.zMap.clear();
    }
    std::erase_if(result.pictures, [&](const ResultPicture& picture) {
        return std::ranges::none_of(result.renders, [&](const RenderScore& render) {
            return render.image == picture.file;
        });
    });
}

}  // namespace

StudentView::StudentView(SubmissionResult result, const StudentPolicy& policy, std::string comment,
                         std::optional<Verdict> proposed, const Exercise& exercise,
                         std::vector<LineNote> notes)
    : result_(std::move(result)),
      comment_(std::move(comment)),
      notes_(std::move(notes)),
      proposed_(proposed.value_or(result_.verdict)),
      appealNumber_(ticker::appealNumber(result_)),
      exercise_(&exercise) {
    result_.seed = 0;
    for (TaskReport& task : result_.tasks) {
        const bool isMended = policy.repairs == StudentPolicy::Repairs::lineAndHint &&
                              !agreedLine(result_, task.id).empty();
        sayLine(task, result_, policy);
        withhold(task, policy, isMended);
    }
    result_.repairs.reset();
    withholdPictures(result_, policy);
    if (!policy.compilerOutput) result_.diagnostics.clear();
}

StudentView::StudentView(const SubmissionResult& result, const StudentPolicy& policy,
                         std::string comment, std::optional<Verdict> proposed,
                         std::vector<LineNote> notes)
    : StudentView(result, policy, std::move(comment), proposed, exerciseOf(result),
                  std::move(notes)) {}

bool concernsStudent(const TaskReport& task) {
    return task.state != TaskState::notAttempted || !task.findings.empty();
}

bool isCertain(const TaskReport& task) {
    return !task.needsReview && task.state != TaskState::notGraded && !isNotChecked(task);
}

bool hasScore(const SubmissionResult& result) {
    return result.verdict == Verdict::awarded || result.verdict == Verdict::notAwarded;
}

}  // namespace ticker::report
