#include <grader/tasks/bump/ScreenBump.h>

#include <grader/tasks/bump/answers/RampJudgement.h>
#include <grader/tasks/bump/places/Caps.h>
#include <grader/tasks/bump/places/FewTexels.h>
#include <grader/tasks/bump/places/Untilted.h>
#include <grader/tasks/bump/questions/Draws.h>
#include <grader/tasks/bump/questions/MapEdges.h>
#include <grader/tasks/bump/questions/Proportion.h>
#include <grader/tasks/bump/questions/Ramps.h>
#include <grader/tasks/bump/questions/SharpSteps.h>
#include <grader/tasks/bump/questions/Slopes.h>
#include <grader/tasks/bump/questions/Stripes.h>
#include <grader/tasks/bump/questions/Tilt.h>

#include <array>
#include <functional>
#include <memory>
#include <utility>
#include <vector>

namespace ticker::tasks {
namespace {

using namespace bump;

/// Whether the answers to a part of the examination may be those of right code.
using PartCheck = std::function<bool(const Answers&, const RampJudgement&)>;
using AddPart = PartCheck (*)(Questionnaire&, Draws&, const Ball&);

PartCheck addOrder(Questionnaire& questionnaire, Draws& draws, const Ball& ball) {
    constexpr int kPoints = 300;
    constexpr double kSomePoints = 0.01;
    // The map has so few rows that many points lie in the last one.
    const OrderPair order =
        questionnaire.addInBothOrders(ball, noiseMap(draws, 12, 6), draws.directions(kPoints));
    return [order](const Answers& answers, const RampJudgement&) {
        return answers.shareThatOrderChanges(order) <= kSomePoints;
    };
}

PartCheck addFewTexels(Questionnaire& questionnaire, Draws& draws, const Ball& ball) {
    return [plan = planFewTexels(questionnaire, draws, ball)](const Answers& answers,
                                                              const RampJudgement& ramps) {
        return readFewTexels(plan, answers, ramps.fit->parametrisation).good();
    };
}

PartCheck addEdges(Questionnaire& questionnaire, Draws& draws, const Ball& ball) {
    return [plan = planEdges(questionnaire, draws, ball)](const Answers& answers,
                                                          const RampJudgement& ramps) {
        return readEdges(plan, answers, ramps.fit->parametrisation).goodSeam();
    };
}

PartCheck addCaps(Questionnaire& questionnaire, Draws& draws, const Ball& ball) {
    return [plan = planCaps(questionnaire, draws, ball)](const Answers& answers,
                                                         const RampJudgement& ramps) {
        return readCaps(plan, answers, ramps.fit->parametrisation).good();
    };
}

PartCheck addProportion(Questionnaire& questionnaire, Draws& draws, const Ball& ball) {
    return [plan = planProportion(questionnaire, draws, ball)](const Answers& answers,
                                                               const RampJudgement&) {
        const Proportion seen = readProportion(plan, answers);
        return seen.good() && seen.isSameAtEveryHeight() && seen.staysAboveHorizon();
    };
}

PartCheck addSharpSteps(Questionnaire& questionnaire, Draws& draws, const Ball& ball) {
    return [plan = planSharpSteps(questionnaire, draws, ball)](const Answers& answers,
                                                               const RampJudgement&) {
        return readSharpSteps(plan, answers).good();
    };
}

PartCheck addUntilted(Questionnaire& questionnaire, Draws& draws, const Ball& ball) {
    return [plan = planUntilted(questionnaire, draws, ball)](const Answers& answers,
                                                             const RampJudgement&) {
        return readUntilted(plan, answers).good();
    };
}

PartCheck addSlopes(Questionnaire& questionnaire, Draws& draws, const Ball& ball) {
    return [plan = planSlopes(questionnaire, draws, ball)](const Answers& answers,
                                                           const RampJudgement& ramps) {
        const SlopeAgreement seen =
            readSlopes(plan, answers, ramps.fit->parametrisation, *ramps.response);
        return seen.good() && seen.smallAgrees();
    };
}

PartCheck addStripes(Questionnaire& questionnaire, Draws& draws, const Ball& ball) {
    return [plan = planStripes(questionnaire, draws, ball)](const Answers& answers,
                                                            const RampJudgement& ramps) {
        return readStripes(plan, answers, ramps).good();
    };
}

/// The parts with the fewest points first.
constexpr std::array<AddPart, 9> kParts{addOrder,    addSharpSteps, addProportion,
                                        addEdges,    addCaps,       addFewTexels,
                                        addUntilted, addSlopes,     addStripes};

struct ScreenPlan {
    Questionnaire questionnaire;
    RampPlan ramps;
    PartCheck part;  ///< null: ramps alone
};

/// Like the examination's gentle ramps, a third as long.
ScreenPlan planScreen(std::uint64_t seed, AddPart addPart = nullptr) {
    constexpr int kPoints = 64;
    constexpr RampShape kShape{.columns = 720, .rows = 530, .across = 40, .rise = 0.035};
    Draws draws(seed + 0x5C4EE4U);
    ScreenPlan plan{Questionnaire(seed + 0x5C4EE4U), {}, nullptr};
    const Ball ball{{draws.uniform(-2.0, -0.7), draws.uniform(0.3, 1.5), 25.0},
                    draws.uniform(13.0, 15.0)};
    plan.ramps = planRamps(plan.questionnaire, ball, kShape, draws.directions(kPoints));
    if (addPart != nullptr) plan.part = addPart(plan.questionnaire, draws, ball);
    return plan;
}

bool mayPass(const ScreenPlan& plan, const probe::Run& run) {
    const Answers answers(plan.questionnaire, run);
    const RampJudgement ramps = judgeRamps(plan.ramps.shape, readRamps(plan.ramps, answers));
    return ramps.kind == RampKind::right && (!plan.part || plan.part(answers, ramps));
}

Screening screeningOf(ScreenPlan drawn) {
    const auto plan = std::make_shared<const ScreenPlan>(std::move(drawn));
    return {plan->questionnaire.questions(),
            [plan](const probe::Run& run) { return mayPass(*plan, run); }};
}

}  // namespace

Screening screenBump(std::uint64_t seed) {
    return screeningOf(planScreen(seed));
}

std::vector<Screening> screenBumpElsewhere(std::uint64_t seed) {
    std::vector<Screening> all;
    for (const AddPart part : kParts)
        all.push_back(screeningOf(planScreen(seed, part)));
    return all;
}

}  // namespace ticker::tasks
