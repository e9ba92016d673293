#include <grader/probe/Question.h>
#include <grader/tasks/lens/LensFindings.h>
#include <grader/tasks/lens/checks/PictureDoubt.h>
#include <grader/tasks/shadows/ShadowFindings.h>
#include <grader/tasks/support/FindingOrder.h>

#include <fmt/core.h>

#include <algorithm>
#include <initializer_list>
#include <string>

namespace ticker::tasks {
namespace {

bool hasPassed(const TaskReport& task) {
    return task.state == TaskState::passed;
}

bool hasFinding(const std::vector<TaskReport>& tasks,
                std::initializer_list<const FindingText*> texts) {
    return std::ranges::any_of(tasks, [&](const TaskReport& task) {
        return std::ranges::any_of(task.findings, [&](const Finding& finding) {
            return std::ranges::any_of(texts,
                                       [&](const FindingText* text) { return is(finding, *text); });
        });
    });
}

// Three accepted readings change the picture: highlights computed for the eye change every
// reflection, the falloff of the light's near side all light, antialiasing every edge.
bool isExplained(const std::vector<TaskReport>& tasks) {
    return hasFinding(tasks, {&kShadowViewFromEye, &kShadowNearSideFalloff, &kDofAntialiased});
}

// Lens points that all pixels share move the picture as a whole: one pattern of fifty points gave a
// misfit of 1.13.
double limitFor(const std::vector<TaskReport>& tasks) {
    constexpr double kOfOnePattern = 2.0;
    return hasFinding(tasks, {&kDofReusedPattern, &kShadowFixedSamples}) ? kOfOnePattern
                                                                         : kMostMisfit;
}

Finding doubt(const std::string& message) {
    return distributedFinding(kDofPictureDiffers, Severity::warn, message);
}

Finding missing() {
    Finding finding = doubt(
        "Every question was answered rightly, but no picture of the handout's scene came: the "
        "program left, crashed or ran out of time while it rendered.");
    finding.hint = "Render scenes/distributed.xml once more, as the handout says.";
    return finding;
}

Finding differing(double misfit, double limit) {
    Finding finding = doubt(
        "Every question was answered rightly, but the picture of the handout's scene is not what "
        "the answers say: a person has to compare the two.");
    finding.evidence.emplace_back("misfit", misfit);
    finding.evidence.emplace_back("misfitAtMost", limit);
    return finding;
}

Finding ofAnotherAperture(double answered, double shown) {
    const double amount = raytracer::RenderSettings{}.dofAmount;
    Finding finding = doubt(fmt::format(
        "Every question was answered rightly, but where rays start on a lens of half-width {:.3g} "
        "in small pictures, the picture of the handout's scene has the blur of {:.3g}: a person "
        "has to look.",
        answered * amount, shown * amount));
    finding.hint = "Look for what makes the aperture depend on the size of the picture.";
    return finding;
}

}  // namespace

void doubtPicture(std::vector<TaskReport>& tasks, const std::vector<Misfit>& misfits,
                  const std::optional<double>& apertureFactor) {
    if (!std::ranges::all_of(tasks, hasPassed)) return;
    if (!misfits.empty() && isExplained(tasks)) return;
    const double limit = limitFor(tasks);
    const auto best = std::ranges::min_element(misfits, {}, &Misfit::meanSquare);
    const bool fits = best != misfits.end() && best->meanSquare <= limit;
    if (fits && (!apertureFactor || best->apertureFactor == *apertureFactor)) return;
    tasks.back().findings.push_back(best == misfits.end() ? missing()
                                    : fits
                                        ? ofAnotherAperture(*apertureFactor, best->apertureFactor)
                                        : differing(best->meanSquare, limit));
    tasks.back().needsReview = true;
}

}  // namespace ticker::tasks
