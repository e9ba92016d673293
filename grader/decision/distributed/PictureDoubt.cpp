#include <grader/decision/distributed/FindingText.h>
#include <grader/decision/distributed/PictureDoubt.h>

#include <algorithm>

namespace ticker::decision {
namespace {

// Right solutions have 0.04 to 0.83, whatever their samples; a sharp picture 3.7, hard shadows with
// it 5.8.
constexpr double kMostMisfit = 2.0;

bool hasPassed(const TaskReport& task) {
    return task.state == TaskState::passed;
}

// Highlights as seen from the eye are accepted, and change every reflection.
bool isExplained(const std::vector<TaskReport>& tasks) {
    return std::ranges::any_of(tasks, [](const TaskReport& task) {
        return std::ranges::any_of(task.findings, [](const Finding& finding) {
            return finding.id == "shadow.view-from-eye";
        });
    });
}

Finding doubt(const std::optional<double>& misfit) {
    constexpr const char* kId = "dof.picture-differs";
    if (!misfit) {
        Finding finding = distributedFinding(
            kId, Severity::warn,
            "Every question was answered rightly, but no picture of the handout's scene came: the "
            "program left, crashed or ran out of time while it rendered.");
        finding.hint = "Render scenes/distributed.xml once more, as the handout says.";
        return finding;
    }
    Finding finding = distributedFinding(
        kId, Severity::warn,
        "Every question was answered rightly, but the picture of the handout's scene is not what "
        "the answers say: a person has to compare the two.");
    finding.evidence.emplace_back("misfit", *misfit);
    finding.evidence.emplace_back("misfitAtMost", kMostMisfit);
    return finding;
}

}  // namespace

void doubtPicture(std::vector<TaskReport>& tasks, const std::optional<double>& misfit) {
    if (!std::ranges::all_of(tasks, hasPassed)) return;
    if (misfit && (*misfit <= kMostMisfit || isExplained(tasks))) return;
    tasks.back().findings.push_back(doubt(misfit));
    tasks.back().needsReview = true;
}

}  // namespace ticker::decision
