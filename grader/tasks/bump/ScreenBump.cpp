#include <grader/tasks/bump/ScreenBump.h>

#include <grader/tasks/bump/answers/RampJudgement.h>
#include <grader/tasks/bump/questions/Draws.h>
#include <grader/tasks/bump/questions/Ramps.h>
#include <grader/tasks/bump/questions/Tilt.h>

#include <memory>

namespace ticker::tasks {
namespace {

using namespace bump;

struct ScreenPlan {
    Questionnaire questionnaire;
    RampPlan ramps;
};

/// Like the examination's gentle ramps, a third as long.
ScreenPlan planScreen(std::uint64_t seed) {
    constexpr int kPoints = 64;
    constexpr RampShape kShape{.columns = 720, .rows = 530, .across = 40, .rise = 0.035};
    Draws draws(seed + 0x5C4EE4U);
    ScreenPlan plan{Questionnaire(seed + 0x5C4EE4U), {}};
    const Ball ball{{draws.uniform(-2.0, -0.7), draws.uniform(0.3, 1.5), 25.0},
                    draws.uniform(13.0, 15.0)};
    plan.ramps = planRamps(plan.questionnaire, ball, kShape, draws.directions(kPoints));
    return plan;
}

}  // namespace

Screening screenBump(std::uint64_t seed) {
    const auto plan = std::make_shared<const ScreenPlan>(planScreen(seed));
    return {plan->questionnaire.questions(), [plan](const probe::Run& run) {
                const Answers answers(plan->questionnaire, run);
                return judgeRamps(plan->ramps.shape, readRamps(plan->ramps, answers)).kind ==
                       RampKind::right;
            }};
}

}  // namespace ticker::tasks
