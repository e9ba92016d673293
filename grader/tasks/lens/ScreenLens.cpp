#include <grader/tasks/lens/ScreenLens.h>

#include <grader/tasks/lens/JudgeDepthOfField.h>
#include <grader/tasks/lens/answers/LensLog.h>
#include <grader/tasks/lens/questions/LensQuestions.h>
#include <grader/tasks/support/Checks.h>
#include <grader/tasks/support/Stages.h>

#include <memory>

namespace ticker::tasks {

Screening screenLens(std::uint64_t seed) {
    const auto asked = std::make_shared<const probe::RenderQuestion>(drawScreenQuestion(seed));
    return {{*asked}, [asked](const probe::Run& run) {
                const auto* answer = answeredBy<probe::RenderAnswer>(run);
                if (answer == nullptr || answer->wrongSize) return false;
                const LensLog log = readLensLog(*asked, *answer);
                // Pictures without rays take a second to judge: edits that hide the rays, and those
                // of code whose rays are hidden, are left out.
                if (log.cut || log.rayCount() == 0) return false;
                return !hasFailure(judgeDepthOfField(log, log).findings);
            }};
}

}  // namespace ticker::tasks
