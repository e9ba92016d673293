#include <grader/pipeline/PictureDoubt.h>

#include <algorithm>

namespace ticker::pipeline {
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
    Finding finding;
    finding.id = "dof.picture-differs";
    finding.severity = Severity::warn;
    finding.section = "Test and submit";
    if (!misfit) {
        finding.message =
            "Every question was answered rightly, but no picture of the handout's scene came: the "
            "program left, crashed or ran out of time while it rendered.";
        finding.hint = "Render scenes/distributed.xml once more, as the handout says.";
        return finding;
    }
    finding.message =
        "Every question was answered rightly, but the picture of the handout's scene is not what "
        "the answers say: a person has to compare the two.";
    finding.hint =
        "Look for what render and illuminate share, such as a generator that illuminate seeds "
        "anew, so that all rays of a pixel start at one point of the lens; and for anything that "
        "depends on the size of the picture or on the number of lights.";
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

}  // namespace ticker::pipeline
