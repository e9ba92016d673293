#include <grader/tasks/lens/ScreenLens.h>

#include <grader/tasks/lens/JudgeDepthOfField.h>
#include <grader/tasks/lens/answers/LensLog.h>
#include <grader/tasks/lens/questions/LensQuestions.h>
#include <grader/tasks/support/FindingOrder.h>
#include <grader/tasks/support/Stage.h>

#include <memory>

namespace ticker::tasks {

Screening screenLens(std::uint64_t seed) {
    const auto asked = std::make_shared<const probe::RenderQuestion>(drawScreenQuestion(seed));
    return {{*asked}, [asked](const probe::Run& run) {
                const auto* answer = answeredBy<probe::RenderAnswer>(run);
                if (answer == nullptr || answer->wrongSize) return false;
                const LensLog log = readLensLog(*asked, *answer);
                const LensOutcome outcome = judgeDepthOfField(log, log);
                // Pictures without rays take seconds to judge: edits that hide rays, and those of
                // code whose rays are hidden, are left out.
                const bool isHidden = outcome.rayless || outcome.valueless || outcome.cut;
                return !isHidden && !hasFailure(outcome.findings);
            }};
}

}  // namespace ticker::tasks
