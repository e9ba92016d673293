#include <grader/tasks/bump/Examination.h>

#include <algorithm>
#include <vector>

namespace ticker::tasks::bump {
namespace {

/// Draws a sphere whose centre lies off every coordinate plane through the eye. It is so large that
/// its far side is about four times as far away as its near side.
/// @param side  1: in front of the eye; -1: behind it.
Ball drawBall(Draws& draws, double side) {
    const double distance = draws.uniform(20.0, 30.0);
    return {{-side * draws.uniform(0.7, 2.0), side * draws.uniform(0.3, 1.5), side * distance},
            distance * draws.uniform(0.55, 0.65)};
}

/// Draws a sphere behind the eye that lies to one side and below by more than its radius, so that
/// longitude and polar angle are wrong at all points if x or y of the centre are left out.
Ball drawBallAside(Draws& draws) {
    constexpr double kLeast = 1.2;
    constexpr double kMost = 2.0;
    const double distance = draws.uniform(20.0, 30.0);
    const double right = draws.uniform(kLeast, kMost);
    const double down = draws.uniform(kLeast, kMost);
    const double radius = distance * draws.uniform(0.55, 0.65);
    return {{right * radius, -down * radius, -distance}, radius};
}

/// Heights that are flat except in the last two fifths. There they are teeth, steep enough to show
/// even in code that rounds heights or tilts little.
std::vector<double> lateTeeth(int count) {
    constexpr int kToothSlope = 8;
    std::vector<double> heights(static_cast<std::size_t>(count), 0.0);
    for (int i = count * 3 / 5; i < count; ++i)
        heights[static_cast<std::size_t>(i)] = kByte * (i * kToothSlope % 256);
    return heights;
}

/// Whether the slopes at the map's end tilt any normal.
bool seesSlope(const Answers& answers, std::size_t flat, std::size_t question) {
    constexpr double kSomeTilt = 2e-5;  // single precision leaves half of it
    constexpr double kSomePoints = 0.02;
    double seen = 0.0;
    const std::vector<Vector3> tilts = answers.tiltsBeyond(flat, question);
    for (const Vector3& tilt : tilts)
        if (tilt.magnitude() > kSomeTilt) seen += 1.0;
    return seen > kSomePoints * static_cast<double>(tilts.size());
}

/// True if ramps of whole bytes show the parametrisation, or if they tilt anything at all while
/// most points of the first ramps are not tilted.
bool tellsMore(const RampJudgement& coarse, const RampJudgement& ramps) {
    constexpr double kNothing = 1e-13;
    const bool mostlyLevel = !(std::max(ramps.strength.alongU, ramps.strength.alongV) > kNothing);
    return coarse.response || (mostlyLevel && coarse.kind != RampKind::silent);
}

}  // namespace

MainPlan planMain(std::uint64_t seed) {
    constexpr int kPoints = 1000;
    constexpr int kOrderedPoints = 300;
    Draws draws(seed);
    MainPlan plan;
    plan.questionnaire = Questionnaire(seed);
    const Ball ball = drawBall(draws, 1.0);
    const std::vector<Vector3> directions = draws.directions(kPoints);
    plan.regions = planRegions(plan.questionnaire, draws, ball, directions);
    plan.ladder = planLadder(plan.questionnaire, draws, ball, directions);
    plan.slopes = planSlopes(plan.questionnaire, draws, drawBallAside(draws));
    plan.letters = planLetters(plan.questionnaire, draws);
    plan.conduct = planConduct(plan.questionnaire, draws);
    plan.fineness = planFineness(plan.questionnaire, draws, drawBall(draws, 1.0));
    plan.proportion = planProportion(plan.questionnaire, draws, drawBall(draws, 1.0));
    plan.edges = planEdges(plan.questionnaire, draws, drawBall(draws, -1.0));
    plan.stripes = planStripes(plan.questionnaire, draws, drawBall(draws, 1.0));
    plan.untilted = planUntilted(plan.questionnaire, draws, drawBall(draws, 1.0));
    const std::size_t atRim = plan.untilted.at(Whereabouts::atRim).map;
    plan.elsewhere = planElsewhere(plan.questionnaire, atRim);
    plan.caps = planCaps(plan.questionnaire, draws, drawBall(draws, 1.0));
    plan.fewTexels = planFewTexels(plan.questionnaire, draws, drawBall(draws, 1.0));
    plan.sharpSteps = planSharpSteps(plan.questionnaire, draws, drawBall(draws, 1.0));
    // The map has so few rows that many points lie in the last one.
    plan.order = plan.questionnaire.addInBothOrders(drawBall(draws, 1.0), noiseMap(draws, 12, 6),
                                                    draws.directions(kOrderedPoints));
    plan.evenSteps = planEvenSteps(plan.questionnaire, draws, drawBall(draws, 1.0));
    plan.lightSteps = planSharpSteps(plan.questionnaire, draws, drawBall(draws, 1.0), kLightSteps);
    plan.belts = planBelts(plan.questionnaire, draws, drawBall(draws, 1.0));
    plan.ownTexels = planOwnTexels(plan.questionnaire, draws, drawBall(draws, 1.0));
    plan.conduct.rough = {plan.proportion.steep, plan.elsewhere.there};
    for (const LevelPair& pair :
         {plan.caps.columns, plan.caps.rows, plan.fewTexels.columns, plan.fewTexels.rows,
          plan.sharpSteps.grey, plan.sharpSteps.higher, plan.slopes.smallField,
          plan.lightSteps.grey, plan.lightSteps.higher, plan.ownTexels.noise}) {
        plan.conduct.rough.push_back(pair.flat);
        plan.conduct.rough.push_back(pair.map);
    }
    for (const std::size_t map : {plan.fewTexels.columnRidges, plan.fewTexels.rowRidges,
                                  plan.order.forwards, plan.order.backwards})
        plan.conduct.rough.push_back(map);
    for (const LevelPair& pair : plan.untilted.pairs)
        plan.conduct.rough.push_back(pair.map);
    return plan;
}

CoarsePlan planCoarse(std::uint64_t seed) {
    Draws draws(seed + 0xC0A5EU);
    return planCoarse(draws, drawBall(draws, 1.0));
}

HintPlan planHints(std::uint64_t seed) {
    constexpr int kPoints = 500;
    constexpr double kRise = 0.1;
    constexpr double kBase = 2.0;
    Draws draws(seed + 0x5151U);
    HintPlan plan;
    plan.questionnaire = Questionnaire(seed + 0x5151U);
    const int side = draws.integer(380, 430);
    const std::vector<Vector3> directions = draws.directions(kPoints);
    const auto ask = [&](const Ball& ball, double rise) {
        return planRamps(plan.questionnaire, ball, {side, side, side, rise, kBase}, directions);
    };
    // All maps have one size, so that code that remembers a size is right here. Smaller spheres get
    // lower ramps.
    const Ball ball = drawBall(draws, 1.0);
    plan.square = ask(ball, kRise);
    plan.unitSphere = ask({{}, 1.0}, 0.2 * kRise);
    plan.sceneSphere = ask({{0.0, 0.0, 3.5}, 0.7}, 0.1 * kRise);
    const std::vector<double> late = lateTeeth(side);
    const std::vector<double> level = raytracer::questions::level(side);
    plan.lastColumns = plan.questionnaire.add(ball, {side, side, {}, late, level}, directions);
    plan.lastRows = plan.questionnaire.add(ball, {side, side, {}, level, late}, directions);
    plan.order = plan.questionnaire.addInBothOrders(ball, {side, side, {}, late, late}, directions);
    plan.asideSphere = ask(drawBallAside(draws), kRise);
    return plan;
}

bool Examination::agreesWithRamps() const {
    constexpr double kAlmostAll = 0.95;
    return ladder.steepAgrees >= kAlmostAll && regions && regions->good() && slopes &&
           slopes->good();
}

Examination examine(const MainPlan& plan, const Answers& answers,
                    const std::optional<RampJudgement>& coarse) {
    Examination examination;
    examination.conduct = readConduct(plan.conduct, answers);
    examination.mapIgnored = areTheSame(answers, plan.regions.question, plan.ladder.gentle.uFlat);
    examination.ladder = judgeLadder(plan.ladder, answers);
    // The ramps with fractional heights then show nothing but rounding.
    if (coarse && tellsMore(*coarse, examination.ramps()))
        examination.ladder = {*coarse, examination.ladder.flatTilt,
                              examination.ladder.sharedNormals};
    examination.changedByOrder = answers.shareThatOrderChanges(plan.order);
    examination.proportion = readProportion(plan.proportion, answers);
    examination.untilted = readUntilted(plan.untilted, answers);
    examination.elsewhere = readElsewhere(plan.elsewhere, answers);
    examination.sharpSteps = std::max(readSharpSteps(plan.sharpSteps, answers),
                                      readSharpSteps(plan.lightSteps, answers), turnsFewer);
    const RampJudgement& ramps = examination.ramps();
    if (!ramps.response) return examination;
    const Parametrisation& parametrisation = ramps.fit->parametrisation;
    examination.regions = readRegions(plan.regions, answers, ramps);
    examination.slopes = readSlopes(plan.slopes, answers, parametrisation, *ramps.response);
    examination.edges = readEdges(plan.edges, answers, parametrisation);
    examination.letters = readLetters(plan.letters, answers, parametrisation, *ramps.response);
    examination.fineness = readFineness(plan.fineness, answers, ramps);
    examination.balance = readBalance(plan.proportion, answers, ramps);
    examination.stripes = readStripes(plan.stripes, answers, ramps);
    examination.caps = readCaps(plan.caps, answers, parametrisation);
    examination.fewTexels = readFewTexels(plan.fewTexels, answers, parametrisation);
    examination.evenSteps = readEvenSteps(plan.evenSteps, answers, parametrisation);
    examination.belts = readBelts(plan.belts, answers, parametrisation, *ramps.response);
    examination.ownTexels =
        readOwnTexels(plan.ownTexels, answers, parametrisation, *ramps.response);
    return examination;
}

Hints readHints(const HintPlan& plan, const Answers& answers) {
    constexpr double kSomeOfAllPoints = 0.02;
    const auto judge = [&](const RampPlan& ramps) {
        return judgeRamps(ramps.shape, readRamps(ramps, answers));
    };
    return {judge(plan.square),
            judge(plan.unitSphere),
            judge(plan.sceneSphere),
            judge(plan.asideSphere),
            seesSlope(answers, plan.square.uFlat, plan.lastColumns),
            seesSlope(answers, plan.square.vFlat, plan.lastRows),
            answers.shareThatOrderChanges(plan.order) > kSomeOfAllPoints};
}

}  // namespace ticker::tasks::bump
