#include <grader/decision/bump/Examination.h>

#include <grader/decision/bump/Numbers.h>

#include <algorithm>
#include <cstddef>
#include <tuple>
#include <utility>

namespace ticker::decision::bump {
namespace {

// Gentle ramps are so low beside the sphere's radius that the exact normal of the displaced surface
// is as good as in proportion to the slope.
constexpr double kGentleRise = 0.1;
constexpr double kModerateRise = 1.0;
constexpr double kSteepRise = 5.0;

/// Sides that no submission can know.
RampShape drawShape(Draws& draws, double rise) {
    return {draws.integer(1510, 1590), draws.integer(88, 112), rise};
}

Ball drawBall(Draws& draws) {
    const double side = draws.uniform(0.0, 1.0) < 0.5 ? -1.0 : 1.0;
    return {{side * draws.uniform(0.7, 2.0), draws.uniform(-1.5, 1.5), draws.uniform(20.0, 30.0)},
            draws.uniform(8.0, 16.0)};
}

double strongest(const std::vector<RampTilts>& tilts) {
    const RampStrength middle = strength(tilts);
    return std::max(middle.alongU, middle.alongV);
}

/// Both ramps, the steep one against the gentle one: do tilts grow, and keep their direction?
void compareRamps(const std::vector<RampTilts>& gentle, const std::vector<RampTilts>& steep,
                  Examination& examination) {
    // The displaced surface's exact normal: 30; in proportion: 50, and 5 beyond a moderate ramp.
    constexpr double kGrows = 2.0;
    constexpr double kAgree = 0.95;
    std::vector<double> growth;
    double agreeing = 0.0;
    const RampStrength least = strength(gentle);
    const std::size_t count = std::min(gentle.size(), steep.size());
    for (std::size_t i = 0; i < count; ++i)
        for (const auto& [a, b, usual] :
             {std::tuple(gentle[i].onURamp, steep[i].onURamp, least.alongU),
              std::tuple(gentle[i].onVRamp, steep[i].onVRamp, least.alongV)}) {
            const double product = a.dot(b);
            if (a.magnitude() > 0.1 * usual) growth.push_back(product / a.dot(a));
            if (product >= 0.7 * a.magnitude() * b.magnitude()) agreeing += 1.0;
        }
    examination.growsWithSlope = median(growth) >= kGrows;
    examination.steepAgrees = agreeing >= kAgree * 2.0 * static_cast<double>(count);
}

/// Takes the ramps that tell most: gentle ones unless they tilt so little that rounding shows.
void judgeAllRamps(const MainPlan& plan, const Answers& answers, Examination& examination) {
    // Single precision leaves 1e-7 in a normal, and 1e-5 where the normal is that of chords over a
    // texel: far below either limit.
    constexpr double kClear = 5e-6;
    constexpr double kClearOfChords = 2e-3;
    const std::vector<RampTilts> steep = readRamps(plan.steep, answers);
    std::vector<RampTilts> low = readRamps(plan.gentle, answers);
    examination.ramps = judgeRamps(low);
    if (!(strongest(low) > kClearOfChords)) {
        std::vector<RampTilts> moderate = readRamps(plan.moderate, answers);
        const bool tells = strongest(low) > kClear && examination.ramps.response;
        RampJudgement judgement = judgeRamps(moderate);
        // Axes exchanged on these long maps tilt a displaced surface little, however high it is:
        // then only gentle ramps are in proportion.
        if (judgement.response || !tells) {
            examination.ramps = std::move(judgement);
            low = std::move(moderate);
        }
    }
    if (strongest(low) > kClear)
        compareRamps(low, steep, examination);
    else
        examination.ramps = judgeRamps(steep);
}

double middleTilt(const std::vector<Vector3>& tilts) {
    std::vector<double> lengths;
    lengths.reserve(tilts.size());
    for (const Vector3& tilt : tilts)
        lengths.push_back(tilt.magnitude());
    return median(lengths);
}

}  // namespace

MainPlan planMain(std::uint64_t seed) {
    constexpr int kGentlePoints = 1000;
    constexpr int kSteepPoints = 500;
    Draws draws(seed);
    MainPlan plan;
    const Ball ball = drawBall(draws);
    std::vector<Vector3> directions = draws.directions(kGentlePoints);
    plan.gentle = planRamps(plan.questionnaire, ball, drawShape(draws, kGentleRise), directions);
    const RampShape moderate{plan.gentle.shape.along, plan.gentle.shape.across, kModerateRise};
    plan.moderate = planRamps(plan.questionnaire, ball, moderate, directions);
    directions.resize(kSteepPoints);
    plan.steep = planRamps(plan.questionnaire, ball, drawShape(draws, kSteepRise), directions);
    plan.slopes = planSlopes(plan.questionnaire, draws, drawBall(draws));
    plan.letters = planLetters(plan.questionnaire, draws);
    plan.conduct = planConduct(plan.questionnaire, draws);
    return plan;
}

HintPlan planHints(std::uint64_t seed) {
    constexpr int kPoints = 500;
    Draws draws(seed + 0x5151U);
    HintPlan plan;
    const int side = draws.integer(380, 430);
    const std::vector<Vector3> directions = draws.directions(kPoints);
    // All maps of one size, so that code which remembers a size does well; lower ramps on smaller
    // spheres.
    plan.square =
        planRamps(plan.questionnaire, drawBall(draws), {side, side, kGentleRise}, directions);
    plan.unitSphere =
        planRamps(plan.questionnaire, {{}, 1.0}, {side, side, 0.2 * kGentleRise}, directions);
    plan.sceneSphere = planRamps(plan.questionnaire, {{0.0, 0.0, 3.5}, 0.7},
                                 {side, side, 0.1 * kGentleRise}, directions);
    return plan;
}

Examination examine(const MainPlan& plan, const Answers& answers) {
    Examination examination;
    examination.conduct = readConduct(plan.conduct, answers);
    judgeAllRamps(plan, answers, examination);
    for (const std::size_t flat :
         {plan.gentle.uFlat, plan.gentle.vFlat, plan.steep.uFlat, plan.steep.vFlat})
        examination.flatTilt = std::max(examination.flatTilt, middleTilt(answers.tilts(flat)));
    if (!examination.ramps.response) return examination;
    const Landing& landing = examination.ramps.fit->landing;
    examination.slopes = readSlopes(plan.slopes, answers, landing, *examination.ramps.response);
    examination.letters = readLetters(plan.letters, answers, landing, *examination.ramps.response);
    return examination;
}

Hints readHints(const HintPlan& plan, const Answers& answers) {
    return {judgeRamps(readRamps(plan.square, answers)),
            judgeRamps(readRamps(plan.unitSphere, answers)),
            judgeRamps(readRamps(plan.sceneSphere, answers))};
}

}  // namespace ticker::decision::bump
