#include <grader/tasks/bump/BumpFindings.h>
#include <grader/tasks/lens/LensFindings.h>
#include <grader/tasks/screenshot/UnlikeItself.h>
#include <grader/tasks/shadows/ShadowFindings.h>

#include <algorithm>
#include <initializer_list>

namespace ticker::tasks {

std::string whyUnlikeItself(const std::vector<TaskReport>& tasks) {
    const auto has = [&](std::initializer_list<const FindingText*> texts) {
        return std::ranges::any_of(tasks, [&](const TaskReport& task) {
            return std::ranges::any_of(task.findings, [&](const Finding& finding) {
                return std::ranges::any_of(
                    texts, [&](const FindingText* text) { return is(finding, *text); });
            });
        });
    };
    if (has({&kBumpThreadsMixed, &kShadowThreadsMixed, &kDofThreadsMixed}))
        return "what this code draws depends on how its threads meet";
    if (has({&kShadowFixedSamples, &kDofSharedSamples, &kDofReusedPattern}))
        return "this code uses the same random points all over a picture, and other ones in the "
               "next";
    return {};
}

}  // namespace ticker::tasks
